#include "sim/FillHoles.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace swellray
{

namespace
{

// The influence of a node on the cubic spline falls by 0.268 a node: at 8 nodes from the data it is 3e-5.
constexpr unsigned char BandWidth = 8;

// A start from the coarser grid leaves little to do: more steps change the spline in the good cells by less than what
// the continuation itself is uncertain by.
constexpr int PlateSteps = 60;
constexpr int CurvatureSteps = 60;
constexpr double Reduction = 1e-6;

struct Plane
{
  double mean = 0.0;
  double column = 0.0;
  double row = 0.0;
  double centreColumn = 0.0;
  double centreRow = 0.0;

  double at(std::size_t i, std::size_t j) const
  {
    return this->mean + this->column * (static_cast<double>(i) - this->centreColumn) +
      this->row * (static_cast<double>(j) - this->centreRow);
  }
};

template <typename Body>
void forNodes(const ElevationGrid& grid, const Body& body)
{
  for (std::size_t j = 0; j < grid.rows; ++j)
  {
    for (std::size_t i = 0; i < grid.columns; ++i)
    {
      body(i, j, j * grid.columns + i);
    }
  }
}

// Least squares plane through the nodes that are not holes.
Plane fitPlane(const ElevationGrid& grid, const std::vector<unsigned char>& hole)
{
  Plane plane;
  double count = 0.0;
  forNodes(grid,
    [&](std::size_t i, std::size_t j, std::size_t n)
    {
      if (!hole[n])
      {
        count += 1.0;
        plane.mean += grid.elevation[n];
        plane.centreColumn += static_cast<double>(i);
        plane.centreRow += static_cast<double>(j);
      }
    });
  plane.mean /= count;
  plane.centreColumn /= count;
  plane.centreRow /= count;

  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  double xz = 0.0;
  double yz = 0.0;
  forNodes(grid,
    [&](std::size_t i, std::size_t j, std::size_t n)
    {
      if (!hole[n])
      {
        const double x = static_cast<double>(i) - plane.centreColumn;
        const double y = static_cast<double>(j) - plane.centreRow;
        const double z = grid.elevation[n] - plane.mean;
        xx += x * x;
        xy += x * y;
        yy += y * y;
        xz += x * z;
        yz += y * z;
      }
    });
  const double determinant = xx * yy - xy * xy;
  if (determinant > 1e-12 * xx * yy)
  {
    plane.column = (yy * xz - xy * yz) / determinant;
    plane.row = (xx * yz - xy * xz) / determinant;
  }
  return plane;
}

struct Level
{
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::vector<double> value;
  std::vector<unsigned char> hole;
};

// Hole nodes at most BandWidth nodes (in the larger of the two directions) from a known one.
std::vector<std::size_t> bandNodes(const Level& level)
{
  const std::size_t columns = level.columns;
  constexpr unsigned char far = BandWidth + 1;
  std::vector<unsigned char> distance(level.hole.size());
  std::transform(level.hole.begin(), level.hole.end(), distance.begin(), [](unsigned char h) { return h ? far : 0; });
  // First along the rows, then along the columns: there and back.
  const auto relax = [&](std::size_t n, std::size_t neighbour)
  { distance[n] = std::min<unsigned char>(distance[n], static_cast<unsigned char>(distance[neighbour] + 1)); };
  for (std::size_t j = 0; j < level.rows; ++j)
  {
    for (std::size_t i = 1; i < columns; ++i)
    {
      relax(j * columns + i, j * columns + i - 1);
    }
    for (std::size_t i = columns - 1; i > 0; --i)
    {
      relax(j * columns + i - 1, j * columns + i);
    }
  }
  const auto relaxAround = [&](std::size_t j, std::size_t from)
  {
    for (std::size_t i = 0; i < columns; ++i)
    {
      const std::size_t low = i > 0 ? i - 1 : 0;
      const std::size_t high = std::min(i + 1, columns - 1);
      for (std::size_t a = low; a <= high; ++a)
      {
        relax(j * columns + i, from * columns + a);
      }
    }
  };
  for (std::size_t j = 1; j < level.rows; ++j)
  {
    relaxAround(j, j - 1);
  }
  for (std::size_t j = level.rows - 1; j > 0; --j)
  {
    relaxAround(j - 1, j);
  }

  std::vector<std::size_t> nodes;
  for (std::size_t n = 0; n < distance.size(); ++n)
  {
    if (distance[n] > 0 && distance[n] <= BandWidth)
    {
      nodes.push_back(n);
    }
  }
  return nodes;
}

// Binomial coefficients with alternating signs: the differences of order 0 to 3.
constexpr double Difference[4][4] = { { 1, 0, 0, 0 }, { -1, 1, 0, 0 }, { 1, -2, 1, 0 }, { -1, 3, -3, 1 } };
constexpr double Binomial[4][4] = { { 1, 0, 0, 0 }, { 1, 1, 0, 0 }, { 1, 2, 1, 0 }, { 1, 3, 3, 1 } };

/**
 * Sum of the squared differences of one order, sum_a binomial(order, a) |D_x^a D_y^(order - a) z|^2, over all that lie
 * wholly in the grid: order 2 is the bending energy of a thin plate, order 3 the change of its curvature.
 */
class Roughness
{
public:
  Roughness(int order, std::size_t columns, std::size_t rows)
    : Order(order)
    , Columns(static_cast<std::ptrdiff_t>(columns))
    , Rows(static_cast<std::ptrdiff_t>(rows))
  {
    const std::size_t width = 2 * static_cast<std::size_t>(order) + 1;
    std::vector<double> stencil(width * width, 0.0);
    const auto index = [width](int row, int column)
    { return static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column); };
    forDifferences(
      [&](int a, int b, int u, int v, double factor)
      {
        for (int q = 0; q <= b; ++q)
        {
          for (int p = 0; p <= a; ++p)
          {
            stencil[index(order - v + q, order - u + p)] += factor * Difference[a][p] * Difference[b][q];
          }
        }
      });
    for (int y = -order; y <= order; ++y)
    {
      for (int x = -order; x <= order; ++x)
      {
        const double factor = stencil[index(y + order, x + order)];
        if (factor != 0.0)
        {
          this->Interior.push_back({ y * this->Columns + x, factor });
        }
      }
    }
  }

  /** Half the derivative of the sum by the value of node n. */
  double derivative(const std::vector<double>& z, std::size_t n) const
  {
    const std::ptrdiff_t i = static_cast<std::ptrdiff_t>(n) % this->Columns;
    const std::ptrdiff_t j = static_cast<std::ptrdiff_t>(n) / this->Columns;
    const double* node = z.data() + n;
    double sum = 0.0;
    if (i >= this->Order && j >= this->Order && i + this->Order < this->Columns && j + this->Order < this->Rows)
    {
      for (const Term& term : this->Interior)
      {
        sum += term.factor * node[term.offset];
      }
      return sum;
    }
    forDifferences(
      [&](int a, int b, int u, int v, double factor)
      {
        if (i < u || j < v || i - u + a >= this->Columns || j - v + b >= this->Rows)
        {
          return;
        }
        const double* first = node - v * this->Columns - u;
        for (int q = 0; q <= b; ++q)
        {
          for (int p = 0; p <= a; ++p)
          {
            sum += factor * Difference[a][p] * Difference[b][q] * first[q * this->Columns + p];
          }
        }
      });
    return sum;
  }

private:
  struct Term
  {
    std::ptrdiff_t offset;
    double factor;
  };

  // body(a, b, u, v, factor) for every difference of order a in x and b in y that has the node as its entry (u, v).
  template <typename Body>
  void forDifferences(const Body& body) const
  {
    for (int a = 0; a <= this->Order; ++a)
    {
      const int b = this->Order - a;
      for (int v = 0; v <= b; ++v)
      {
        for (int u = 0; u <= a; ++u)
        {
          body(a, b, u, v, Binomial[this->Order][a] * Difference[a][u] * Difference[b][v]);
        }
      }
    }
  }

  int Order;
  std::ptrdiff_t Columns;
  std::ptrdiff_t Rows;
  std::vector<Term> Interior;
};

// Conjugate gradients on the roughness; only the nodes of the band move.
void relax(Level& level, const std::vector<std::size_t>& band, int order, int maxSteps)
{
  const Roughness roughness(order, level.columns, level.rows);
  std::vector<double> residual(band.size());
  std::vector<double> product(band.size());
  std::vector<double> direction(level.value.size(), 0.0);
  double square = 0.0;
  double scale = 0.0;
  for (std::size_t m = 0; m < band.size(); ++m)
  {
    residual[m] = -roughness.derivative(level.value, band[m]);
    direction[band[m]] = residual[m];
    square += residual[m] * residual[m];
    scale += level.value[band[m]] * level.value[band[m]];
  }
  const double target = std::max(Reduction * Reduction * square, 1e-28 * scale); // the second: rounding
  for (int step = 0; step < maxSteps && square > target; ++step)
  {
    double curvature = 0.0;
    for (std::size_t m = 0; m < band.size(); ++m)
    {
      product[m] = roughness.derivative(direction, band[m]);
      curvature += direction[band[m]] * product[m];
    }
    if (!(curvature > 0.0))
    {
      return;
    }
    const double length = square / curvature;
    double next = 0.0;
    for (std::size_t m = 0; m < band.size(); ++m)
    {
      level.value[band[m]] += length * direction[band[m]];
      residual[m] -= length * product[m];
      next += residual[m] * residual[m];
    }
    for (std::size_t m = 0; m < band.size(); ++m)
    {
      direction[band[m]] = residual[m] + next / square * direction[band[m]];
    }
    square = next;
  }
}

// Average the known nodes of every 2 x 2, fill what is left of that, and take the holes from there.
void fill(Level& fine)
{
  if (std::find(fine.hole.begin(), fine.hole.end(), 1) == fine.hole.end())
  {
    return;
  }
  Level coarse;
  coarse.columns = (fine.columns + 1) / 2;
  coarse.rows = (fine.rows + 1) / 2;
  coarse.value.assign(coarse.columns * coarse.rows, 0.0);
  coarse.hole.assign(coarse.columns * coarse.rows, 1);
  for (std::size_t j = 0; j < coarse.rows; ++j)
  {
    for (std::size_t i = 0; i < coarse.columns; ++i)
    {
      double sum = 0.0;
      double count = 0.0;
      for (std::size_t b = 2 * j; b < std::min(2 * j + 2, fine.rows); ++b)
      {
        for (std::size_t a = 2 * i; a < std::min(2 * i + 2, fine.columns); ++a)
        {
          if (!fine.hole[b * fine.columns + a])
          {
            sum += fine.value[b * fine.columns + a];
            count += 1.0;
          }
        }
      }
      if (count > 0.0)
      {
        coarse.value[j * coarse.columns + i] = sum / count;
        coarse.hole[j * coarse.columns + i] = 0;
      }
    }
  }
  fill(coarse);

  for (std::size_t j = 0; j < fine.rows; ++j)
  {
    // A coarse node lies in the middle of its four fine ones.
    const std::size_t j0 = j / 2;
    const std::size_t j1 = j % 2 ? std::min(j0 + 1, coarse.rows - 1) : (j0 > 0 ? j0 - 1 : 0);
    for (std::size_t i = 0; i < fine.columns; ++i)
    {
      if (fine.hole[j * fine.columns + i])
      {
        const std::size_t i0 = i / 2;
        const std::size_t i1 = i % 2 ? std::min(i0 + 1, coarse.columns - 1) : (i0 > 0 ? i0 - 1 : 0);
        fine.value[j * fine.columns + i] = 0.5625 * coarse.value[j0 * coarse.columns + i0] +
          0.1875 * coarse.value[j0 * coarse.columns + i1] + 0.1875 * coarse.value[j1 * coarse.columns + i0] +
          0.0625 * coarse.value[j1 * coarse.columns + i1];
      }
    }
  }
  relax(fine, bandNodes(fine), 2, PlateSteps);
}

}

