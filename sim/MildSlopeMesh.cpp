#include "sim/MildSlopeMesh.h"

#include "sim/Angles.h"
#include "sim/Dispersion.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace swellray
{

namespace
{

// Layers are at least this thick: elements, and share of the longest wavelength; and at most so many elements.
constexpr double FewestLayers = 10.0;
constexpr double LayerWaves = 0.6;
constexpr double MostLayers = 60.0;

// Logarithm of what is left of a wave that goes straight out through a layer and back.
constexpr double LayerDecay = 14.0;

// kappa = k h beyond which the element's coefficients are not followed: 4 nodes a wavelength.
constexpr double CoarsestPhase = 0.5 * Pi;

// Elements to each side over which the normal of a coast is found.
constexpr std::ptrdiff_t NormalReach = 2;

const double GaussPoint = 0.5 / std::sqrt(3.0);

// Mass of two nodes over its length: diagonal and off-diagonal.
struct Mass
{
  double same;
  double other;

  explicit Mass(double b)
    : same(0.5 * (1.0 - b))
    , other(0.5 * b)
  {
  }
  double at(bool equal) const { return equal ? this->same : this->other; }
};

// 1/X - 2/kappa^2 with X = 1 - cos kappa.
double axisMass(double kappa)
{
  const double q = kappa * kappa;
  // The difference of large terms loses digits below: the series of the same function.
  return q < 0.01 ? 1.0 / 6.0 + q / 120.0 + q * q / 3024.0 : 1.0 / (1.0 - std::cos(kappa)) - 2.0 / q;
}

// The mass in the stiffness for which a wave at 45 degrees has no error.
double diagonalMass(double kx, double ky, double hx, double hy, double massX, double massY)
{
  const double q = kx * ky;
  if (q < 0.01)
  {
    return 1.0 / 6.0;
  }
  const double x = 1.0 - std::cos(kx / std::sqrt(2.0));
  const double y = 1.0 - std::cos(ky / std::sqrt(2.0));
  const double squareX = 2.0 * x / (hx * hx);
  const double squareY = 2.0 * y / (hy * hy);
  const double k2 = kx * kx / (hx * hx);
  const double wanted = k2 * (1.0 - massX * x) * (1.0 - massY * y);
  return (squareX + squareY - wanted) / (squareX * y + squareY * x);
}

}

double MildSlopeMesh::Medium::linearWavenumber() const
{
  return std::sqrt(this->stiffness / this->flux);
}

double MildSlopeMesh::Medium::wavenumber() const
{
  return std::sqrt(this->factor * this->stiffness / this->flux);
}

MeshLayout layOut(const Rectangle& bounds, double spacing, double longestWave, const IncidentWave& wave, bool wallSides)
{
  MeshLayout layout;
  const glm::dvec2 size = bounds.size();
  // A length that is whole spacings but for rounding gets no element more.
  constexpr double rounding = 1e-9;
  layout.sceneColumns = static_cast<std::size_t>(std::max(2.0, std::ceil(size.x / spacing * (1.0 - rounding))));
  layout.sceneRows = static_cast<std::size_t>(std::max(2.0, std::ceil(size.y / spacing * (1.0 - rounding))));
  const auto layer =
    static_cast<std::size_t>(std::clamp(std::ceil(LayerWaves * longestWave / spacing), FewestLayers, MostLayers) + 1.0);
  layout.padding.fill(layer);
  if (wallSides)
  {
    const glm::dvec2 t = wave.direction();
    const bool alongX = std::abs(t.x) >= std::abs(t.y);
    layout.padding[static_cast<std::size_t>(alongX ? MeshSide::South : MeshSide::West)] = 0;
    layout.padding[static_cast<std::size_t>(alongX ? MeshSide::North : MeshSide::East)] = 0;
  }
  return layout;
}

MildSlopeMesh::MildSlopeMesh(const Seafloor& seafloor, double waterLevel, const IncidentWave& wave,
  const MildSlopeOptions& options, const MildSlopePlan& plan, const Execution& execution)
  : Omega(wave.angularFrequency())
  , Gravity(wave.gravity)
{
  const Rectangle bounds = seafloor.bounds();
  const MeshLayout& layout = plan.layout;
  this->SceneColumns = layout.sceneColumns;
  this->SceneRows = layout.sceneRows;
  this->Padding = layout.padding;
  this->Columns = this->SceneColumns + padding(MeshSide::West) + padding(MeshSide::East);
  this->Rows = this->SceneRows + padding(MeshSide::South) + padding(MeshSide::North);
  this->Spacing = plan.spacing;
  this->Origin = bounds.low;
  this->setMedia(seafloor, waterLevel, options, plan.minDepth, execution);

  const auto stretch = [&](std::size_t count, std::size_t low, std::size_t high, double spacing)
  {
    std::vector<Complex> values(count, 1.0);
    const double k = 2.0 * Pi / plan.longestWave;
    for (std::size_t i = 0; i < count; ++i)
    {
      // Elements into the layer, of those after the first.
      double inside = -1.0;
      double thickness = 1.0;
      if (i < low)
      {
        inside = static_cast<double>(low - 1 - i);
        thickness = static_cast<double>(low) - 1.0;
      }
      else if (i >= count - high)
      {
        inside = static_cast<double>(i - (count - high));
        thickness = static_cast<double>(high) - 1.0;
      }
      if (inside >= 1.0)
      {
        // Mean of xi^2 over the element; a such that 2 k a thickness/3 is the decay.
        const double to = inside / thickness;
        const double from = (inside - 1.0) / thickness;
        const double mean = (to * to * to - from * from * from) / (3.0 * (to - from));
        const double a = 1.5 * LayerDecay / (k * thickness * spacing);
        values[i] = Complex(1.0, a * mean);
      }
    }
    return values;
  };
  this->StretchX = stretch(this->Columns, padding(MeshSide::West), padding(MeshSide::East), this->Spacing.x);
  this->StretchY = stretch(this->Rows, padding(MeshSide::South), padding(MeshSide::North), this->Spacing.y);
  this->setUnknowns();
}

void MildSlopeMesh::setMedia(const Seafloor& seafloor, double waterLevel, const MildSlopeOptions& options,
  double minDepth, const Execution& execution)
{
  this->Media.resize(this->SceneColumns * this->SceneRows);
  execution.forRange(this->SceneRows,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t j = begin; j < end; ++j)
      {
        for (std::size_t i = 0; i < this->SceneColumns; ++i)
        {
          Medium& medium = this->medium(i, j);
          const glm::dvec2 middle = this->place(i, j) + 0.5 * this->Spacing;
          const double depth = waterLevel - seafloor.elevation(middle);
          const bool water = depth >= minDepth && !seafloor.isHole(middle);
          const std::optional<double> wall =
            options.wall ? options.wall({ this->place(i, j), this->place(i + 1, j + 1) }) : std::nullopt;
          const double reflection = wall.value_or(options.coastReflection);
          medium.kind = wall ? Kind::Wall : (water ? Kind::Water : Kind::Coast);
          medium.admittance = (1.0 - reflection) / (1.0 + reflection);
          // Means of the coefficients, by the formula of Gauss with 2 x 2 points.
          for (const double y : { -GaussPoint, GaussPoint })
          {
            for (const double x : { -GaussPoint, GaussPoint })
            {
              const double here = waterLevel - seafloor.elevation(middle + this->Spacing * glm::dvec2(x, y));
              const double h = here > minDepth ? here : minDepth;
              const double k = solveWavenumber(this->Omega, h, this->Gravity);
              const WaveSpeeds speeds = waveSpeeds(k, h, this->Gravity);
              const double flux = speeds.phaseSpeed * speeds.groupSpeed;
              medium.depth += 0.25 * h;
              medium.flux += 0.25 * flux;
              medium.stiffness += 0.25 * k * k * flux;
            }
          }
        }
      }
    });
}

