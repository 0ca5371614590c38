#pragma once

#include "sim/SurfaceSheet.h"

#include <glm/vec2.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace swellray
{

/** A triangle of a sheet that covers a place, and the place's barycentric coordinates in it. */
struct SheetCover
{
  std::array<std::int64_t, 3> corner{};
  std::array<double, 3> weight{};
};

/** Finds the triangles between rays that cover a place; where sheets cross there are several. */
class SheetLocator
{
public:
  /** The sheet must outlive this. */
  explicit SheetLocator(const SurfaceSheet& sheet);

  /**
   * Put the triangles over a place into `covers`, in the order of the sheet. Of those with a common edge there is one.
   * Allocates nothing once `covers` has grown.
   */
  void find(const glm::dvec2& place, std::vector<SheetCover>& covers) const;

private:
  // Cells that a triangle's box touches: first and last of either axis.
  std::array<std::size_t, 4> cellsOf(const std::array<std::int64_t, 3>& triangle) const;
  std::size_t column(double x) const;
  std::size_t row(double y) const;

  const SurfaceSheet& Sheet;
  Rectangle Bounds;
  double Nudge = 0.0;
  double CellSize = 1.0;
  std::size_t Columns = 0;
  std::size_t Rows = 0;
  std::vector<std::uint32_t> Offsets; // one a cell, and one more
  std::vector<std::uint32_t> Items;   // triangles
};

}