std::vector<unsigned char> fillHoles(ElevationGrid& grid)
{
  std::vector<unsigned char> hole(grid.elevation.size());
  std::transform(
    grid.elevation.begin(), grid.elevation.end(), hole.begin(), [](double z) { return std::isfinite(z) ? 0 : 1; });
  const std::size_t holes = static_cast<std::size_t>(std::count(hole.begin(), hole.end(), 1));
  if (holes == 0)
  {
    return {};
  }
  if (holes == hole.size())
  {
    throw std::invalid_argument("the grid has no node with an elevation");
  }

  // Averages would bend a slope; what is left of the elevations when their plane is taken off is filled.
  const Plane plane = fitPlane(grid, hole);
  Level level;
  level.columns = grid.columns;
  level.rows = grid.rows;
  level.hole = hole;
  level.value.resize(grid.elevation.size());
  forNodes(grid,
    [&](std::size_t i, std::size_t j, std::size_t n)
    { level.value[n] = hole[n] ? 0.0 : grid.elevation[n] - plane.at(i, j); });
  fill(level);
  relax(level, bandNodes(level), 3, CurvatureSteps);
  forNodes(grid,
    [&](std::size_t i, std::size_t j, std::size_t n)
    {
      if (hole[n])
      {
        grid.elevation[n] = level.value[n] + plane.at(i, j);
      }
    });
  return hole;
}

}