std::size_t MildSlopeMesh::sceneColumn(std::size_t i) const
{
  const std::size_t low = padding(MeshSide::West);
  return i < low ? 0 : std::min(i - low, this->SceneColumns - 1);
}

std::size_t MildSlopeMesh::sceneRow(std::size_t j) const
{
  const std::size_t low = padding(MeshSide::South);
  return j < low ? 0 : std::min(j - low, this->SceneRows - 1);
}

void MildSlopeMesh::setUnknowns()
{
  const std::size_t along = this->Columns + 1;
  this->Unknown.assign(along * (this->Rows + 1), 0);
  for (std::size_t j = 0; j < this->Rows; ++j)
  {
    for (std::size_t i = 0; i < this->Columns; ++i)
    {
      if (medium(this->sceneColumn(i), this->sceneRow(j)).kind == Kind::Water)
      {
        for (const std::size_t node : { j * along + i, (j + 1) * along + i })
        {
          this->Unknown[node] = 1;
          this->Unknown[node + 1] = 1;
        }
      }
    }
  }
  // Nothing is left of a wave at the outer edge of a layer.
  for (std::size_t j = 0; j <= this->Rows; ++j)
  {
    for (std::size_t i = 0; i <= this->Columns; ++i)
    {
      const bool outer = (i == 0 && isOpen(MeshSide::West)) || (i == this->Columns && isOpen(MeshSide::East)) ||
        (j == 0 && isOpen(MeshSide::South)) || (j == this->Rows && isOpen(MeshSide::North));
      if (outer)
      {
        this->Unknown[j * along + i] = 0;
      }
    }
  }
}

