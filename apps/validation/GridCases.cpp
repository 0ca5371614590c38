// Gridded seafloors: what a C2 spline of the depth leaves of the accuracy of the formula, and how fast that falls.
#include "CircularForms.h"
#include "Families.h"
#include "RayRun.h"
#include "StraightForms.h"

#include "sim/BuiltinSeafloor.h"
#include "sim/SplineSeafloor.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace swellray::validation
{

namespace
{

using reference::Place;
using reference::Real;

constexpr double Depth = 20.0;
constexpr double Height = 14.0;
constexpr double Sigma = 300.0;
constexpr double Period = 10.0;
constexpr double Distance = 1800.0; // m from the start to abreast of the shoal
constexpr double Reach = 3600.0;    // m, through the cusp at 2021 m and beyond
constexpr double Inside = 2700.0;   // half width of the grid, m
constexpr std::array<double, 10> Aside{ 0.0, 30.0, 75.0, 150.0, -180.0, 225.0, 300.0, 450.0, 600.0, 750.0 };

struct GridErrors
{
  double position = 0.0; // largest, m
  double theta = 0.0;    // largest, rad
  double width = 0.0;    // largest, relative where |q| > 1
  double positionSum = 0.0;
  double widthSum = 0.0;
  double count = 0.0;

  double positionRms() const { return std::sqrt(this->positionSum / this->count); }
  double widthRms() const { return std::sqrt(this->widthSum / this->count); }
};

ElevationGrid sampled(
  const std::function<double(const glm::dvec2&)>& depth, const Rectangle& box, double spacing, double offset)
{
  ElevationGrid grid;
  grid.origin = box.low + glm::dvec2(offset * spacing);
  grid.spacing = glm::dvec2(spacing);
  grid.columns = static_cast<std::size_t>(box.size().x / spacing);
  grid.rows = static_cast<std::size_t>(box.size().y / spacing);
  grid.elevation.resize(grid.columns * grid.rows);
  for (std::size_t j = 0; j < grid.rows; ++j)
  {
    for (std::size_t i = 0; i < grid.columns; ++i)
    {
      grid.at(i, j) = -depth(grid.node(i, j));
    }
  }
  return grid;
}

/** The exact rays towards +x, by the equations of Munk and Arthur on the formula. */
std::vector<std::vector<Place>> exactRays()
{
  const reference::CircularForm shoal = reference::gaussianShoal(Depth, Height, Sigma);
  std::vector<double> lengths;
  for (int i = 1; i <= 40; ++i)
  {
    lengths.push_back(Reach * i / 40.0);
  }
  std::vector<std::vector<Place>> rays;
  for (const double b : Aside)
  {
    Place start;
    start.x = -Distance;
    start.y = b;
    rays.push_back(traceMunkArthur(shoal.formula(), 2.0 * Pi / Period, start, lengths, Sigma / 400.0));
  }
  return rays;
}

void addErrors(const std::vector<std::vector<Place>>& exact, const Seafloor& gridded, double heading,
  const Setting& setting, GridErrors& errors, Outcome* outcome)
{
  RayMedium medium = reference::mediumOf(gridded, Period, 0.1);
  medium.gravity = setting.gravity;
  // The shoal is round: other headings are the same rays, turned.
  const glm::dvec2 along(std::cos(heading), std::sin(heading));
  const glm::dvec2 across(-along.y, along.x);
  Series line{ "exact", Series::Look::Line, {}, {} };
  Series dots{ "computed on the grid", Series::Look::Dots, {}, {} };
  for (std::size_t r = 0; r < exact.size(); ++r)
  {
    const glm::dvec2 from = Aside[r] * across - Distance * along;
    HamiltonianRay ray(medium, reference::startHeading(medium, from, heading, across), FineTolerance);
    RayPoint point;
    for (const Place& place : exact[r])
    {
      if (!ray.advance(FrontMeasure::Length, place.length, point))
      {
        point.position = glm::dvec2(std::nan(""));
      }
      const glm::dvec2 wanted = place.x * along + place.y * across;
      const double aside = glm::length(point.position - wanted);
      const double turn =
        std::abs(std::remainder(std::atan2(point.wavenumber.y, point.wavenumber.x) - heading - place.theta, 2.0 * Pi));
      const double width = std::abs(point.tubeWidth - place.width) / std::max(1.0, std::abs(place.width));
      errors.position = aside <= errors.position ? errors.position : aside;
      errors.theta = turn <= errors.theta ? errors.theta : turn;
      errors.width = width <= errors.width ? errors.width : width;
      errors.positionSum += aside * aside;
      errors.widthSum += width * width;
      errors.count += 1.0;
      line.add(wanted.x, wanted.y);
      dots.add(point.position.x, point.position.y);
    }
    line.add(std::nan(""), std::nan(""));
  }
  if (outcome)
  {
    outcome->plots.push_back({ "rays over the coarsest grid", "x (m)", "y (m)", { line, dots }, false, true });
  }
}

/** Bounds of the errors of a cubic spline (Hall and Meyer 1976): |f' - s'| <= d^3 |f''''|/24, |f'' - s''| <= 3 d^2 |f''''|/8. */
struct SplineBounds
{
  double theta;
  double position;
  double width;

  explicit SplineBounds(double spacing)
  {
    const double omega = 2.0 * Pi / Period;
    const double top = Depth - Height;
    // Of log C by depth, largest on the top.
    const double bending =
      static_cast<double>(-reference::wavenumberSlope(omega, top) / reference::wavenumber(omega, top));
    // Integral of the modulus of the fourth derivative along a line over the top; the lever behind the shoal.
    const double fourth = 7.02 * Height / std::pow(Sigma, 3.0);
    const double lever = Reach - Distance;
    this->theta = bending * fourth * std::pow(spacing, 3.0) / 24.0;
    this->position = this->theta * lever;
    this->width = bending * lever * fourth * 3.0 * spacing * spacing / 8.0;
  }
};

Outcome run(const Setting& setting, double heading, const std::vector<double>& offsets, bool alongGrid)
{
  Outcome outcome;
  outcome.numbers.columns = { "sigma_over_spacing", "spacing_m", "position_m", "position_rms_m", "theta_rad", "width",
    "width_rms" };
  const auto exact = exactRays();
  const reference::CircularForm shoal = reference::gaussianShoal(Depth, Height, Sigma);
  const auto depth = [&](const glm::dvec2& p) { return static_cast<double>(shoal.depth(glm::length(p))); };
  const Rectangle box{ glm::dvec2(-Inside), glm::dvec2(Inside) };
  std::vector<double> spacings;
  Series position{ "position (m)", Series::Look::Dots, {}, {} };
  Series theta{ "heading (rad)", Series::Look::Dots, {}, {} };
  Series width{ "tube width", Series::Look::Dots, {}, {} };
  const std::string reason =
    "bound of Hall and Meyer 1976 for the spline, summed over the shoal, times the lever behind";
  for (const double cells : { 6.0, 12.0, 24.0, 48.0 })
  {
    const double spacing = Sigma / cells;
    GridErrors errors;
    for (const double offset : offsets)
    {
      addErrors(exact, SplineSeafloor(sampled(depth, box, spacing, offset)), heading, setting, errors,
        outcome.plots.empty() ? &outcome : nullptr);
    }
    const SplineBounds bounds(spacing);
    const std::string at = ", sigma/d = " + std::to_string(static_cast<int>(cells));
    outcome.checks.push_back({ "position (m)" + at, errors.position, bounds.position, reason });
    outcome.checks.push_back({ "heading (rad)" + at, errors.theta, bounds.theta, reason });
    outcome.checks.push_back({ "tube width (relative)" + at, errors.width, bounds.width, reason });
    spacings.push_back(spacing);
    position.add(spacing, alongGrid ? errors.position : errors.positionRms());
    theta.add(spacing, errors.theta);
    width.add(spacing, alongGrid ? errors.width : errors.widthRms());
    outcome.numbers.rows.push_back(
      { cells, spacing, errors.position, errors.positionRms(), errors.theta, errors.width, errors.widthRms() });
  }
  const double positionOrder = fittedOrder(spacings, position.y);
  const double thetaOrder = fittedOrder(spacings, theta.y);
  const double widthOrder = fittedOrder(spacings, width.y);
  const std::string along = "of the spline's gradient 3, of its curvature 2: the same error in every cell";
  const std::string across =
    "half an order and more above gradient 3 and curvature 2: errors change sign from cell to cell";
  using Ask = Check::Ask;
  outcome.checks.push_back(
    { "order of position", positionOrder, alongGrid ? 2.9 : 3.5, alongGrid ? along : across, Ask::AtLeast });
  outcome.checks.push_back(
    { "order of heading", thetaOrder, alongGrid ? 2.9 : 3.5, alongGrid ? along : across, Ask::AtLeast });
  outcome.checks.push_back(
    { "order of tube width", widthOrder, alongGrid ? 1.9 : 2.5, alongGrid ? along : across, Ask::AtLeast });

  Plot convergence{ "", "spacing (m)", "error", {}, true, false };
  char title[120];
  std::snprintf(
    title, sizeof title, "orders: position %.2f, heading %.2f, width %.2f", positionOrder, thetaOrder, widthOrder);
  convergence.title = title;
  for (const Series* dots : { &position, &theta, &width })
  {
    const double order = fittedOrder(spacings, dots->y);
    Series line = fittedLine(*dots, order);
    line.name = "";
    convergence.series.push_back(line);
    convergence.series.push_back(*dots);
  }
  outcome.plots.push_back(convergence);
  return outcome;
}

Outcome planeGrid(const Setting& setting)
{
  constexpr double slope = 0.02;
  constexpr double x0 = 1900.0;
  constexpr double theta0 = radians(45.0);
  const Rectangle box{ { -500.0, -500.0 }, { 2500.0, 3000.0 } };
  const SplineSeafloor grid(sampled([](const glm::dvec2& p) { return slope * p.x; }, box, 50.0, 0.3));
  const reference::StraightRay exact(reference::planeDepth(slope), 2.0 * Pi / Period, x0, theta0);
  Track track;
  track.start = [](const RayMedium& medium) {
    return reference::startHeading(medium, { x0, 0.0 }, Pi - theta0, { 0.0, -1.0 / std::cos(theta0) });
  };
  for (int i = 1; i <= 20; ++i)
  {
    track.places.push_back(exact.at(x0 - 90.0 * i));
  }
  RayScene scene;
  scene.seafloor = &grid;
  scene.period = Period;
  scene.tracks = { track };
  scene.depth = [](const Place& place) { return slope * place.x; };
  RayLimits limits;
  limits.positionReason = "a spline reproduces a plane: as on the formula";
  return compareRays(scene, limits, setting);
}

}

std::vector<Case> gridCases()
{
  const std::string about =
    "h = 20 - 14 exp(-r^2/(2 300^2)) sampled at sigma/d = 6, 12, 24 and 48 nodes, T = 10 s, ten rays "
    "through the cusp and beyond, against the equations of Munk and Arthur 1952 on the formula. ";
  return { { "c4_shoal_gauss_grid_across", "Gridded Gaussian shoal, rays across the grid",
             about +
               "Rays at 40 degrees to the grid, the shoal's centre on four places of a cell; orders of rms errors.",
             [](const Setting& setting)
             {
               return run(setting, 0.7,
                 setting.quick ? std::vector<double>{ 0.37 } : std::vector<double>{ 0.0, 0.5, 0.37, 0.2 }, false);
             } },
    { "c4_shoal_gauss_grid_along", "Gridded Gaussian shoal, rays along the grid",
      about + "Rays along the rows, where the error of every cell has the same sign; orders of the largest errors.",
      [](const Setting& setting) { return run(setting, 0.0, { 0.37 }, true); } },
    { "c2_plane_A_grid", "Gridded plane beach", "h = 0.02 x on nodes 50 m apart, T = 10 s, 45 degrees: Snell's law.",
      planeGrid } };
}

}
