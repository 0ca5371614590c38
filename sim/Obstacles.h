#pragma once

#include "sim/Seafloor.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace swellray
{

/** A vertical wall: a breakwater, a quay, a shore. */
struct Obstacle
{
  /**
   * Corners in their order, m. A ring does not repeat its first one; land lies to the left of it (anticlockwise around
   * land, clockwise around water that land encloses).
   */
  std::vector<glm::dvec2> points;
  bool closed = false;     ///< a ring; otherwise a line, a wall without thickness
  double reflection = 0.0; ///< height of the reflected wave over that of the incident one, 0 to 1
  double slope = 0.0;      ///< of its faces, rise over run; 0: vertical. Only spray feels it
};

/** A piece of a path: position(theta) = sum of coefficients[i] theta^i for 0 <= theta <= 1, m. */
struct PathPiece
{
  std::array<glm::dvec2, 5> coefficients{};
};

/** Where a path meets a wall. */
struct WallHit
{
  double theta = 0.0;       ///< on the piece of the path
  std::size_t wall = 0;     ///< index of the wall's straight segment
  double side = 1.0;        ///< 1: the path comes from the left of the segment, -1: from its right
  glm::dvec2 normal{ 0.0 }; ///< unit normal of the wall, to the side that the path comes from
  double reflection = 0.0;  ///< of the obstacle
  double slope = 0.0;       ///< of its faces, rise over run; 0: vertical
  std::size_t obstacle = 0; ///< index of the obstacle
  bool corner = false;      ///< at a corner, or the free end of a line: there is no one direction to be reflected to
};

/**
 * Walls that stand in the water, as straight segments in a tree of rectangles over contiguous arrays. Looking for
 * hits allocates nothing. All members may be called from several threads at once.
 */
class Obstacles
{
public:
  Obstacles() = default;

  /**
   * Segments shorter than a micrometre are left out.
   * @throws std::invalid_argument an obstacle of fewer than 2 points (a ring: 3), a coordinate that is not finite, a
   *   reflection coefficient or a slope out of range, naming it
   */
  explicit Obstacles(const std::vector<Obstacle>& obstacles);

  bool empty() const { return this->Segments.empty(); }
  /** Number of straight segments. */
  std::size_t segmentCount() const { return this->Segments.size(); }
  /** True where something reflects. */
  bool anyReflects() const { return this->AnyReflects; }

  /**
   * First place where the path crosses a wall, to rounding: the crossings are the roots of a quartic polynomial
   * between its extremes. A path that only touches a wall has not met it.
   * @param until look no further on the piece than this, 0 to 1
   * @param leaving wall on which the path starts, having been reflected there to the side `leavingSide`; it is met again
   *   only from that side
   */
  std::optional<WallHit> firstHit(
    const PathPiece& path, double until = 1.0, std::optional<std::size_t> leaving = {}, double leavingSide = 1.0) const;

  /**
   * True where the straight way from a to b crosses a wall. A way that ends within a micrometre of a wall does not
   * cross it.
   */
  bool crosses(const glm::dvec2& a, const glm::dvec2& b) const;

  /** True on the land inside of rings: where they wind around the place. Lines have no inside. */
  bool inside(const glm::dvec2& p) const;

private:
  struct Segment
  {
    glm::dvec2 from{ 0.0 };
    glm::dvec2 to{ 0.0 };
    std::size_t obstacle = 0;
    double reflection = 0.0;
    double slope = 0.0;
    bool closed = false;
    bool cornerFrom = false; // the wall turns there
    bool cornerTo = false;
  };

  // Of a leaf the segments from first on, otherwise two nodes: the next one, and `second`.
  struct Node
  {
    Rectangle box;
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::uint32_t second = 0;
  };

  void addSegments(const Obstacle& obstacle, std::size_t index);
  void build(std::uint32_t first, std::uint32_t count);
  template <typename Overlaps, typename Visit>
  void visit(const Overlaps& overlaps, const Visit& visitSegment) const;

  std::vector<Segment> Segments;
  std::vector<Node> Nodes;
  bool AnyReflects = false;
};

}
