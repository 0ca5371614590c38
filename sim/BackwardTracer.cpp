#include "sim/BackwardTracer.h"

#include "sim/Angles.h"
#include "sim/CurrentDispersion.h"
#include "sim/Dispersion.h"
#include "sim/HamiltonianRay.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace swellray
{

namespace
{

// A ray that ends in a hole within so many cells of the outline of the data has left the scene.
constexpr double OutlineCells = 2.0;

// Readings a wavelength where friction is integrated by the trapezoidal rule.
constexpr double ReadingsPerWave = 1.0;

class ReversedCurrent final : public Current
{
public:
  explicit ReversedCurrent(const Current& current)
    : Flow(current)
  {
  }

  Rectangle bounds() const override { return this->Flow.bounds(); }
  double featureLength() const override { return this->Flow.featureLength(); }
  void evaluate(const glm::dvec2& p, CurrentSample& sample) const override
  {
    this->Flow.evaluate(p, sample);
    sample.velocity = -sample.velocity;
    sample.dx = -sample.dx;
    sample.dy = -sample.dy;
    sample.dxx = -sample.dxx;
    sample.dxy = -sample.dxy;
    sample.dyy = -sample.dyy;
  }

private:
  const Current& Flow;
};

void require(bool good, const char* what)
{
  if (!good)
  {
    throw std::invalid_argument(what);
  }
}

// (Cg + U.k/|k|)/(k sigma), by which E(f, heading) makes the action in the plane of wavenumbers.
double actionFactor(double k, double depth, double gravity, double currentAlong)
{
  Frequency f;
  evaluateFrequency(k, depth, gravity, f);
  return (f.k + currentAlong) / (k * f.sigma);
}

double distanceToSide(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b)
{
  const glm::dvec2 along = b - a;
  const double square = glm::dot(along, along);
  const double t = square > 0.0 ? std::clamp(glm::dot(p - a, along) / square, 0.0, 1.0) : 0.0;
  return glm::length(p - a - t * along);
}

}

void BackwardOptions::validate() const
{
  require(std::isfinite(waterLevel), "water level must be a finite number of metres");
  require(gravity > 0.0 && std::isfinite(gravity), "gravity must be above 0 m/s2");
  require(tolerance > 0.0 && tolerance <= 0.1, "tolerance must be above 0 and at most 0.1");
  require(agroundDepth > 0.0 && std::isfinite(agroundDepth), "aground depth must be above 0 m");
  require(offshoreDepth > 0.0, "offshore depth must be above 0 m, or deep");
  require(!shoreNormal || std::isfinite(*shoreNormal), "shore normal must be a finite number of degrees");
  require(friction >= 0.0 && std::isfinite(friction), "friction coefficient must be 0 m2/s3 or above");
  require(maxSteps > 0, "the cap on steps must be above 0");
}

BackwardTracer::BackwardTracer(const Seafloor& seafloor, const BackwardOptions& options)
  : Floor(seafloor)
  , Options(options)
  , Outline(seafloor.outline())
{
  options.validate();
  if (options.edge == EdgeRule::Contours)
  {
    this->ContourNormal = contourNormal(seafloor, options.waterLevel, options.shoreNormal);
  }
  if (options.current)
  {
    requireCover(*options.current, seafloor.bounds());
    this->Reversed = std::make_unique<ReversedCurrent>(*options.current);
  }
}

BackwardTracer::~BackwardTracer() = default;

double BackwardTracer::depth(const glm::dvec2& place) const
{
  if (!this->Floor.bounds().contains(place) || this->Floor.isHole(place))
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return this->Options.waterLevel - this->Floor.elevation(place);
}

bool BackwardTracer::leavesData(const glm::dvec2& place) const
{
  const double scale = this->Options.map ? this->Options.map->scale(place) : 1.0;
  const double near = OutlineCells * std::max(scale * this->Floor.cellSize(), this->Floor.resolution());
  for (std::size_t i = 0; i < this->Outline.size(); ++i)
  {
    if (distanceToSide(place, this->Outline[i], this->Outline[(i + 1) % this->Outline.size()]) <= near)
    {
      return true;
    }
  }
  return false;
}

std::optional<glm::dvec2> BackwardTracer::normalAt(const glm::dvec2& edge) const
{
  if (this->Options.edge != EdgeRule::Edge)
  {
    return this->ContourNormal;
  }
  std::optional<glm::dvec2> normal;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < this->Outline.size(); ++i)
  {
    const glm::dvec2& a = this->Outline[i];
    const glm::dvec2& b = this->Outline[(i + 1) % this->Outline.size()];
    const double distance = distanceToSide(edge, a, b);
    if (distance < nearest && a != b)
    {
      nearest = distance;
      const glm::dvec2 along = glm::normalize(b - a);
      normal = glm::dvec2(along.y, -along.x);
    }
  }
  return normal;
}

WaveOrigin BackwardTracer::trace(const glm::dvec2& place, double frequency, double heading) const
{
  return this->follow(place, frequency, heading, ReadingsPerWave, nullptr);
}

