// Rays mirrored by walls: the images of rays that meet none.
#include "Families.h"
#include "RayRun.h"

#include "sim/Angles.h"
#include "sim/BuiltinSeafloor.h"
#include "sim/Obstacles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace swellray::validation
{

namespace
{

using reference::Place;
using reference::Real;

// The error of the law of reflection that is asked for, rad.
constexpr double LawOfReflection = 1e-10;

class FlatBed final : public Seafloor
{
public:
  FlatBed(const Rectangle& bounds, double depth)
    : Bounds(bounds)
    , Depth(depth)
  {
  }

  Rectangle bounds() const override { return this->Bounds; }
  void evaluate(const glm::dvec2&, unsigned, BedSample& bed) const override
  {
    bed = BedSample();
    bed.elevation = -this->Depth;
  }
  double featureLength() const override { return 1e6; }
  double resolution() const override { return 100.0; }

private:
  Rectangle Bounds;
  double Depth;
};

/** A wall and the exact heading before and after it. */
struct Mirror
{
  double before = 0.0; // rad
  double after = 0.0;
};

struct MirrorScene
{
  const Seafloor* seafloor = nullptr;
  double period = 10.0; // s
  std::vector<Obstacle> walls;
  std::function<RayStart(const RayMedium&)> start;
  std::vector<Place> places;   // in the order of the ray
  std::vector<Mirror> mirrors; // likewise
};

/** Follow the ray from wall to wall, place by place in phase. */
Outcome compareMirrored(const MirrorScene& scene, const Setting& setting)
{
  const WrongSeafloor bed(*scene.seafloor, setting);
  const Obstacles walls(scene.walls);
  RayMedium medium = reference::mediumOf(bed, scene.period, 0.01);
  medium.gravity = setting.gravity;
  medium.obstacles = &walls;

  Outcome outcome;
  outcome.numbers.columns = { "phase_rad", "x_exact_m", "x_m", "y_exact_m", "y_m", "theta_exact_rad", "theta_rad",
    "time_exact_s", "time_s", "width_exact", "width", "reflections" };
  Series exact{ "exact", Series::Look::Line, {}, {} };
  Series computed{ "computed", Series::Look::Dots, {}, {} };
  reference::RayErrors errors;
  double law = 0.0;
  RayStart start = scene.start(medium);
  std::size_t reflections = 0;
  auto next = scene.places.begin();
  while (next != scene.places.end())
  {
    HamiltonianRay ray(medium, start, FineTolerance);
    RayPoint point;
    for (; next != scene.places.end() && ray.advance(FrontMeasure::Phase, next->phase, point); ++next)
    {
      errors.add(point, *next);
      exact.add(next->x, next->y);
      computed.add(point.position.x, point.position.y);
      outcome.numbers.rows.push_back({ next->phase, next->x, point.position.x, next->y, point.position.y, next->theta,
        std::atan2(point.wavenumber.y, point.wavenumber.x), next->time, point.travelTime, next->width, point.tubeWidth,
        static_cast<double>(reflections) });
    }
    if (next == scene.places.end())
    {
      break;
    }
    if (!ray.reflection() || reflections == scene.mirrors.size())
    {
      errors.position = std::numeric_limits<double>::infinity();
      break;
    }
    const Mirror& mirror = scene.mirrors[reflections++];
    const glm::dvec2 onward = ray.reflection()->wavenumber;
    for (const auto& [k, heading] : { std::pair(point.wavenumber, mirror.before), std::pair(onward, mirror.after) })
    {
      law = std::max(law, std::abs(std::remainder(std::atan2(k.y, k.x) - heading, 2.0 * Pi)));
    }
    start = *ray.reflection();
  }
  outcome.plots = { Plot{ "rays", "x (m)", "y (m)", { exact, computed }, false, true } };
  const RayLimits limits;
  addPathChecks(errors, limits, "", outcome.checks);
  outcome.checks.push_back({ "tube width (relative)", errors.width, limits.width, limits.widthReason });
  outcome.checks.push_back({ "heading before and after a wall (rad)", law, LawOfReflection, "asked for" });
  const auto missing = static_cast<double>(scene.mirrors.size()) - static_cast<double>(reflections);
  outcome.checks.push_back({ "reflections that are missing", std::abs(missing), 0.0, "a count" });
  return outcome;
}

/** Between two walls that meet: unfolded over them, the ray is one straight line. */
Outcome wedge(const Setting& setting)
{
  constexpr double depth = 12.0;  // m
  constexpr double period = 10.0; // s
  const Real low = radians(-25.0);
  const Real opening = radians(55.0);
  const Real radius = 2000.0L; // m, of the start
  const Real from = radians(4.0);
  const Real heading = radians(4.0 + 180.0 - 14.0);
  const FlatBed bed({ { -4000.0, -4000.0 }, { 4000.0, 4000.0 } }, depth);
  const Real omega = 2.0L * reference::Pi / period;
  const Real k = reference::wavenumber(omega, depth);
  const Real speed = reference::groupSpeed(omega, depth);

  MirrorScene scene;
  scene.seafloor = &bed;
  scene.period = period;
  for (const Real angle : { low, low + opening })
  {
    const glm::dvec2 along(std::cos(static_cast<double>(angle)), std::sin(static_cast<double>(angle)));
    scene.walls.push_back({ { { 0.0, 0.0 }, 5000.0 * along }, false, 1.0 });
  }
  const glm::dvec2 place(static_cast<double>(radius * std::cos(from)), static_cast<double>(radius * std::sin(from)));
  const auto theta = static_cast<double>(heading);
  scene.start = [=](const RayMedium& medium) {
    return reference::startHeading(medium, place, theta, { -std::sin(theta), std::cos(theta) });
  };

  // Images of a place of the unfolded line: of the sector m, turned by m openings, and mirrored where m is odd.
  const auto sectorOf = [&](Real angle) { return static_cast<int>(std::floor((angle - low) / opening)); };
  const auto fold = [&](Real angle, int sector)
  {
    const Real turn = static_cast<Real>(sector) * opening;
    return sector % 2 == 0 ? angle - turn : 2.0L * low + opening + turn - angle;
  };
  constexpr int count = 120;
  int sector = 0;
  for (int i = 1; i <= count; ++i)
  {
    const Real length = 3600.0L * static_cast<Real>(i) / count;
    const Real x = radius * std::cos(from) + length * std::cos(heading);
    const Real y = radius * std::sin(from) + length * std::sin(heading);
    Real angle = std::atan2(y, x);
    angle += angle < low ? 2.0L * reference::Pi : 0.0L;
    for (; sector < sectorOf(angle); ++sector)
    {
      scene.mirrors.push_back(
        { static_cast<double>(fold(heading, sector)), static_cast<double>(fold(heading, sector + 1)) });
    }
    const Real folded = fold(angle, sector);
    Place image;
    image.x = static_cast<double>(std::hypot(x, y) * std::cos(folded));
    image.y = static_cast<double>(std::hypot(x, y) * std::sin(folded));
    image.theta = static_cast<double>(fold(heading, sector));
    image.phase = static_cast<double>(k * length);
    image.time = static_cast<double>(length / speed);
    image.length = static_cast<double>(length);
    scene.places.push_back(image);
  }
  return compareMirrored(scene, setting);
}

/** A wall straight out to sea from a plane beach: behind it the ray would have gone on as its mirror image. */
Outcome groyne(const Setting& setting)
{
  constexpr double x0 = 2000.0; // m
  constexpr double slope = 0.02;
  constexpr double period = 10.0; // s
  constexpr double wall = 400.0;  // m, y
  const double theta0 = radians(45.0);
  const auto seafloor = makeBuiltinSeafloor("plane:s=0.02,x0=-100,x1=2100,y0=-4000,y1=4000");
  const reference::StraightRay exact([](Real x) { return Real(slope) * x; }, 2.0 * Pi / period, x0, theta0);

  MirrorScene scene;
  scene.seafloor = seafloor.get();
  scene.period = period;
  scene.walls = { { { { -100.0, wall }, { 2100.0, wall } }, false, 1.0 } };
  scene.start = [=](const RayMedium& medium) {
    return reference::startHeading(medium, { x0, 0.0 }, Pi - theta0, { 0.0, -1.0 / std::cos(theta0) });
  };
  constexpr int count = 40;
  for (int i = 1; i <= count; ++i)
  {
    Place place = exact.at(x0 * std::pow(5.0 / x0, static_cast<double>(i) / count));
    if (place.y > wall)
    {
      place.y = 2.0 * wall - place.y;
      place.theta = -place.theta;
    }
    scene.places.push_back(place);
  }
  // Where the ray meets the wall, by halving.
  double near = 5.0;
  double far = x0;
  for (int i = 0; i < 60; ++i)
  {
    const double middle = 0.5 * (near + far);
    (exact.at(middle).y > wall ? near : far) = middle;
  }
  const double theta = exact.at(0.5 * (near + far)).theta;
  scene.mirrors = { { theta, -theta } };
  return compareMirrored(scene, setting);
}

}

std::vector<Case> reflectionCases()
{
  return {
    { "reflection_groyne", "A ray mirrored by a groyne",
      "h = 0.02 x, T = 10 s, from x = 2000 m at 45 degrees; a wall along y = 400 m, across the contours. From there "
      "on the ray is the mirror image of the one without a wall (as c2_plane_A); its heading at the wall by Snell's "
      "law.",
      groyne },
    { "reflection_wedge", "A ray between two walls that meet",
      "12 m deep, T = 10 s, walls at -25 and 30 degrees. Unfolded over the walls the ray is a straight line; each "
      "place "
      "of it is turned and mirrored back into the wedge.",
      wedge }
  };
}

}
