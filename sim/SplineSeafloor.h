#pragma once

#include "sim/ElevationGrid.h"
#include "sim/Seafloor.h"

#include <vector>

namespace swellray
{

/**
 * Gridded seafloor: interpolating uniform cubic B-spline of the elevation, C2, with not-a-knot ends.
 *
 *   z(x, y) = sum_ij c_ij B(x/dx - i) B(y/dy - j),  (c_{i-1} + 4 c_i + c_{i+1})/6 = z_i in each direction
 *
 * Error for a smooth bed: O(d^4) in elevation, O(d^3) in its gradient, O(d^2) in its second derivatives
 * (de Boor 1978, A Practical Guide to Splines, ch. V).
 *
 * Nodes that are NaN (or infinite) are holes: every cell that touches one is a hole. The spline needs numbers
 * there and takes a smooth continuation of the elevations around (fillHoles). Outside the bounds the
 * polynomials of the edge cells go on.
 */
class SplineSeafloor final : public Seafloor
{
public:
  /**
   * @param grid at least 4 x 4 nodes, spacing > 0, columns x rows elevations
   * @throws std::invalid_argument otherwise, or where no node has an elevation
   */
  explicit SplineSeafloor(const ElevationGrid& grid);

  Rectangle bounds() const override { return this->Bounds; }
  void evaluate(const glm::dvec2& p, unsigned region, BedSample& bed) const override;
  double featureLength() const override;
  double resolution() const override;
  double cellSize() const override { return this->Spacing.x > this->Spacing.y ? this->Spacing.x : this->Spacing.y; }
  /** With holes: the convex hull of the cells with data, one and a half cells further in where it cuts cells. */
  std::vector<glm::dvec2> outline() const override;
  /** With holes: corners of cells with data, among them all corners of the convex hull of these cells. */
  std::vector<glm::dvec2> dataCorners() const;
  bool hasHoles() const override { return !this->HoleCell.empty(); }
  bool isHole(const glm::dvec2& p) const override;
  /**
   * Bounds from the coefficients of blocks of 8 x 8 cells (a B-spline lies in the convex hull of its
   * coefficients); of a box that is partly outside they hold for the part inside.
   */
  double highestElevation(const Rectangle& box) const override;
  double lowestElevation(const Rectangle& box) const override;

private:
  void boundBlocks();
  glm::dvec2 cell(const glm::dvec2& p) const; // column and row, whole numbers in the grid
  template <typename Choose>
  double extreme(const Rectangle& box, const std::vector<double>& blocks, const Choose& choose) const;

  Rectangle Bounds;
  glm::dvec2 Spacing{ 1.0 };
  glm::dvec2 InverseSpacing{ 1.0 };
  glm::dvec2 LastCell{ 0.0 }; // its column and row
  std::size_t CellColumns = 0;
  std::size_t CellRows = 0;
  std::size_t CoefficientColumns = 0;  // cells + 3
  std::vector<double> Coefficients;    // (cells + 3) in each direction, x fastest
  std::vector<unsigned char> HoleCell; // one a cell; empty without holes
  std::size_t BlockColumns = 0;
  std::vector<double> BlockHighest; // bounds of the spline over blocks of cells
  std::vector<double> BlockLowest;
};

}
