#include "sim/MildSlopeField.h"

#include "sim/Angles.h"
#include "sim/Dispersion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace swellray
{

namespace
{

// Nodes along an axis of the interpolation.
constexpr std::size_t MostPoints = 6;

// A place this share of an element outside of the scene lies on its edge.
constexpr double OnEdge = 1e-6;

// Rows of a map that one piece of work covers are the loop's affair; of places so many are one.
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

// Weights of n nodes at 0, 1, ... n - 1 for the value and the slope of their polynomial at u.
struct Weights
{
  std::array<double, MostPoints> value{};
  std::array<double, MostPoints> slope{};

  Weights(std::size_t n, double u)
  {
    for (std::size_t a = 0; a < n; ++a)
    {
      double product = 1.0;
      double derivative = 0.0;
      for (std::size_t b = 0; b < n; ++b)
      {
        if (b != a)
        {
          const double way = static_cast<double>(a) - static_cast<double>(b);
          derivative = (derivative * (u - static_cast<double>(b)) + product) / way;
          product *= (u - static_cast<double>(b)) / way;
        }
      }
      this->value[a] = product;
      this->slope[a] = derivative;
    }
  }
};

}

void MildSlopeField::Data::prepare()
{
  const std::size_t columns = this->mesh.sceneColumns();
  const std::size_t rows = this->mesh.sceneRows();
  const std::size_t along = columns + 1;
  this->dry.assign(along * (rows + 1), 0);
  for (std::size_t j = 0; j < rows; ++j)
  {
    for (std::size_t i = 0; i < columns; ++i)
    {
      const std::uint32_t here = this->mesh.medium(i, j).kind != MildSlopeMesh::Kind::Water ? 1 : 0;
      this->dry[(j + 1) * along + i + 1] =
        here + this->dry[j * along + i + 1] + this->dry[(j + 1) * along + i] - this->dry[j * along + i];
    }
  }
}

bool MildSlopeField::Data::allWater(std::size_t i, std::size_t j, std::size_t columns, std::size_t rows) const
{
  const std::size_t along = this->mesh.sceneColumns() + 1;
  return this->dry[(j + rows) * along + i + columns] + this->dry[j * along + i] ==
    this->dry[j * along + i + columns] + this->dry[(j + rows) * along + i];
}

bool MildSlopeField::Data::surfaceAt(const glm::dvec2& place, Surface& surface) const
{
  const glm::dvec2 local = (place - this->mesh.origin()) / this->mesh.spacing();
  const std::size_t columns = this->mesh.sceneColumns();
  const std::size_t rows = this->mesh.sceneRows();
  const bool inside = local.x >= -OnEdge && local.y >= -OnEdge && local.x <= static_cast<double>(columns) + OnEdge &&
    local.y <= static_cast<double>(rows) + OnEdge;
  if (!inside)
  {
    return false;
  }
  const auto elementOf = [](double u, std::size_t count)
  { return std::min(static_cast<std::size_t>(std::max(u, 0.0)), count - 1); };
  const std::size_t i = elementOf(local.x, columns);
  const std::size_t j = elementOf(local.y, rows);
  if (this->mesh.medium(i, j).kind != MildSlopeMesh::Kind::Water)
  {
    return false;
  }

  // The largest block of elements in water around this one, as much in their middle as can be.
  std::size_t points = 2;
  std::size_t firstI = i;
  std::size_t firstJ = j;
  for (std::size_t n = std::min({ MostPoints, columns + 1, rows + 1 }); n > 2; --n)
  {
    const std::size_t reach = n - 2;
    double nearest = std::numeric_limits<double>::infinity();
    const double middle = 0.5 * static_cast<double>(n - 1);
    for (std::size_t b = j > reach ? j - reach : 0; b <= j && b + n - 1 <= rows; ++b)
    {
      for (std::size_t a = i > reach ? i - reach : 0; a <= i && a + n - 1 <= columns; ++a)
      {
        const double away =
          std::abs(local.x - static_cast<double>(a) - middle) + std::abs(local.y - static_cast<double>(b) - middle);
        if (away < nearest && this->allWater(a, b, n - 1, n - 1))
        {
          nearest = away;
          firstI = a;
          firstJ = b;
          points = n;
        }
      }
    }
    if (points > 2)
    {
      break;
    }
  }
  const Weights x(points, local.x - static_cast<double>(firstI));
  const Weights y(points, local.y - static_cast<double>(firstJ));
  surface = {};
  for (std::size_t b = 0; b < points; ++b)
  {
    for (std::size_t a = 0; a < points; ++a)
    {
      const std::complex<double> value = this->eta[this->mesh.node(firstI + a, firstJ + b)];
      surface.eta += x.value[a] * y.value[b] * value;
      surface.dx += x.slope[a] * y.value[b] * value;
      surface.dy += x.value[a] * y.slope[b] * value;
    }
  }
  surface.dx /= this->mesh.spacing().x;
  surface.dy /= this->mesh.spacing().y;
  surface.element = j * columns + i;
  return true;
}

MildSlopeMesh::Medium MildSlopeField::Data::mediumAt(const glm::dvec2& place, std::size_t element) const
{
  const std::size_t columns = this->mesh.sceneColumns();
  const glm::dvec2 local = (place - this->mesh.origin()) / this->mesh.spacing() - 0.5;
  const glm::dvec2 low(std::floor(local.x), std::floor(local.y));
  MildSlopeMesh::Medium sum;
  sum.factor = 0.0;
  double weights = 0.0;
  for (const double b : { 0.0, 1.0 })
  {
    for (const double a : { 0.0, 1.0 })
    {
      const auto i = std::clamp(low.x + a, 0.0, static_cast<double>(columns - 1));
      const auto j = std::clamp(low.y + b, 0.0, static_cast<double>(this->mesh.sceneRows() - 1));
      const MildSlopeMesh::Medium& medium = this->mesh.medium(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
      if (medium.kind == MildSlopeMesh::Kind::Water)
      {
        const double weight = (1.0 - std::abs(local.x - low.x - a)) * (1.0 - std::abs(local.y - low.y - b));
        weights += weight;
        sum.depth += weight * medium.depth;
        sum.flux += weight * medium.flux;
        sum.stiffness += weight * medium.stiffness;
        sum.factor += weight * medium.factor;
      }
    }
  }
  if (!(weights > 0.0))
  {
    return this->mesh.media()[element];
  }
  sum.depth /= weights;
  sum.flux /= weights;
  sum.stiffness /= weights;
  sum.factor /= weights;
  return sum;
}

void MildSlopeField::Data::wavesAt(const glm::dvec2& place, std::size_t index, MildSlopeWaves& waves) const
{
  Surface surface;
  if (!this->surfaceAt(place, surface))
  {
    return;
  }
  const MildSlopeMesh::Medium medium = this->mediumAt(place, surface.element);
  waves.height[index] = this->feedback.cap(medium, 2.0 * std::abs(surface.eta));
  waves.phase[index] = std::arg(surface.eta);
  const double x = std::imag(std::conj(surface.eta) * surface.dx);
  const double y = std::imag(std::conj(surface.eta) * surface.dy);
  waves.directionFrom[index] = nauticalFromVector({ x, y });
  waves.wavelength[index] = wavelengthOf(medium.wavenumber());
  const auto& broken = this->feedback.breaking();
  waves.breaking[index] = broken.empty() ? 0 : broken[surface.element];
}

MildSlopeField::MildSlopeField() = default;
MildSlopeField::~MildSlopeField() = default;
MildSlopeField::MildSlopeField(MildSlopeField&&) noexcept = default;
MildSlopeField& MildSlopeField::operator=(MildSlopeField&&) noexcept = default;

namespace
{

MildSlopeWaves wavesWithout(std::size_t places)
{
  MildSlopeWaves waves;
  waves.height.assign(places, NotANumber);
  waves.phase.assign(places, NotANumber);
  waves.directionFrom.assign(places, NotANumber);
  waves.wavelength.assign(places, NotANumber);
  waves.breaking.assign(places, 0);
  return waves;
}

}

MildSlopeWaves MildSlopeField::sample(const std::vector<glm::dvec2>& places, const Execution& execution) const
{
  MildSlopeWaves waves = wavesWithout(places.size());
  execution.forRange(places.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        this->Kept->wavesAt(places[i], i, waves);
      }
    });
  return waves;
}

MildSlopeWaves MildSlopeField::sample(const MapGrid& grid, const Execution& execution) const
{
  if (grid.columns < 1 || grid.rows < 1 || !(grid.spacing.x > 0.0) || !(grid.spacing.y > 0.0))
  {
    throw std::invalid_argument("a map needs at least one node, and spacings above 0 m");
  }
  MildSlopeWaves waves = wavesWithout(grid.columns * grid.rows);
  execution.forRange(grid.rows,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t row = begin; row < end; ++row)
      {
        for (std::size_t column = 0; column < grid.columns; ++column)
        {
          this->Kept->wavesAt(
            grid.origin + grid.spacing * glm::dvec2(static_cast<double>(column), static_cast<double>(row)),
            row * grid.columns + column, waves);
        }
      }
    });
  return waves;
}

std::complex<double> MildSlopeField::surface(const glm::dvec2& place) const
{
  Data::Surface surface;
  return this->Kept->surfaceAt(place, surface) ? surface.eta : std::complex<double>(NotANumber, NotANumber);
}

}
