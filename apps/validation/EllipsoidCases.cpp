// Rays on the WGS 84 ellipsoid: geodesics over a deep sea, and a depth that varies with latitude only.
#include "Families.h"
#include "GridRun.h"
#include "RayRun.h"

#include "MapOfEarth.h"
#include "ZonalRay.h"

#include "bathymetry/Geodesics.h"
#include "sim/Angles.h"
#include "sim/GeographicSeafloor.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>

namespace swellray::validation
{

namespace
{

using reference::Real;

constexpr double SemiMajor = 6378137.0;
constexpr double Flattening = 1.0 / 298.257223563;
constexpr double DefaultTolerance = 1e-8;
constexpr double DeepSea = 1e5; // m: tanh kh is 1 to the last digit
constexpr Real Degree = reference::Pi / 180.0L;

struct Shot
{
  double latitude; // degrees
  double longitude;
  double azimuth;
  double length; // m
};

/** A sea over the whole map of the scene around a meridian. */
class Sea
{
public:
  Sea(double longitude, double standardLatitude, double period, const reference::ZonalSeafloor::Profile& depth,
    const Setting& setting)
    : Map(SemiMajor, Flattening, longitude, standardLatitude)
    , Floor(depth, this->Map,
        { this->Map.toMap({ longitude - 360.0, -84.0 }), this->Map.toMap({ longitude + 360.0, 84.0 }) })
    , Computed(this->Floor, setting)
  {
    this->Medium.seafloor = &this->Computed;
    this->Medium.gravity = setting.gravity;
    this->Medium.angularFrequency = 2.0 * Pi / period;
    this->Medium.map = &this->Map;
  }

