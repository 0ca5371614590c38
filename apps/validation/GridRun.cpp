#include "GridRun.h"

#include "sim/SplineCurrent.h"
#include "sim/SplineSeafloor.h"

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace swellray::validation
{

using reference::Place;

namespace
{

/** A vector turned anticlockwise. */
glm::dvec2 turned(const glm::dvec2& v, double angle)
{
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return { c * v.x - s * v.y, s * v.x + c * v.y };
}

/** Box around the corners of a box turned anticlockwise. */
Rectangle turnedBox(const Rectangle& box, double angle)
{
  Rectangle around{ glm::dvec2(std::numeric_limits<double>::infinity()),
    glm::dvec2(-std::numeric_limits<double>::infinity()) };
  for (const glm::dvec2& corner :
    { box.low, box.high, glm::dvec2(box.low.x, box.high.y), glm::dvec2(box.high.x, box.low.y) })
  {
    around.low = glm::min(around.low, turned(corner, angle));
    around.high = glm::max(around.high, turned(corner, angle));
  }
  return around;
}

/** A gridded seafloor whose axes are turned anticlockwise. */
class TurnedSeafloor final : public Seafloor
{
public:
  TurnedSeafloor(ElevationGrid grid, double angle, const Rectangle& bounds)
    : Grid(grid)
    , Angle(angle)
    , Bounds(bounds)
  {
  }

  Rectangle bounds() const override { return this->Bounds; }
  void evaluate(const glm::dvec2& p, unsigned region, BedSample& bed) const override
  {
    this->Grid.evaluate(turned(p, -this->Angle), region, bed);
    bed.gradient = turned(bed.gradient, this->Angle);
    const double c = std::cos(this->Angle);
    const double s = std::sin(this->Angle);
    const BedSample own = bed;
    bed.xx = c * c * own.xx - 2.0 * c * s * own.xy + s * s * own.yy;
    bed.xy = c * s * (own.xx - own.yy) + (c * c - s * s) * own.xy;
    bed.yy = s * s * own.xx + 2.0 * c * s * own.xy + c * c * own.yy;
  }
  double featureLength() const override { return this->Grid.featureLength(); }
  double resolution() const override { return this->Grid.resolution(); }
  double cellSize() const override { return this->Grid.cellSize(); }

private:
  SplineSeafloor Grid;
  double Angle;
  Rectangle Bounds;
};

// Errors of a step far below those of any grid here.
constexpr double GridTolerance = 1e-13;
// What first order leaves out: chords stand for the path, and errors meet one another on it.
constexpr double BoundFactor = 2.0;

struct GridErrors
{
  double position = 0.0; // m
  double theta = 0.0;    // rad
  double width = 0.0;    // relative where |q| > 1
  double positionSum = 0.0;
  double thetaSum = 0.0;
  double widthSum = 0.0;
  double count = 0.0;

  void add(const RayPoint& point, const Place& place)
  {
    const double aside = std::hypot(point.position.x - place.x, point.position.y - place.y);
    const double turn =
      std::abs(std::remainder(std::atan2(point.wavenumber.y, point.wavenumber.x) - place.theta, 2.0 * Pi));
    const double wide = std::abs(point.tubeWidth - place.width) / std::max(1.0, std::abs(place.width));
    // Written so that a value that is not a number stays.
    this->position = aside <= this->position ? this->position : aside;
    this->theta = turn <= this->theta ? this->theta : turn;
    this->width = wide <= this->width ? this->width : wide;
    this->positionSum += aside * aside;
    this->thetaSum += turn * turn;
    this->widthSum += wide * wide;
    this->count += 1.0;
  }

  double rms(double sum) const { return std::sqrt(sum / this->count); }
};

/** Range of the partial sums of something that changes sign on its way. */
struct Swing
{
  double sum = 0.0;
  double low = 0.0;
  double high = 0.0;

  void add(double change)
  {
    this->sum += change;
    this->low = std::min(this->low, this->sum);
    this->high = std::max(this->high, this->sum);
  }
  double range() const { return this->high - this->low; }
};

/** What a grid's errors along the paths do to their rays, in first order. */
struct GridBounds
{
  double theta = 0.0;
  double position = 0.0;
  double width = 0.0;
};

/**
 * With e the spline less the formula and n the normal of the ray, a heading changes by the integral of (C_h/C) n.grad e ds, a
 * place by that times the way, and along the ray by the integral of (C_h/C) e ds, the rate of a tube by that of
 * (C_h/C) e_nn ds; on a current 1/Cg and the error of the current along the wave take the places of C_h/C and e. Later
 * refraction makes these grow as it makes a tube wider.
 */
GridBounds boundsOf(const RayScene& exact, const RayScene& gridded, double spacing, const Setting& setting)
{
  const RayMedium medium = mediumOf(exact, setting);
  const double omega = medium.angularFrequency;
  GridBounds bounds;
  for (const Track& track : exact.tracks)
  {
    Swing theta;
    Swing rate;
    Swing along;
    double widest = 1.0;
    glm::dvec2 from = track.start(medium).position;
    double way = 0.0;
    for (const Place& place : track.places)
    {
      const glm::dvec2 to(place.x, place.y);
      // Some places a cell: errors change sign within one.
      const auto parts = static_cast<int>(std::ceil(8.0 * glm::distance(from, to) / spacing)) + 1;
      const double ds = (place.length - way) / parts;
      const glm::dvec2 t = (to - from) / glm::distance(from, to);
      const glm::dvec2 n(-t.y, t.x);
      for (int i = 0; i < parts; ++i)
      {
        const glm::dvec2 p = from + (i + 0.5) / parts * (to - from);
        const BedSample a = exact.seafloor->bed(p);
        const BedSample b = gridded.seafloor->bed(p);
        const double k = static_cast<double>(reference::wavenumber(omega, -a.elevation));
        const double bending = static_cast<double>(-reference::wavenumberSlope(omega, -a.elevation)) / k;
        theta.add(bending * glm::dot(n, b.gradient - a.gradient) * ds);
        along.add(bending * (b.elevation - a.elevation) * ds);
        rate.add(
          bending * (n.x * n.x * (b.xx - a.xx) + 2.0 * n.x * n.y * (b.xy - a.xy) + n.y * n.y * (b.yy - a.yy)) * ds);
        if (exact.current)
        {
          CurrentSample u;
          CurrentSample v;
          exact.current->evaluate(p, u);
          gridded.current->evaluate(p, v);
          // Of the wave where it is, not in still water; against the current it is the slower the more its length answers.
          const reference::Real own = place.wavenumber;
          const double group = static_cast<double>(
            reference::groupSpeed(std::sqrt(reference::Gravity * own * std::tanh(own * -a.elevation)), -a.elevation));
          const double speed = std::min(group, std::abs(group + glm::dot(t, u.velocity)));
          const double slowness = 1.0 / group;
          along.add(group / (speed * speed) * glm::dot(t, v.velocity - u.velocity) * ds);
          theta.add(slowness * glm::dot(t, n.x * (v.dx - u.dx) + n.y * (v.dy - u.dy)) * ds);
          rate.add(slowness *
            glm::dot(t, n.x * n.x * (v.dxx - u.dxx) + 2.0 * n.x * n.y * (v.dxy - u.dxy) + n.y * n.y * (v.dyy - u.dyy)) *
            ds);
        }
      }
      from = to;
      way = place.length;
      widest = std::max(widest, std::abs(place.width));
    }
    const double grown = BoundFactor * (1.0 + widest);
    bounds.theta = std::max(bounds.theta, grown * theta.range());
    bounds.position = std::max(bounds.position, grown * (theta.range() * way + along.range()));
    bounds.width = std::max(bounds.width, grown * rate.range() * way);
  }
  return bounds;
}

constexpr const char* Rounding = "none: rays go straight on whatever the grid does";
constexpr const char* NoWidth = "none: where the slope jumps the curvature is wrong by O(1/d) over O(d) of the way";
// A fit over few spacings is that far from the order in the limit.
constexpr double FitSlack = 0.25;

Rectangle boxAround(const RayScene& scene, const GridPlan& plan, const Setting& setting)
{
  const RayMedium medium = mediumOf(scene, setting);
  Rectangle box{ glm::dvec2(std::numeric_limits<double>::infinity()),
    glm::dvec2(-std::numeric_limits<double>::infinity()) };
  const auto include = [&box](const glm::dvec2& p)
  {
    box.low = glm::min(box.low, p);
    box.high = glm::max(box.high, p);
  };
  for (const Track& track : scene.tracks)
  {
    include(track.start(medium).position);
    for (const Place& place : track.places)
    {
      include({ place.x, place.y });
    }
  }
  // The ends of a spline are felt for some cells.
  const glm::dvec2 margin(10.0 * plan.spacings.front());
  const Rectangle most = scene.seafloor->bounds();
  box.low = glm::max(glm::max(box.low - margin, most.low), plan.within.low);
  box.high = glm::min(glm::min(box.high + margin, most.high), plan.within.high);
  return box;
}

}

GridRates gridRates(GridOrder order)
{
  switch (order)
  {
  case GridOrder::Straight:
    return { 4.0, 4.0,
      "4: along straight contours the wavenumber is kept, so that a heading knows the depth alone, which a cubic "
      "spline "
      "has to order 4 (de Boor 1978)",
      "4: along straight contours the width is a cosine of the heading" };
  case GridOrder::Turning:
    return { 3.5, 3.5, "3.5: order 4 as along any straight contours, less the root of the cell in which the ray turns",
      "3.5: as the heading" };
  case GridOrder::Kinked:
    return { 1.0, 0.0, "1: where the slope jumps the spline's gradient is wrong by O(1) over O(d) of the way",
      NoWidth };
  case GridOrder::Exact:
  case GridOrder::Curved:
    break;
  }
  return { 3.0, 2.0, "3: that of the gradient of a cubic spline (Hall and Meyer 1976), which bends the ray",
    "2: that of the curvature of a cubic spline (Hall and Meyer 1976), which widens the tube" };
}

void addFittedOrder(
  const std::string& quantity, const Series& errors, double derived, const char* reason, Plot& plot, Outcome& outcome)
{
  const double order = fittedOrder(errors.x, errors.y);
  outcome.checks.push_back({ quantity, order, derived > 0.0 ? derived - FitSlack : 0.0, reason,
    derived > 0.0 ? Check::Ask::AtLeast : Check::Ask::Nothing });
  Series line = fittedLine(errors, order);
  line.name = "";
  plot.series.push_back(line);
  plot.series.push_back(errors);
  plot.series.back().name += fmt::format(", order {:.2f}", order);
}

GridPlan planFor(GridOrder order)
{
  GridPlan plan;
  plan.order = order;
  switch (order)
  {
  case GridOrder::Exact:
    break;
  case GridOrder::Straight:
  case GridOrder::Turning:
    plan.offsets = { 0.12, 0.37, 0.62, 0.87 };
    break;
  case GridOrder::Curved:
    plan.offsets = { 0.37, 0.0, 0.61 };
    break;
  case GridOrder::Kinked:
    // What is wrong in the one cell of the kink is not evened out along a ray.
    plan.offsets = { 0.37, 0.0, 0.61, 0.18, 0.5, 0.83, 0.72 };
    break;
  }
  return plan;
}

ElevationGrid sampledGrid(const std::function<double(const glm::dvec2&)>& elevation, const Rectangle& box,
  const glm::dvec2& spacing, double offset)
{
  ElevationGrid grid;
  // The same place of a cell lies on the origin, whatever the spacing.
  grid.origin = (glm::ceil(box.low / spacing) + offset) * spacing;
  grid.spacing = spacing;
  const glm::dvec2 cells = glm::floor((box.high - grid.origin) / spacing);
  grid.columns = static_cast<std::size_t>(cells.x) + 1;
  grid.rows = static_cast<std::size_t>(cells.y) + 1;
  grid.elevation.resize(grid.columns * grid.rows);
  for (std::size_t j = 0; j < grid.rows; ++j)
  {
    for (std::size_t i = 0; i < grid.columns; ++i)
    {
      grid.at(i, j) = elevation(grid.node(i, j));
    }
  }
  return grid;
}

GriddedScene::GriddedScene(
  const RayScene& scene, const GridPlan& plan, double spacing, double offset, const Setting& setting)
  : Gridded(scene)
{
  const Rectangle box = boxAround(scene, plan, setting);
  const Rectangle gridBox = turnedBox(box, -plan.turn);
  // Straight contours run along y: few nodes are enough there.
  const bool straight = plan.order == GridOrder::Straight || plan.order == GridOrder::Turning;
  const glm::dvec2 apart(spacing, straight ? std::max(spacing, 0.02 * gridBox.size().y) : spacing);
  if (scene.current)
  {
    const auto component = [&](int index) {
      return sampledGrid(
        [&](const glm::dvec2& p) { return scene.current->velocity(p)[index]; }, gridBox, apart, offset);
    };
    this->Water = std::make_unique<SplineCurrent>(component(0), component(1));
    this->Gridded.current = this->Water.get();
    return;
  }
  const auto elevation = [&](const glm::dvec2& p)
  {
    const glm::dvec2 own = turned(p, plan.turn);
    Place place;
    place.x = own.x;
    place.y = own.y;
    return -scene.depth(place);
  };
  this->Bed = std::make_unique<TurnedSeafloor>(sampledGrid(elevation, gridBox, apart, offset), plan.turn, box);
  this->Used = std::make_unique<WrongSeafloor>(*this->Bed, setting);
  this->Gridded.seafloor = this->Used.get();
}

GriddedScene::~GriddedScene() = default;

void addGridConvergence(const RayScene& scene, const GridPlan& plan, const Setting& setting, Outcome& outcome)
{
  const bool exact = plan.order == GridOrder::Exact;
  const GridRates derived = gridRates(plan.order);
  Series position{ "position (m)", Series::Look::Dots, {}, {} };
  Series theta{ "heading (rad)", Series::Look::Dots, {}, {} };
  Series width{ "tube width (relative)", Series::Look::Dots, {}, {} };
  std::vector<Check>& checks = outcome.checks;
  for (const double spacing : plan.spacings)
  {
    GridErrors errors;
    GridBounds bounds;
    for (const double offset : plan.offsets)
    {
      const GriddedScene made(scene, plan, spacing, offset, setting);
      const RayScene& gridded = made.scene();
      const GridBounds now = boundsOf(scene, gridded, spacing, setting);
      bounds.position = std::max(bounds.position, now.position);
      bounds.theta = std::max(bounds.theta, now.theta);
      bounds.width = std::max(bounds.width, now.width);
      const RayMedium medium = mediumOf(gridded, setting);
      for (const Track& track : scene.tracks)
      {
        HamiltonianRay ray(medium, track.start(medium), GridTolerance);
        RayPoint point;
        for (const Place& place : track.places)
        {
          if (!ray.advance(scene.by, targetOf(scene, place), point))
          {
            point.position = glm::dvec2(std::nan(""));
          }
          errors.add(point, place);
        }
      }
    }
    const std::string at = fmt::format(", grid of {:g} m", spacing);
    if (exact)
    {
      const RayLimits limits;
      const std::string reason = "a cubic spline reproduces this bed at any spacing: as on the formula";
      checks.push_back({ "position (m)" + at, errors.position, 10.0 * limits.position, reason });
      checks.push_back({ "heading (rad)" + at, errors.theta, 10.0 * limits.relative, reason });
      checks.push_back({ "tube width (relative)" + at, errors.width, 10.0 * limits.width, reason });
    }
    else
    {
      const std::string reason =
        "what the spline's errors along the path do in first order, times 2 and the growth of the tube";
      const bool kinked = plan.order == GridOrder::Kinked;
      checks.push_back({ "position (m)" + at, errors.position, bounds.position, reason });
      checks.push_back({ "heading (rad)" + at, errors.theta, bounds.theta, plan.symmetric ? Rounding : reason,
        plan.symmetric ? Check::Ask::Nothing : Check::Ask::AtMost });
      checks.push_back({ "tube width (relative)" + at, errors.width, bounds.width,
        plan.symmetric ? Rounding
          : kinked     ? NoWidth
                       : reason,
        plan.symmetric || kinked ? Check::Ask::Nothing : Check::Ask::AtMost });
    }
    position.add(spacing, plan.largest ? errors.position : errors.rms(errors.positionSum));
    theta.add(spacing, plan.largest ? errors.theta : errors.rms(errors.thetaSum));
    width.add(spacing, plan.largest ? errors.width : errors.rms(errors.widthSum));
  }
  outcome.grids.columns = { "spacing_m", "position_m", "theta_rad", "width" };
  for (std::size_t i = 0; i < position.x.size(); ++i)
  {
    outcome.grids.rows.push_back({ position.x[i], position.y[i], theta.y[i], width.y[i] });
  }
  Plot plot{ "on grids", "spacing (m)", plan.largest ? "largest error" : "error, root mean square", {}, true, false };
  if (exact)
  {
    plot.title = "on grids: as on the formula";
    plot.series = { position, theta, width };
    outcome.plots.push_back(plot);
    return;
  }
  const auto derivedOrder = [&](double order) { return plan.symmetric ? 0.0 : order; };
  addFittedOrder("order of position in the spacing", position, derived.path, derived.pathReason, plot, outcome);
  addFittedOrder("order of heading in the spacing", theta, derivedOrder(derived.path),
    plan.symmetric ? Rounding : derived.pathReason, plot, outcome);
  addFittedOrder("order of tube width in the spacing", width, derivedOrder(derived.width),
    plan.symmetric ? Rounding : derived.widthReason, plot, outcome);
  outcome.plots.push_back(plot);
}

}
