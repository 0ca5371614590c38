#include "sim/MildSlopeIncident.h"

#include "sim/Angles.h"
#include "sim/BreakingMarch.h"
#include "sim/Dispersion.h"
#include "sim/LaunchLine.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace swellray
{

namespace
{

// Cosine of the angle to a side's normal above which a wave that comes in has not been over the scene before.
constexpr double Straight = 0.5;

glm::dvec2 inwardOf(MeshSide side)
{
  switch (side)
  {
  case MeshSide::West:
    return { 1.0, 0.0 };
  case MeshSide::East:
    return { -1.0, 0.0 };
  case MeshSide::South:
    return { 0.0, 1.0 };
  default:
    return { 0.0, -1.0 };
  }
}

}

MildSlopeIncident::MildSlopeIncident(const Seafloor& seafloor, double waterLevel, const IncidentWave& wave,
  const MildSlopeOptions& options, double minDepth, const MildSlopeMesh& mesh)
  : Mesh(&mesh)
  , Nodes((mesh.sceneColumns() + 1) * (mesh.sceneRows() + 1))
{
  const LaunchLine line(seafloor, waterLevel, wave, minDepth, { options.edge, options.shoreNormal });
  // From the corner that the wave meets first around the scene to the one across, both ways.
  const glm::dvec2 t = wave.direction();
  const bool fromEast = t.x < 0.0;
  const bool fromNorth = t.y < 0.0;
  const std::size_t columns = mesh.sceneColumns();
  const std::size_t rows = mesh.sceneRows();
  const auto alongX = [&](std::vector<Stop>& stops, bool north)
  {
    for (std::size_t i = 0; i <= columns; ++i)
    {
      stops.push_back({ fromEast ? columns - i : i, north ? rows : 0, north ? MeshSide::North : MeshSide::South });
    }
  };
  const auto alongY = [&](std::vector<Stop>& stops, bool east)
  {
    for (std::size_t j = 0; j <= rows; ++j)
    {
      stops.push_back({ east ? columns : 0, fromNorth ? rows - j : j, east ? MeshSide::East : MeshSide::West });
    }
  };
  std::vector<Stop> first;
  std::vector<Stop> second;
  alongX(first, fromNorth);
  alongY(first, !fromEast);
  alongY(second, fromEast);
  alongX(second, !fromNorth);
  this->walk(first, seafloor, waterLevel, wave, options, minDepth, line);
  this->walk(second, seafloor, waterLevel, wave, options, minDepth, line);
}

bool MildSlopeIncident::isShadowed(const Stop& stop, const glm::dvec2& direction) const
{
  // Back along the wave, half an element at a time, until out of the scene.
  const MildSlopeMesh& mesh = *this->Mesh;
  const auto columns = static_cast<double>(mesh.sceneColumns());
  const auto rows = static_cast<double>(mesh.sceneRows());
  const glm::dvec2 step = -0.5 * direction * std::min(mesh.spacing().x, mesh.spacing().y) / mesh.spacing();
  // From the middle of the outermost elements: a wave along a side must not leave it at once.
  const glm::dvec2 start(std::clamp(static_cast<double>(stop.i), 0.5, columns - 0.5),
    std::clamp(static_cast<double>(stop.j), 0.5, rows - 0.5));
  for (glm::dvec2 p = start; p.x >= 0.0 && p.y >= 0.0 && p.x < columns && p.y < rows; p += step)
  {
    if (mesh.medium(static_cast<std::size_t>(p.x), static_cast<std::size_t>(p.y)).kind != MildSlopeMesh::Kind::Water)
    {
      return true;
    }
  }
  return false;
}

void MildSlopeIncident::walk(const std::vector<Stop>& stops, const Seafloor& seafloor, double waterLevel,
  const IncidentWave& wave, const MildSlopeOptions& options, double minDepth, const LaunchLine& line)
{
  const glm::dvec2 t0 = wave.direction();
  const double groupSpeed0 = wave.groupSpeed();
  const SurfRule rule = surfRule(options.height, wave);

  std::optional<BreakingMarch> march;
  double phase = 0.0;
  glm::dvec2 place(0.0);
  glm::dvec2 wavenumber(0.0);
  double depthBefore = 0.0;
  for (const Stop& stop : stops)
  {
    const glm::dvec2 inward = inwardOf(stop.side);
    const glm::dvec2 here = this->Mesh->place(stop.i, stop.j);
    glm::dvec2 k = line.wavenumberAt(here, inward);
    const double depth = std::max(waterLevel - seafloor.elevation(here), minDepth);
    const double size = glm::length(k);
    if (march && options.dispersion == WaveDispersion::Nonlinear && size > 0.0)
    {
      k *= finiteAmplitudeWavenumber(wave.angularFrequency(), depth, 0.5 * march->height(), wave.gravity) / size;
    }
    if (march)
    {
      phase += 0.5 * glm::dot(k + wavenumber, here - place);
    }
    EdgeNode& node = this->at(stop.i, stop.j);
    node.wavenumber = k;
    node.eta = 0.0;
    if (size > 0.0)
    {
      const glm::dvec2 direction = k / size;
      // The way in which the wave changes: across its contours, where they are known.
      const std::optional<glm::dvec2> normal =
        options.edge == EdgeRule::Edge ? std::optional<glm::dvec2>(inward) : line.contourNormal();
      const glm::dvec2 across = normal ? *normal * std::copysign(1.0, glm::dot(t0, *normal)) : t0;
      const double cosine = glm::dot(direction, across);
      const WaveSpeeds speeds = waveSpeeds(size, depth, wave.gravity);
      SurfSample sample;
      sample.depth = depth;
      sample.wavenumber = size;
      sample.groupSpeed = speeds.groupSpeed;
      const double refraction =
        std::min(options.height.maxRefraction, std::sqrt(glm::dot(t0, across) / std::max(cosine, 0.0)));
      sample.lossless = wave.height * refraction * shoalingCoefficient(groupSpeed0, speeds.groupSpeed);
      if (march)
      {
        const double metres = std::max(0.0, glm::dot(here - place, across) / cosine);
        sample.slope = metres > 0.0 ? (depthBefore - depth) / metres : 0.0;
        march->advance(sample, metres / speeds.groupSpeed, metres);
      }
      else
      {
        march.emplace(rule, sample);
      }
      const bool entersStraight = glm::dot(direction, inward) > Straight;
      node.eta = !entersStraight && this->isShadowed(stop, direction) ? 0.0 : std::polar(0.5 * march->height(), phase);
    }
    place = here;
    wavenumber = k;
    depthBefore = depth;
  }
}

std::vector<std::complex<double>> MildSlopeIncident::load() const
{
  const MildSlopeMesh& mesh = *this->Mesh;
  const std::size_t along = mesh.columns() + 1;
  std::vector<std::complex<double>> load(along * (mesh.rows() + 1), 0.0);
  const std::size_t west = mesh.padding(MeshSide::West);
  const std::size_t south = mesh.padding(MeshSide::South);
  const std::size_t east = west + mesh.sceneColumns();
  const std::size_t north = south + mesh.sceneRows();

  NestedDissection::Element values;
  const auto add = [&](std::size_t i, std::size_t j)
  {
    mesh.element(i, j, values);
    std::array<std::size_t, 4> nodes{};
    std::array<std::complex<double>, 4> incident{};
    std::array<bool, 4> inside{};
    for (std::size_t a = 0; a < 4; ++a)
    {
      const std::size_t x = i + a % 2;
      const std::size_t y = j + a / 2;
      const std::size_t nearX = std::clamp(x, west, east);
      const std::size_t nearY = std::clamp(y, south, north);
      nodes[a] = y * along + x;
      inside[a] = nearX == x && nearY == y;
      const EdgeNode& edge = this->at(nearX - west, nearY - south);
      const glm::dvec2 way = mesh.spacing() *
        glm::dvec2(
          static_cast<double>(x) - static_cast<double>(nearX), static_cast<double>(y) - static_cast<double>(nearY));
      incident[a] = edge.eta * std::polar(1.0, glm::dot(edge.wavenumber, way));
    }
    for (std::size_t a = 0; a < 4; ++a)
    {
      for (std::size_t b = 0; b < 4; ++b)
      {
        if (inside[a] != inside[b])
        {
          load[nodes[a]] += (inside[a] ? -1.0 : 1.0) * values[4 * a + b] * incident[b];
        }
      }
    }
  };
  const std::size_t lowI = west > 0 ? west - 1 : 0;
  const std::size_t highI = mesh.isOpen(MeshSide::East) ? east + 1 : east;
  const std::size_t lowJ = south > 0 ? south - 1 : 0;
  const std::size_t highJ = mesh.isOpen(MeshSide::North) ? north + 1 : north;
  for (std::size_t j = lowJ; j < highJ; ++j)
  {
    const bool outsideY = j < south || j >= north;
    for (std::size_t i = lowI; i < highI; ++i)
    {
      if (outsideY || i < west || i >= east)
      {
        add(i, j);
      }
    }
  }
  for (std::size_t n = 0; n < load.size(); ++n)
  {
    load[n] = mesh.unknown()[n] ? load[n] : 0.0;
  }
  return load;
}

}
