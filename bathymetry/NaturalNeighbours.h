#pragma once

#include <glm/vec2.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace swellray
{

/**
 * Natural neighbours of scattered places, by their Delaunay triangulation. Reading members may be called from several
 * threads at once, and give the same for any order of calls.
 */
class NaturalNeighbours
{
public:
  /**
   * @param places n points, no two the same
   * @throws std::runtime_error fewer than 3 places, or all on one line
   */
  explicit NaturalNeighbours(const std::vector<glm::dvec2>& places);
  ~NaturalNeighbours();

  /** What the places say about a point. */
  struct Estimate
  {
    double value = 0.0;    ///< interpolated; NaN outside the convex hull of the places
    double distance = 0.0; ///< to the nearest place, or as said; not set outside
  };

  /** Interpolates at points one after the other, best near each other: each search begins where the last one ended. */
  class Walk
  {
  public:
    explicit Walk(const NaturalNeighbours& places);
    ~Walk();

    /**
     * Sibson's mean of the values of the natural neighbours of a point. On the rim of the convex hull (to a
     * ten-millionth of its edge) linear between the ends of the edge.
     * @param values n values, one a place
     */
    Estimate at(const glm::dvec2& point, const std::vector<double>& values);

  private:
    struct Impl;
    std::unique_ptr<Impl> Data;
  };

  /**
   * Sibson's mean at a place without its own value, and the mean distance of the natural neighbours, weighted alike; NaN
   * where it is a corner of the convex hull, or was removed.
   */
  Estimate leftOut(std::size_t place, const std::vector<double>& values) const;

  /** Places that share an edge with this one, into `neighbours`. */
  void neighboursOf(std::size_t place, std::vector<std::uint32_t>& neighbours) const;

  /** Take a place out; at least 3 that are not on one line must stay. */
  void remove(std::size_t place);

  /** Put a place that was removed back where it was. */
  void restore(std::size_t place, const glm::dvec2& point);

  /** A triangle between three places that no fourth lies in the circle of. */
  struct Triangle
  {
    double area = 0.0;
    double radius = 0.0; ///< of its circle: half the width of the gap that it spans
  };

  std::vector<Triangle> triangles() const;

  /** Root mean square, over all edges, of the difference of values over the distance. */
  double rmsSlope(const std::vector<double>& values) const;

private:
  struct Impl;
  std::unique_ptr<Impl> Data;
};

}