WaveOrigin BackwardTracer::trace(
  const glm::dvec2& place, double frequency, double heading, double stepsPerWave, std::vector<RayPoint>& way) const
{
  way.clear();
  const WaveOrigin origin = this->follow(place, frequency, heading, stepsPerWave, &way);
  if (way.empty())
  {
    return origin;
  }
  std::reverse(way.begin(), way.end());
  const double phase = way.front().phase;
  const double time = way.front().travelTime;
  for (RayPoint& point : way)
  {
    point.wavenumber = -point.wavenumber;
    point.rayDirection = -point.rayDirection;
    point.current = -point.current;
    point.phase = phase - point.phase;
    point.travelTime = time - point.travelTime;
    point.tubeWidth = point.spacingWidth = std::numeric_limits<double>::quiet_NaN();
    point.caustics = 0;
    point.front = BetweenFronts;
  }
  return origin;
}

WaveOrigin BackwardTracer::follow(
  const glm::dvec2& place, double frequency, double heading, double stepsPerWave, std::vector<RayPoint>* way) const
{
  WaveOrigin origin;
  const double omega = 2.0 * Pi * frequency;
  const double gravity = this->Options.gravity;
  const double depthHere = this->depth(place);
  origin.edge = place;
  origin.reason = std::isnan(depthHere) ? EndReason::EnteredHole : EndReason::Aground;
  if (!(depthHere >= this->Options.agroundDepth))
  {
    return origin;
  }
  const Obstacles* obstacles = this->Options.obstacles;
  if (obstacles && obstacles->inside(place))
  {
    origin.reason = EndReason::StoppedByObstacle;
    return origin;
  }
  const glm::dvec2 direction(std::cos(heading), std::sin(heading));
  const glm::dvec2 velocity = this->Options.current ? this->Options.current->velocity(place) : glm::dvec2(0.0);
  double k = 0.0;
  if (this->Options.current)
  {
    const std::optional<double> solved = solveOnCurrent(omega, depthHere, gravity, direction, 0.0, velocity);
    if (!solved)
    {
      origin.reason = EndReason::BlockedByCurrent;
      return origin;
    }
    k = *solved;
  }
  else
  {
    k = solveWavenumber(omega, depthHere, gravity);
  }

  RayMedium medium;
  medium.seafloor = &this->Floor;
  medium.waterLevel = this->Options.waterLevel;
  medium.gravity = gravity;
  medium.angularFrequency = omega;
  medium.agroundDepth = this->Options.agroundDepth;
  medium.current = this->Reversed.get();
  medium.obstacles = obstacles && !obstacles->empty() ? obstacles : nullptr;
  medium.map = this->Options.map;
  RayStart start;
  start.position = place;
  start.wavenumber = -k / medium.scale(place) * direction; // and no tube: its derivatives stay 0
  HamiltonianRay ray(medium, start, this->Options.tolerance, this->Options.maxSteps);
  RayPoint point;
  double decay = 0.0;
  if (this->Options.friction > 0.0 || way)
  {
    const auto rate = [&](double kHere, double h)
    {
      const double s = std::sinh(std::min(kHere * h, 300.0));
      Frequency f;
      evaluateFrequency(kHere, h, gravity, f);
      const double u = f.sigma / (gravity * s);
      return this->Options.friction * u * u;
    };
    double before = rate(k, depthHere);
    double time = 0.0;
    for (std::size_t i = way ? 0 : 1; !ray.ended(); ++i)
    {
      ray.advance(FrontMeasure::Phase, 2.0 * Pi / stepsPerWave * static_cast<double>(i), point);
      const double here = rate(glm::length(point.wavenumber), point.depth);
      decay += 0.5 * (before + here) * (point.travelTime - time);
      before = here;
      time = point.travelTime;
      if (way)
      {
        way->push_back(point);
      }
    }
  }
  else
  {
    ray.advance(FrontMeasure::Time, std::numeric_limits<double>::infinity(), point);
  }
  origin.edge = point.position;
  origin.travelTime = point.travelTime;
  origin.reason = ray.endReason();
  origin.steps = ray.steps();
  const bool came = ray.ended() &&
    (origin.reason == EndReason::LeftScene ||
      (origin.reason == EndReason::EnteredHole && this->leavesData(point.position)));
  if (!came)
  {
    return origin;
  }

  const glm::dvec2 incoming = -point.wavenumber;
  const double offshore = solveWavenumber(omega, this->Options.offshoreDepth, gravity);
  glm::dvec2 from = incoming;
  const std::optional<glm::dvec2> normal = this->normalAt(point.position);
  if (normal)
  {
    const glm::dvec2 along = *normal * std::copysign(1.0, glm::dot(incoming, *normal));
    const glm::dvec2 left(-along.y, along.x);
    const double across = glm::dot(incoming, left);
    const double square = offshore * offshore - across * across;
    if (!(square > 0.0))
    {
      return origin;
    }
    from = std::sqrt(square) * along + across * left;
  }
  origin.heading = std::atan2(from.y, from.x);
  // Offshore there is no current; its depth may be infinite, where Cg = omega/(2 k).
  const double groupSpeed = waveSpeeds(offshore, this->Options.offshoreDepth, gravity).groupSpeed;
  origin.gain = groupSpeed / (offshore * omega) / actionFactor(k, depthHere, gravity, glm::dot(velocity, direction)) *
    std::exp(-decay);
  return origin;
}

}
