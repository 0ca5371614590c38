#pragma once

#include <glm/vec2.hpp>

#include <cstddef>
#include <vector>

namespace swellray
{

/** Axis-aligned rectangle, metres. */
struct Rectangle
{
  glm::dvec2 low{ 0.0 };
  glm::dvec2 high{ 0.0 };

  glm::dvec2 size() const { return high - low; }
  bool contains(const glm::dvec2& p) const { return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y; }
};

/** Elevation of the bed and its first and second derivatives at a point. */
struct BedSample
{
  double elevation = 0.0;     ///< m, positive up
  glm::dvec2 gradient{ 0.0 }; ///< m/m
  double xx = 0.0;            ///< second derivatives, 1/m
  double xy = 0.0;
  double yy = 0.0;
};

/**
 * A seafloor as a function: twice continuously differentiable, except across the kink curves that it
 * declares, where the elevation is continuous and its gradient jumps (the toe of an island, the rim of
 * a shoal).
 *
 * Kink curve i is the zero set of a level function; bit i of a region is set where that level is
 * positive. evaluate() takes the region and gives the smooth formula of that side, also a little across
 * the curve, so that an integration step can end exactly on it. A seafloor without kinks has the one
 * region 0.
 *
 * All members may be called from several threads at once.
 */
class Seafloor
{
public:
  virtual ~Seafloor() = default;

  /** Extent of the scene, m. Rays end where they leave it. */
  virtual Rectangle bounds() const = 0;

  /**
   * Bed at p by the formula of `region`. Defined in the bounds and, as a smooth continuation, a little
   * outside of them.
   */
  virtual void evaluate(const glm::dvec2& p, unsigned region, BedSample& bed) const = 0;

  /**
   * Length over which the bed may change its shape unseen by an integrator that looks at six points a
   * step: no step is longer than this where waves feel the bottom. Grid: some cells. m, > 0.
   */
  virtual double featureLength() const = 0;

  /** Length at which a line over this seafloor is looked at for land and holes, m (grid: half a cell). */
  virtual double resolution() const = 0;

  /** Size of the grid's cells, the larger of the two, m; 0 for a formula. */
  virtual double cellSize() const { return 0.0; }

  /**
   * Outline of the scene as a convex polygon, clockwise, m: the edges through which waves come in. The bounds,
   * unless the seafloor's data end before them.
   */
  virtual std::vector<glm::dvec2> outline() const;

  /** Number of kink curves, at most 32. */
  virtual unsigned kinkCount() const { return 0; }

  /** Level function of kink curve i at p (any unit) and its gradient; the kink is where it is 0. */
  virtual double kinkLevel(unsigned i, const glm::dvec2& p, glm::dvec2& gradient) const;

  /** True where the seafloor has holes (no data, too wide to fill). */
  virtual bool hasHoles() const { return false; }

  /** True inside a hole. A ray that enters one ends. */
  virtual bool isHole(const glm::dvec2&) const { return false; }

  /** An upper bound of the elevation in the box; +infinity where none is known. Used to skip looking for land. */
  virtual double highestElevation(const Rectangle& box) const;

  /** A lower bound of the elevation in the box; -infinity where none is known. */
  virtual double lowestElevation(const Rectangle& box) const;

  /** Region of p: bit i is set where level i is positive. */
  unsigned region(const glm::dvec2& p) const;

  /** Elevation at p, m, positive up. */
  double elevation(const glm::dvec2& p) const;

  /** Bed at p by the formula that holds there. */
  BedSample bed(const glm::dvec2& p) const;
};

/**
 * Plane z = a + b.x fitted by least squares to the wet part of a seafloor.
 */
struct BedPlane
{
  glm::dvec2 slope{ 0.0 }; ///< gradient of the elevation, m/m
  bool valid = false;      ///< false where the scene has no water
};

/**
 * Fit a plane to the wet elevations on a regular set of samples.
 * @param waterLevel m, positive up; wet where the elevation is below it
 * @param samples points along each axis, >= 2
 */
BedPlane fitWetPlane(const Seafloor& seafloor, double waterLevel, std::size_t samples = 200);

}
