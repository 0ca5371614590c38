#pragma once

#include "RayRun.h"

#include "sim/ElevationGrid.h"

#include <limits>
#include <memory>

namespace swellray::validation
{

/** Why a grid is as good as it is. */
enum class GridOrder
{
  Exact,    ///< the spline is the formula: a polynomial of degree 3 and less
  Straight, ///< the formula varies along one axis of the grid
  Turning,  ///< the same, and rays turn back
  Curved,   ///< a smooth bed, the contours at any angle to the grid
  Kinked,   ///< its slope jumps across a curve at any angle to the grid
};

/** Orders of the errors of rays that follow from the smoothness of a bed, and why. */
struct GridRates
{
  double path;  ///< of positions and headings
  double width; ///< of tubes; 0: none
  const char* pathReason;
  const char* widthReason;
};

GridRates gridRates(GridOrder order);

/**
 * Fit the order in which errors fall with the spacing, ask for the one that is derived (0: ask nothing), and draw both.
 */
void addFittedOrder(
  const std::string& quantity, const Series& errors, double derived, const char* reason, Plot& plot, Outcome& outcome);

/** How a scene is put on grids. */
struct GridPlan
{
  GridOrder order = GridOrder::Curved;
  std::vector<double> spacings;        ///< m, from coarse to fine
  double turn = 0.0;                   ///< of the grid, rad, anticlockwise
  std::vector<double> offsets{ 0.37 }; ///< of the nodes, in spacings: errors are taken over all of these
  bool largest = false;                ///< fit the orders to the largest errors, not to root mean squares
  /** The grid covers no more than this, m: where the formula is smooth. */
  Rectangle within{ glm::dvec2(-std::numeric_limits<double>::infinity()),
    glm::dvec2(std::numeric_limits<double>::infinity()) };
  bool symmetric = false; ///< rays go straight on whatever the grid does: only their place along the way has an error
};

/** A plan with offsets over which the errors within a cell even out. */
GridPlan planFor(GridOrder order);

/**
 * Elevations of a formula at the nodes in the box, `spacing` apart, of which the one next to (0, 0) would lie `offset`
 * spacings to the north-east of it.
 */
ElevationGrid sampledGrid(const std::function<double(const glm::dvec2&)>& elevation, const Rectangle& box,
  const glm::dvec2& spacing, double offset);

/** A scene whose seafloor, or current where there is one, is the spline of its formula's values at nodes. */
class GriddedScene
{
public:
  /** @param offset of the nodes from multiples of the spacing, in spacings */
  GriddedScene(const RayScene& scene, const GridPlan& plan, double spacing, double offset, const Setting& setting);
  GriddedScene(const GriddedScene&) = delete;
  void operator=(const GriddedScene&) = delete;
  ~GriddedScene();

  const RayScene& scene() const { return this->Gridded; }

private:
  RayScene Gridded;
  std::unique_ptr<const Seafloor> Bed;
  std::unique_ptr<const Seafloor> Used;
  std::unique_ptr<const Current> Water;
};

/**
 * The same rays over the seafloor, or current, of the scene sampled at the nodes of grids: errors against their bounds at
 * each spacing, and the order in which they fall.
 */
void addGridConvergence(const RayScene& scene, const GridPlan& plan, const Setting& setting, Outcome& outcome);

}