  EllipsoidMercator Map;
  reference::ZonalSeafloor Floor;
  WrongSeafloor Computed; // right unless the checker is checked
  RayMedium Medium;
};

// Written so that a value that is not a number stays.
void raise(double& error, double now)
{
  error = std::abs(now) <= error ? error : std::abs(now);
}

struct GeodesicErrors
{
  double position = 0.0; // m
  double azimuth = 0.0;  // rad
  double phase = 0.0;    // relative
  double time = 0.0;     // relative
  double fan = 0.0;      // of m12 over the Earth's radius
  double parallel = 0.0; // of M12
};

/** Starts of a fan out of one point, by the heading, and of rays that start parallel, across a geodesic. */
struct Starts
{
  RayStart fan;
  RayStart parallel;
};

Starts startsOf(const Sea& sea, const Shot& shot)
{
  const glm::dvec2 position = sea.Map.toMap({ shot.longitude, shot.latitude });
  ScaleSample m;
  sea.Map.evaluate(position, m);
  const double azimuth = radians(shot.azimuth);
  const glm::dvec2 heading(std::sin(azimuth), std::cos(azimuth));
  const glm::dvec2 left(-heading.y, heading.x);
  Starts starts;
  starts.fan = reference::startAzimuth(sea.Medium, position, azimuth, glm::dvec2(0.0));
  const double k = glm::length(starts.fan.wavenumber);
  starts.fan.dWavenumber = k * left;
  // On the map a geodesic across the rays is curved, and headings turn with it.
  starts.parallel = reference::startAzimuth(sea.Medium, position, azimuth, m.scale * left);
  starts.parallel.dWavenumber += glm::dot(m.gradient, heading) * k * left;
  return starts;
}

GeodesicErrors geodesicErrors(const Shot& shot, double period, double tolerance, const Setting& setting,
  Series* exactPath = nullptr, Series* path = nullptr, Table* numbers = nullptr)
{
  const Geodesics earth;
  const Sea sea(
    shot.longitude, 30.0, period,
    [](double, double& h, double& h1, double& h2)
    {
      h = DeepSea;
      h1 = h2 = 0.0;
    },
    setting);
  const Starts starts = startsOf(sea, shot);
  HamiltonianRay fan(sea.Medium, starts.fan, tolerance);
  HamiltonianRay parallel(sea.Medium, starts.parallel, tolerance);
  const Real omega = 2.0L * reference::Pi / period;
  const double k = static_cast<double>(reference::wavenumber(omega, DeepSea));
  const double speed = static_cast<double>(reference::groupSpeed(omega, DeepSea));
  GeodesicErrors errors;
  constexpr int parts = 40;
  for (int i = 1; i <= parts; ++i)
  {
    const Geodesic exact = earth.direct({ shot.longitude, shot.latitude }, shot.azimuth, shot.length * i / parts);
    RayPoint point;
    RayPoint beside;
    if (!fan.advance(FrontMeasure::Length, exact.length, point) ||
      !parallel.advance(FrontMeasure::Length, exact.length, beside))
    {
      point.position = glm::dvec2(std::numeric_limits<double>::quiet_NaN());
    }
    const glm::dvec2 place = sea.Map.toLonLat(point.position);
    const double distance = earth.inverse(exact.to, place).length;
    const double azimuth = std::atan2(point.wavenumber.x, point.wavenumber.y);
    raise(errors.position, distance);
    raise(errors.azimuth, std::remainder(azimuth - radians(exact.azimuthTo), 2.0 * Pi));
    raise(errors.phase, point.phase / (k * exact.length) - 1.0);
    raise(errors.time, point.travelTime * speed / exact.length - 1.0);
    raise(errors.fan, (point.tubeWidth - exact.reducedLength) / SemiMajor);
    raise(errors.parallel, beside.tubeWidth - exact.scale);
    if (numbers)
    {
      exactPath->add(exact.to.x, exact.to.y);
      path->add(place.x, place.y);
      numbers->rows.push_back({ exact.length, exact.to.x, place.x, exact.to.y, place.y, exact.azimuthTo,
        degrees(azimuth), distance, exact.reducedLength, point.tubeWidth, exact.scale, beside.tubeWidth });
    }
  }
  if (numbers)
  {
    exactPath->add(std::nan(""), std::nan(""));
  }
  return errors;
}

GeodesicErrors largest(const GeodesicErrors& a, const GeodesicErrors& b)
{
  GeodesicErrors both = a;
  raise(both.position, b.position);
  raise(both.azimuth, b.azimuth);
  raise(both.phase, b.phase);
  raise(both.time, b.time);
  raise(both.fan, b.fan);
  raise(both.parallel, b.parallel);
  return both;
}

Outcome runGeodesics(const Setting& setting)
{
  constexpr double period = 15.0;
  // Both hemispheres, across the equator and the antimeridian, towards the poles and away from them.
  const std::vector<Shot> shots{ { -50.0, 150.0, 40.0, 13e6 }, { 55.0, -35.0, 140.0, 10e6 },
    { -60.0, 170.0, 58.0, 11.8e6 }, { -35.0, 20.0, 100.0, 10e6 }, { 5.0, 178.0, 275.0, 10e6 },
    { 20.0, -157.0, 200.0, 9e6 } };
  Outcome outcome;
  outcome.numbers.columns = { "length_m", "longitude_exact", "longitude", "latitude_exact", "latitude", "azimuth_exact",
    "azimuth", "distance_m", "m12_exact_m", "width_fan_m", "M12_exact", "width_parallel" };
  Series exactPath{ "geodesics", Series::Look::Line, {}, {} };
  Series path{ "rays", Series::Look::Dots, {}, {} };
  GeodesicErrors fine;
  GeodesicErrors usual;
  for (const Shot& shot : shots)
  {
    fine = largest(fine, geodesicErrors(shot, period, FineTolerance, setting, &exactPath, &path, &outcome.numbers));
    usual = largest(usual, geodesicErrors(shot, period, DefaultTolerance, setting));
  }
  const std::string steps = "some thousand steps, each right to 1e-12 of a wavelength of 351 m, and rounding of 1e7 m";
  const std::string looser = "asked for is 1 m after 10,000 km; some hundred steps of 1e-8 of a wavelength are below";
  const std::string same = "the same steps, relative";
  outcome.checks = { { "position after 13,000 km (m)", fine.position, 1e-6, steps },
    { "azimuth (rad)", fine.azimuth, 2e-10, same }, { "phase (relative)", fine.phase, 2e-10, same },
    { "travel time (relative)", fine.time, 2e-10, same },
    { "m12, tube of a point source (Earth radii)", fine.fan, 1e-11, "the tube is held to fewer digits than its ray" },
    { "M12, tube of parallel rays", fine.parallel, 1e-11, "the tube is held to fewer digits than its ray" },
    { "position after 13,000 km (m), default", usual.position, 1e-3, looser },
    { "m12 (Earth radii), default", usual.fan, 1e-7, "errors go as the tolerance of a step, 1e-8 in place of 1e-12" },
    { "M12, default", usual.parallel, 1e-7, "errors go as the tolerance of a step, 1e-8 in place of 1e-12" } };

  Series dots{ "largest error of position", Series::Look::Dots, {}, {} };
  for (const double tolerance : { 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9 })
  {
    double error = 0.0;
    for (const Shot& shot : shots)
    {
      raise(error, geodesicErrors(shot, period, tolerance, setting).position);
    }
    dots.add(tolerance, error);
  }
  const double order = fittedOrder(dots.x, dots.y);
  outcome.checks.push_back({ "order of position in the tolerance", order, 0.75,
    "the error of a step is held to the tolerance, and so is their sum", Check::Ask::AtLeast });
  char title[80];
  std::snprintf(title, sizeof title, "error over tolerance: order %.2f", order);
  outcome.plots = { { "rays", "longitude (degrees)", "latitude (degrees)", { exactPath, path }, false, false },
    { title, "tolerance of a step", "position (m)", { fittedLine(dots, order), dots }, true, false } };
  return outcome;
}

/** h = h0 + h1 sin(n phi). */
struct Zones
{
  const char* name;
  double h0; // m
  double h1;
  double waves; // n
  double period;
  double from; // latitude, degrees
  double to;
  std::vector<double> azimuths; // degrees
  double coarse;                // spacing of the coarsest grid, degrees
};

struct ZonalErrors
{
  double position = 0.0;  // m
  double azimuth = 0.0;   // rad
  double phase = 0.0;     // relative
  double time = 0.0;      // relative
  double width = 0.0;     // relative
  double invariant = 0.0; // relative
};

constexpr double ZonesLongitude = 170.0;

/** The depth of zones at nodes so many degrees of latitude apart, 150 degrees of longitude to both sides of the start. */
std::unique_ptr<GeographicSeafloor> griddedZones(const Zones& zones, const EllipsoidMercator& map, double spacing)
{
  constexpr double beyond = 15.0; // degrees, that no ray feels the rim
  const double south = std::min(zones.from, zones.to) - beyond + 0.37 * spacing;
  ElevationGrid grid;
  grid.origin = { ZonesLongitude - 150.0, south };
  grid.spacing = { 30.0, spacing };
  grid.columns = 11;
  grid.rows = static_cast<std::size_t>(std::ceil((std::abs(zones.to - zones.from) + 2.0 * beyond) / spacing)) + 1;
  for (std::size_t row = 0; row < grid.rows; ++row)
  {
    const double depth = zones.h0 + zones.h1 * std::sin(zones.waves * radians(grid.node(0, row).y));
    grid.elevation.insert(grid.elevation.end(), grid.columns, -depth);
  }
  return std::make_unique<GeographicSeafloor>(grid, std::make_shared<EllipsoidMercator>(map));
}

/** @param spacing of a grid that stands in place of the formula, degrees; 0: the formula itself */
ZonalErrors zonalErrors(const Zones& zones, double azimuth, double tolerance, const Setting& setting,
  double spacing = 0.0, Series* exactPath = nullptr, Series* path = nullptr, Table* numbers = nullptr)
{
  const double longitude = ZonesLongitude;
  const Sea sea(
    longitude, 10.0, zones.period,
    [&zones](double phi, double& h, double& h1, double& h2)
    {
      h = zones.h0 + zones.h1 * std::sin(zones.waves * phi);
      h1 = zones.h1 * zones.waves * std::cos(zones.waves * phi);
      h2 = -zones.h1 * zones.waves * zones.waves * std::sin(zones.waves * phi);
    },
    setting);
  const reference::ZonalRay exact([&zones](Real phi) -> Real
    { return zones.h0 + zones.h1 * std::sin(zones.waves * phi); },
    zones.period, zones.from* Degree, longitude* Degree, azimuth* Degree);
  const glm::dvec2 from = sea.Map.toMap({ longitude, zones.from });
  // A row along the parallel, a metre across the rays.
  const glm::dvec2 row(-sea.Map.scale(from) / std::cos(radians(azimuth)), 0.0);
  RayMedium medium = sea.Medium;
  std::unique_ptr<GeographicSeafloor> grid;
  std::unique_ptr<WrongSeafloor> computed;
  if (spacing > 0.0)
  {
    grid = griddedZones(zones, sea.Map, spacing);
    computed = std::make_unique<WrongSeafloor>(*grid, setting);
    medium.seafloor = computed.get();
    medium.map = &grid->map();
  }
  HamiltonianRay ray(medium, reference::startAzimuth(medium, from, radians(azimuth), row), tolerance);
  const reference::Ellipsoid earth;
  const auto invariant = [&](double k, double latitude, double at)
  { return k * static_cast<double>(earth.normalRadius(latitude)) * std::cos(latitude) * std::sin(at); };
  RayPoint point;
  ray.advance(FrontMeasure::Length, 0.0, point);
  const double first = invariant(glm::length(point.wavenumber), radians(zones.from), radians(azimuth));
  ZonalErrors errors;
  constexpr int parts = 30;
  for (int i = 1; i <= parts; ++i)
  {
    const reference::ZonalPlace place = exact.at((zones.from + (zones.to - zones.from) * i / parts) * Degree);
    if (!ray.advance(FrontMeasure::Length, place.length, point))
    {
      point.position = glm::dvec2(std::numeric_limits<double>::quiet_NaN());
    }
    const glm::dvec2 wanted = sea.Map.toMap({ degrees(place.longitude), degrees(place.latitude) });
    const double distance = glm::length(point.position - wanted) / sea.Map.scale(wanted);
    const double heading = std::atan2(point.wavenumber.x, point.wavenumber.y);
    const glm::dvec2 lonLat = sea.Map.toLonLat(point.position);
    raise(errors.position, distance);
    raise(errors.azimuth, heading - place.azimuth);
    raise(errors.phase, point.phase / place.phase - 1.0);
    raise(errors.time, point.travelTime / place.time - 1.0);
    raise(errors.width, point.tubeWidth / place.width - 1.0);
    raise(errors.invariant, invariant(glm::length(point.wavenumber), radians(lonLat.y), heading) / first - 1.0);
    if (numbers)
    {
      exactPath->add(degrees(place.longitude), degrees(place.latitude));
      path->add(lonLat.x, lonLat.y);
      numbers->rows.push_back({ azimuth, place.length, degrees(place.longitude), lonLat.x, degrees(place.latitude),
        lonLat.y, degrees(place.azimuth), degrees(heading), point.depth, place.width, point.tubeWidth });
    }
  }
  if (numbers)
  {
    exactPath->add(std::nan(""), std::nan(""));
  }
  return errors;
}

Outcome runZones(const Zones& zones, const Setting& setting)
{
  Outcome outcome;
  outcome.numbers.columns = { "azimuth_0", "length_m", "longitude_exact", "longitude", "latitude_exact", "latitude",
    "azimuth_exact", "azimuth", "depth_m", "width_exact", "width" };
  Series exactPath{ "exact", Series::Look::Line, {}, {} };
  Series path{ "computed", Series::Look::Dots, {}, {} };
  ZonalErrors fine;
  double usual = 0.0;
  for (const double azimuth : zones.azimuths)
  {
    const ZonalErrors now =
      zonalErrors(zones, azimuth, FineTolerance, setting, 0.0, &exactPath, &path, &outcome.numbers);
    raise(fine.position, now.position);
    raise(fine.azimuth, now.azimuth);
    raise(fine.phase, now.phase);
    raise(fine.time, now.time);
    raise(fine.width, now.width);
    raise(fine.invariant, now.invariant);
    raise(usual, zonalErrors(zones, azimuth, DefaultTolerance, setting).position);
  }
  const double wavelength = 2.0 * Pi /
    static_cast<double>(reference::wavenumber(2.0L * reference::Pi / zones.period, zones.h0 + std::abs(zones.h1)));
  // A step is as right as that or as rounding of the coordinates, 1e-9 m.
  constexpr double steps = 300.0;
  const double position = steps * (FineTolerance * wavelength + 1e-9);
  const std::string reason = "some hundred steps, each right to 1e-12 of a wavelength and 1e-9 m, add up to less";
  const std::string same = "the same steps, relative";
  outcome.checks = {
    { "position (m)", fine.position, position, reason }, { "azimuth (rad)", fine.azimuth, 2e-10, same },
    { "phase (relative)", fine.phase, 2e-10, same }, { "travel time (relative)", fine.time, 2e-10, same },
    { "tube width (relative)", fine.width, 1e-8, "the tube is held to fewer digits than its ray" },
    { "k N cos(lat) sin(az) (relative)", fine.invariant, 2e-10, same },
    { "position (m), default", usual, steps * DefaultTolerance * wavelength, "the same steps of 1e-8 of a wavelength" }
  };
  Series dots{ "largest error of position", Series::Look::Dots, {}, {} };
  for (const double tolerance : { 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10 })
  {
    double error = 0.0;
    for (const double azimuth : zones.azimuths)
    {
      raise(error, zonalErrors(zones, azimuth, tolerance, setting).position);
    }
    dots.add(tolerance, error);
  }
  const double order = fittedOrder(dots.x, dots.y);
  outcome.checks.push_back({ "order of position in the tolerance", order, 0.75,
    "the error of a step is held to the tolerance, and so is their sum", Check::Ask::AtLeast });
  char title[80];
  std::snprintf(title, sizeof title, "error over tolerance: order %.2f", order);
  outcome.plots = { { "rays", "longitude (degrees)", "latitude (degrees)", { exactPath, path }, false, false },
    { title, "tolerance of a step", "position (m)", { fittedLine(dots, order), dots }, true, false } };
  Plot plot{ "on grids in longitude and latitude", "spacing (degrees)", "largest error", {}, true, false };
  Series onGrid{ "position (m)", Series::Look::Dots, {}, {} };
  Series width{ "tube width (relative)", Series::Look::Dots, {}, {} };
  for (const double share : { 1.0, 0.5, 0.25 })
  {
    const double spacing = share * zones.coarse;
    ZonalErrors worst;
    for (const double azimuth : zones.azimuths)
    {
      const ZonalErrors now = zonalErrors(zones, azimuth, FineTolerance, setting, spacing);
      raise(worst.position, now.position);
      raise(worst.width, now.width);
    }
    onGrid.add(spacing, worst.position);
    width.add(spacing, worst.width);
  }
  const GridRates rates = gridRates(GridOrder::Straight);
  addFittedOrder("order of position in the grid's spacing", onGrid, rates.path, rates.pathReason, plot, outcome);
  addFittedOrder("order of tube width in the grid's spacing", width, rates.width, rates.widthReason, plot, outcome);
  outcome.plots.push_back(plot);
  return outcome;
}

}

std::vector<Case> ellipsoidCases()
{
  std::vector<Case> cases{ { "c9_geodesic", "Deep-water rays on WGS 84 are geodesics",
    "T = 15 s over a sea of 100 km, six rays of 9,000 to 13,000 km. Karney's geodesics (2013, GeographicLib): places, "
    "azimuths, reduced length m12 (tube of a point source) and geodesic scale M12 (tube of parallel rays).",
    runGeodesics } };
  for (const Zones& zones :
    { Zones{ "c9_zonal_depth", 4000.0, 1500.0, 3.0, 1200.0, -45.0, 10.0, { 20.0, 45.0, 60.0 }, 6.0 },
      Zones{ "c9_zonal_depth_swell", 150.0, 60.0, 7.0, 18.0, 5.0, 55.0, { -10.0, 30.0 }, 2.0 } })
  {
    char formula[160];
    std::snprintf(formula, sizeof formula, "h = %g + %g sin(%g lat) m, T = %g s, from latitude %g. ", zones.h0,
      zones.h1, zones.waves, zones.period, zones.from);
    cases.push_back({ zones.name, "Rays on WGS 84 over a depth that varies with latitude only",
      std::string(formula) +
        "k N cos(lat) sin(az) is kept (Clairaut and Snell); longitude, way, phase and time by "
        "quadrature in long double.",
      [zones](const Setting& setting) { return runZones(zones, setting); } });
  }
  return cases;
}

}