MildSlopeMesh::Kind MildSlopeMesh::kindAt(std::ptrdiff_t i, std::ptrdiff_t j) const
{
  const auto column = std::clamp<std::ptrdiff_t>(i, 0, static_cast<std::ptrdiff_t>(this->SceneColumns) - 1);
  const auto row = std::clamp<std::ptrdiff_t>(j, 0, static_cast<std::ptrdiff_t>(this->SceneRows) - 1);
  return medium(static_cast<std::size_t>(column), static_cast<std::size_t>(row)).kind;
}

double MildSlopeMesh::coastShare(std::size_t i, std::size_t j) const
{
  // A slanting coast is a flight of steps whose length is |nx| + |ny| times its own.
  glm::dvec2 normal(0.0);
  for (std::ptrdiff_t dy = -NormalReach; dy <= NormalReach; ++dy)
  {
    for (std::ptrdiff_t dx = -NormalReach; dx <= NormalReach; ++dx)
    {
      if (kindAt(static_cast<std::ptrdiff_t>(i) + dx, static_cast<std::ptrdiff_t>(j) + dy) != Kind::Water)
      {
        normal += glm::dvec2(static_cast<double>(dx), static_cast<double>(dy));
      }
    }
  }
  const double length = glm::length(normal);
  return length > 0.0 ? length / (std::abs(normal.x) + std::abs(normal.y)) : 1.0;
}

void MildSlopeMesh::element(std::size_t i, std::size_t j, NestedDissection::Element& values) const
{
  values.fill(0.0);
  const std::size_t column = this->sceneColumn(i);
  const std::size_t row = this->sceneRow(j);
  const Medium& here = medium(column, row);
  if (here.kind != Kind::Water)
  {
    return;
  }
  const double hx = this->Spacing.x;
  const double hy = this->Spacing.y;
  const Complex sx = this->StretchX[i];
  const Complex sy = this->StretchY[j];
  const double k = here.wavenumber();
  const double kx = std::min(k * hx, CoarsestPhase);
  const double ky = std::min(k * hy, CoarsestPhase);
  const double bx = axisMass(kx);
  const double by = axisMass(ky);
  const Mass massX(bx);
  const Mass massY(by);
  const Mass mass(diagonalMass(kx, ky, hx, hy, bx, by));
  const double half = 0.5 * std::sqrt(kx * ky);
  const double impedance = half > 0.0 ? std::tan(half) / half : 1.0;
  const Complex alongX = impedance * here.flux * sy / sx * (hy / hx);
  const Complex alongY = impedance * here.flux * sx / sy * (hx / hy);
  const Complex spring =
    impedance * Complex(here.factor * here.stiffness, this->Omega * here.loss) * sx * sy * (hx * hy);
  for (std::size_t a = 0; a < 4; ++a)
  {
    for (std::size_t b = 0; b < 4; ++b)
    {
      const bool sameX = a % 2 == b % 2;
      const bool sameY = a / 2 == b / 2;
      values[4 * a + b] = alongX * (sameX ? 1.0 : -1.0) * mass.at(sameY) +
        alongY * (sameY ? 1.0 : -1.0) * mass.at(sameX) - spring * massX.at(sameX) * massY.at(sameY);
    }
  }

  // Sides at which there is no water any more.
  struct Face
  {
    std::ptrdiff_t dx;
    std::ptrdiff_t dy;
    std::size_t first; // nodes of the element
    std::size_t second;
  };
  constexpr std::array<Face, 4> faces{ Face{ -1, 0, 0, 2 }, Face{ 1, 0, 1, 3 }, Face{ 0, -1, 0, 1 },
    Face{ 0, 1, 2, 3 } };
  for (const Face& face : faces)
  {
    const std::ptrdiff_t ni = static_cast<std::ptrdiff_t>(i) + face.dx;
    const std::ptrdiff_t nj = static_cast<std::ptrdiff_t>(j) + face.dy;
    if (ni < 0 || nj < 0 || ni >= static_cast<std::ptrdiff_t>(this->Columns) ||
      nj >= static_cast<std::ptrdiff_t>(this->Rows))
    {
      continue;
    }
    const Medium& beyond =
      medium(this->sceneColumn(static_cast<std::size_t>(ni)), this->sceneRow(static_cast<std::size_t>(nj)));
    const double admittance = beyond.admittance;
    if (beyond.kind == Kind::Water || !(admittance > 0.0))
    {
      continue;
    }
    const bool upright = face.dx != 0;
    const Complex length = upright ? sy * hy : sx * hx;
    const Mass& along = upright ? massY : massX;
    const Complex value = Complex(0.0, -k * here.flux * admittance * this->coastShare(column, row)) * length;
    values[4 * face.first + face.first] += value * along.same;
    values[4 * face.second + face.second] += value * along.same;
    values[4 * face.first + face.second] += value * along.other;
    values[4 * face.second + face.first] += value * along.other;
  }
}

}
