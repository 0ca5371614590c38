#include "sim/SplineSeafloor.h"

#include "sim/ConvexOutline.h"
#include "sim/FillHoles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace swellray
{

namespace
{

constexpr std::size_t BlockCells = 8;
constexpr double FeatureCells = 8.0;

void check(const ElevationGrid& grid)
{
  std::ostringstream message;
  if (grid.columns < 4 || grid.rows < 4)
  {
    message << "the grid must have at least 4 x 4 nodes, not " << grid.columns << " x " << grid.rows;
  }
  else if (grid.elevation.size() / grid.columns != grid.rows || grid.elevation.size() % grid.columns != 0)
  {
    message << "a grid of " << grid.columns << " x " << grid.rows << " nodes needs as many elevations, not "
            << grid.elevation.size();
  }
  else if (!(grid.spacing.x > 0.0 && grid.spacing.y > 0.0) || !std::isfinite(grid.spacing.x + grid.spacing.y))
  {
    message << "the grid spacing must be above 0 m, not " << grid.spacing.x << " x " << grid.spacing.y;
  }
  else if (!std::isfinite(grid.origin.x + grid.origin.y))
  {
    message << "the grid origin must be finite, not " << grid.origin.x << ", " << grid.origin.y;
  }
  else
  {
    return;
  }
  throw std::invalid_argument(message.str());
}

/**
 * Coefficients of `lines` interpolating splines at once. Node i of line l lies at data[(i + 1) * step + l * stride],
 * i = 0 to nodes - 1, and is replaced by its coefficient; those of i = -1 and i = nodes are written beside.
 *
 * With unit spacing not-a-knot makes the fourth difference of the first five coefficients vanish, so that
 * c_1 = (8 z_1 - z_0 - z_2)/6; then c_0 = 6 z_1 - 4 c_1 - c_2 and c_{-1} = 6 z_0 - 4 c_0 - c_1, and in the same way at
 * the other end. Between them (c_{i-1} + 4 c_i + c_{i+1})/6 = z_i is solved by elimination.
 */
void interpolate(double* data, std::size_t nodes, std::size_t step, std::size_t lines, std::size_t stride)
{
  const auto forLines = [&](std::size_t node, const auto& body)
  {
    double* const p = data + (node + 1) * step; // of this node in the first line
    for (std::size_t l = 0; l < lines; ++l)
    {
      body(p + l * stride);
    }
  };
  const std::ptrdiff_t d = static_cast<std::ptrdiff_t>(step);
  const std::size_t last = nodes - 1;

  // The outermost two data of each end wait in the places of c_{-1}, c_0 until they are used.
  forLines(1,
    [d](double* p)
    {
      const double z = p[0];
      p[0] = (8.0 * z - p[-d] - p[d]) / 6.0;
      p[-2 * d] = z;
    });
  if (nodes == 4)
  {
    // Both ends share their data: z_1 was set aside above.
    forLines(2,
      [d](double* p)
      {
        const double z = p[0];
        p[0] = (8.0 * z - p[d] - p[-3 * d]) / 6.0;
        p[2 * d] = z;
      });
  }
  else
  {
    forLines(last - 1,
      [d](double* p)
      {
        const double z = p[0];
        p[0] = (8.0 * z - p[-d] - p[d]) / 6.0;
        p[2 * d] = z;
      });
  }

  std::vector<double> pivot(nodes, 0.0); // inverse pivots; 0 starts at the known c_1
  for (std::size_t i = 2; i + 2 < nodes; ++i)
  {
    const double inverse = 1.0 / (4.0 - pivot[i - 1]);
    pivot[i] = inverse;
    forLines(i, [d, inverse](double* p) { p[0] = (6.0 * p[0] - p[-d]) * inverse; });
  }
  for (std::size_t i = last - 1; i-- > 2;)
  {
    const double inverse = pivot[i];
    forLines(i, [d, inverse](double* p) { p[0] -= inverse * p[d]; });
  }

  forLines(0,
    [d](double* p)
    {
      const double z = p[0];
      p[0] = 6.0 * p[-d] - 4.0 * p[d] - p[2 * d];
      p[-d] = 6.0 * z - 4.0 * p[0] - p[d];
    });
  forLines(last,
    [d](double* p)
    {
      const double z = p[0];
      p[0] = 6.0 * p[d] - 4.0 * p[-d] - p[-2 * d];
      p[d] = 6.0 * z - 4.0 * p[0] - p[-d];
    });
}

}

SplineSeafloor::SplineSeafloor(const ElevationGrid& grid)
{
  check(grid);
  this->Bounds = grid.bounds();
  this->Spacing = grid.spacing;
  this->InverseSpacing = 1.0 / grid.spacing;
  this->CellColumns = grid.columns - 1;
  this->CellRows = grid.rows - 1;
  this->LastCell = glm::dvec2(static_cast<double>(this->CellColumns - 1), static_cast<double>(this->CellRows - 1));
  this->CoefficientColumns = grid.columns + 2;
  this->Coefficients.resize(this->CoefficientColumns * (grid.rows + 2));

  const auto place = [&](const ElevationGrid& whole)
  {
    for (std::size_t j = 0; j < whole.rows; ++j)
    {
      std::copy_n(whole.elevation.begin() + static_cast<std::ptrdiff_t>(j * whole.columns), whole.columns,
        this->Coefficients.begin() + static_cast<std::ptrdiff_t>((j + 1) * this->CoefficientColumns + 1));
    }
  };
  const bool complete =
    std::all_of(grid.elevation.begin(), grid.elevation.end(), [](double z) { return std::isfinite(z); });
  if (complete)
  {
    place(grid);
  }
  else
  {
    ElevationGrid filled = grid;
    const std::vector<unsigned char> holeNode = fillHoles(filled);
    this->HoleCell.resize(this->CellColumns * this->CellRows);
    for (std::size_t j = 0; j < this->CellRows; ++j)
    {
      for (std::size_t i = 0; i < this->CellColumns; ++i)
      {
        const unsigned char* node = holeNode.data() + j * grid.columns + i;
        this->HoleCell[j * this->CellColumns + i] = node[0] | node[1] | node[grid.columns] | node[grid.columns + 1];
      }
    }
    place(filled);
  }

  for (std::size_t j = 0; j < grid.rows; ++j)
  {
    interpolate(this->Coefficients.data() + (j + 1) * this->CoefficientColumns, grid.columns, 1, 1, 0);
  }
  interpolate(this->Coefficients.data(), grid.rows, this->CoefficientColumns, this->CoefficientColumns, 1);
  boundBlocks();
}

void SplineSeafloor::boundBlocks()
{
  this->BlockColumns = (this->CellColumns + BlockCells - 1) / BlockCells;
  const std::size_t blockRows = (this->CellRows + BlockCells - 1) / BlockCells;
  this->BlockHighest.resize(this->BlockColumns * blockRows);
  this->BlockLowest.resize(this->BlockColumns * blockRows);
  for (std::size_t bj = 0; bj < blockRows; ++bj)
  {
    const std::size_t rowEnd = std::min((bj + 1) * BlockCells, this->CellRows) + 3;
    for (std::size_t bi = 0; bi < this->BlockColumns; ++bi)
    {
      const std::size_t columnEnd = std::min((bi + 1) * BlockCells, this->CellColumns) + 3;
      double low = std::numeric_limits<double>::infinity();
      double high = -low;
      for (std::size_t j = bj * BlockCells; j < rowEnd; ++j)
      {
        for (std::size_t i = bi * BlockCells; i < columnEnd; ++i)
        {
          const double c = this->Coefficients[j * this->CoefficientColumns + i];
          low = std::min(low, c);
          high = std::max(high, c);
        }
      }
      this->BlockHighest[bj * this->BlockColumns + bi] = high;
      this->BlockLowest[bj * this->BlockColumns + bi] = low;
    }
  }
}

void SplineSeafloor::evaluate(const glm::dvec2& p, unsigned, BedSample& bed) const
{
  const double u = (p.x - this->Bounds.low.x) * this->InverseSpacing.x;
  const double v = (p.y - this->Bounds.low.y) * this->InverseSpacing.y;
  // In this order a position that is not a number gives cell 0 and values that are not numbers.
  const auto i = static_cast<std::ptrdiff_t>(std::min(std::max(0.0, u), this->LastCell.x));
  const auto j = static_cast<std::ptrdiff_t>(std::min(std::max(0.0, v), this->LastCell.y));
  const double s = u - static_cast<double>(i);
  const double t = v - static_cast<double>(j);
  const auto pitch = static_cast<std::ptrdiff_t>(this->CoefficientColumns);
  const double* c = this->Coefficients.data() + j * pitch + i;

  constexpr double sixth = 1.0 / 6.0;
  const auto weights = [](double x, double* w, double* w1, double* w2)
  {
    const double y = 1.0 - x;
    w[0] = sixth * y * y * y;
    w[3] = sixth * x * x * x;
    w[1] = sixth * (4.0 + x * x * (3.0 * x - 6.0));
    w[2] = sixth * (4.0 + y * y * (3.0 * y - 6.0));
    w1[0] = -0.5 * y * y;
    w1[1] = x * (1.5 * x - 2.0);
    w1[2] = y * (2.0 - 1.5 * y);
    w1[3] = 0.5 * x * x;
    w2[0] = y;
    w2[1] = 3.0 * x - 2.0;
    w2[2] = 3.0 * y - 2.0;
    w2[3] = x;
  };
  double ws[4];
  double ws1[4];
  double ws2[4];
  double wt[4];
  double wt1[4];
  double wt2[4];
  weights(s, ws, ws1, ws2);
  weights(t, wt, wt1, wt2);

  // Across the rows first: the loop over the four columns is one over neighbours in memory, two to a register.
  double line[4];
  double slope[4];
  double curve[4];
  const double* c1 = c + pitch;
  const double* c2 = c1 + pitch;
  const double* c3 = c2 + pitch;
  for (int a = 0; a < 4; ++a)
  {
    line[a] = (wt[0] * c[a] + wt[1] * c1[a]) + (wt[2] * c2[a] + wt[3] * c3[a]);
    slope[a] = (wt1[0] * c[a] + wt1[1] * c1[a]) + (wt1[2] * c2[a] + wt1[3] * c3[a]);
    curve[a] = (wt2[0] * c[a] + wt2[1] * c1[a]) + (wt2[2] * c2[a] + wt2[3] * c3[a]);
  }
  const auto along = [](const double* w, const double* f)
  { return (w[0] * f[0] + w[2] * f[2]) + (w[1] * f[1] + w[3] * f[3]); };
  const double value = along(ws, line);
  const double x = along(ws1, line);
  const double xx = along(ws2, line);
  const double y = along(ws, slope);
  const double xy = along(ws1, slope);
  const double yy = along(ws, curve);
  bed.elevation = value;
  bed.gradient = glm::dvec2(x, y) * this->InverseSpacing;
  bed.xx = xx * this->InverseSpacing.x * this->InverseSpacing.x;
  bed.xy = xy * this->InverseSpacing.x * this->InverseSpacing.y;
  bed.yy = yy * this->InverseSpacing.y * this->InverseSpacing.y;
}

double SplineSeafloor::featureLength() const
{
  return FeatureCells * std::min(this->Spacing.x, this->Spacing.y);
}

double SplineSeafloor::resolution() const
{
  return 0.5 * std::min(this->Spacing.x, this->Spacing.y);
}

glm::dvec2 SplineSeafloor::cell(const glm::dvec2& p) const
{
  const glm::dvec2 u = (p - this->Bounds.low) * this->InverseSpacing;
  return { std::floor(std::min(std::max(0.0, u.x), this->LastCell.x)),
    std::floor(std::min(std::max(0.0, u.y), this->LastCell.y)) };
}

std::vector<glm::dvec2> SplineSeafloor::outline() const
{
  return this->HoleCell.empty() ? this->Seafloor::outline()
                                : insetConvex(convexHull(this->dataCorners()), 1.5 * this->cellSize(), this->Bounds);
}

std::vector<glm::dvec2> SplineSeafloor::dataCorners() const
{
  // The first and last cell of a row hold the corners of the hull.
  std::vector<glm::dvec2> corners;
  for (std::size_t j = 0; !this->HoleCell.empty() && j < this->CellRows; ++j)
  {
    const auto row = this->HoleCell.begin() + static_cast<std::ptrdiff_t>(j * this->CellColumns);
    const auto end = row + static_cast<std::ptrdiff_t>(this->CellColumns);
    const auto first = std::find(row, end, 0);
    if (first == end)
    {
      continue;
    }
    const auto last = std::find(std::make_reverse_iterator(end), std::make_reverse_iterator(row), 0).base();
    for (const std::size_t i : { static_cast<std::size_t>(first - row), static_cast<std::size_t>(last - row) })
    {
      for (const std::size_t k : { j, j + 1 })
      {
        // On the last row and column the bounds to the last bit, so that these edges are known to lie on them.
        corners.push_back({ i == this->CellColumns ? this->Bounds.high.x
                                                   : this->Bounds.low.x + this->Spacing.x * static_cast<double>(i),
          k == this->CellRows ? this->Bounds.high.y : this->Bounds.low.y + this->Spacing.y * static_cast<double>(k) });
      }
    }
  }
  return corners;
}

bool SplineSeafloor::isHole(const glm::dvec2& p) const
{
  if (this->HoleCell.empty() || !this->Bounds.contains(p))
  {
    return false;
  }
  const glm::dvec2 at = cell(p);
  return this->HoleCell[static_cast<std::size_t>(at.y) * this->CellColumns + static_cast<std::size_t>(at.x)] != 0;
}

template <typename Choose>
double SplineSeafloor::extreme(const Rectangle& box, const std::vector<double>& blocks, const Choose& choose) const
{
  const glm::dvec2 low = cell(box.low);
  const glm::dvec2 high = cell(box.high);
  const auto block = [](double index) { return static_cast<std::size_t>(index) / BlockCells; };
  double result = blocks[block(low.y) * this->BlockColumns + block(low.x)];
  for (std::size_t j = block(low.y); j <= block(high.y); ++j)
  {
    for (std::size_t i = block(low.x); i <= block(high.x); ++i)
    {
      result = choose(result, blocks[j * this->BlockColumns + i]);
    }
  }
  return result;
}

double SplineSeafloor::highestElevation(const Rectangle& box) const
{
  return extreme(box, this->BlockHighest, [](double a, double b) { return std::max(a, b); });
}

double SplineSeafloor::lowestElevation(const Rectangle& box) const
{
  return extreme(box, this->BlockLowest, [](double a, double b) { return std::min(a, b); });
}

}
