#include "sim/NestedDissection.h"

#include <Eigen/Dense>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>
#include <string>

namespace swellray
{

namespace
{

using Complex = NestedDissection::Complex;
using Matrix = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic>;
using Vector = Eigen::Matrix<Complex, Eigen::Dynamic, 1>;

// Elements along a side of the rectangles that are not cut any more.
constexpr std::size_t LeafSide = 4;

// Columns of a large front that are one piece of work, and the fewest for which a front is shared among threads.
constexpr std::size_t PieceColumns = 96;
constexpr std::size_t SharedColumns = 4 * PieceColumns;

struct Range
{
  std::size_t first = 0; // elements, last excluded
  std::size_t last = 0;

  std::size_t size() const { return this->last - this->first; }
};

// A rectangle of elements, and where its halves are.
struct Piece
{
  Range x;
  Range y;
  std::size_t left = 0; // 0: a leaf; the root is no one's half
  std::size_t right = 0;
  std::size_t height = 0; // above the leaves
};

std::vector<Piece> dissect(std::size_t columns, std::size_t rows)
{
  std::vector<Piece> pieces{ { { 0, columns }, { 0, rows } } };
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    const Range x = pieces[i].x;
    const Range y = pieces[i].y;
    if (x.size() <= LeafSide && y.size() <= LeafSide)
    {
      continue;
    }
    Piece left{ x, y };
    Piece right{ x, y };
    Range Piece::*axis = x.size() >= y.size() ? &Piece::x : &Piece::y;
    const std::size_t middle = (left.*axis).first + (left.*axis).size() / 2;
    (left.*axis).last = middle;
    (right.*axis).first = middle;
    pieces[i].left = pieces.size();
    pieces[i].right = pieces.size() + 1;
    pieces.push_back(left);
    pieces.push_back(right);
  }
  for (std::size_t i = pieces.size(); i-- > 0;)
  {
    if (pieces[i].left > 0)
    {
      pieces[i].height = 1 + std::max(pieces[pieces[i].left].height, pieces[pieces[i].right].height);
    }
  }
  return pieces;
}

// Nodes on the outline of a rectangle that elements outside of it share, in their order.
template <typename Visit>
void visitShared(const Piece& piece, std::size_t columns, std::size_t rows, const Visit& visit)
{
  const auto row = [&](std::size_t j)
  {
    for (std::size_t i = piece.x.first; i <= piece.x.last; ++i)
    {
      visit(i, j);
    }
  };
  const bool low = piece.y.first > 0;
  const bool high = piece.y.last < rows;
  const bool west = piece.x.first > 0;
  const bool east = piece.x.last < columns;
  if (low)
  {
    row(piece.y.first);
  }
  for (std::size_t j = piece.y.first + (low ? 1 : 0); j < piece.y.last + (high ? 0 : 1); ++j)
  {
    if (west)
    {
      visit(piece.x.first, j);
    }
    if (east)
    {
      visit(piece.x.last, j);
    }
  }
  if (high)
  {
    row(piece.y.last);
  }
}

double workOf(double eliminated, double kept)
{
  return eliminated * eliminated * (eliminated / 3.0 + kept) + 0.5 * eliminated * kept * kept;
}

}

/** A rectangle after its inner nodes are eliminated. */
struct NestedDissection::Box
{
  std::vector<std::uint32_t> eliminated; // nodes
  std::vector<std::uint32_t> kept;       // nodes, ascending
  Eigen::PartialPivLU<Matrix> lu;        // of the eliminated block
  Matrix coupling;                       // its inverse times the block of eliminated rows and kept columns
  Matrix schur;                          // lower half, until the rectangle it is a half of has taken it
};

struct NestedDissection::Factors
{
  std::vector<Piece> pieces;
  std::vector<std::vector<std::size_t>> levels; // pieces by their height
  std::vector<Box> boxes;
};

NestedDissection::NestedDissection(std::size_t columns, std::size_t rows, std::vector<std::uint8_t> unknown)
  : Columns(columns)
  , Rows(rows)
  , Unknown(std::move(unknown))
  , Data(std::make_unique<Factors>())
{
  if (columns < 1 || rows < 1 || this->Unknown.size() != (columns + 1) * (rows + 1))
  {
    throw std::invalid_argument("a grid of " + std::to_string(columns) + " x " + std::to_string(rows) +
      " elements needs one flag for each of its nodes, not " + std::to_string(this->Unknown.size()));
  }
  this->Data->pieces = dissect(columns, rows);
  this->Data->levels.resize(this->Data->pieces.front().height + 1);
  for (std::size_t i = 0; i < this->Data->pieces.size(); ++i)
  {
    this->Data->levels[this->Data->pieces[i].height].push_back(i);
  }
}

NestedDissection::~NestedDissection() = default;
NestedDissection::NestedDissection(NestedDissection&&) noexcept = default;
NestedDissection& NestedDissection::operator=(NestedDissection&&) noexcept = default;

bool NestedDissection::factor(
  const std::function<void(std::size_t, std::size_t, Element&)>& element, const Execution& execution)
{
  Factors& data = *this->Data;
  data.boxes.clear();
  data.boxes.resize(data.pieces.size());
  const std::size_t nodesAlong = this->Columns + 1;
  std::atomic<bool> singular{ false };

  // Collect the front of a rectangle: eliminated nodes first, then those that are kept.
  const auto gather = [&](std::size_t index, Matrix& front)
  {
    const Piece& piece = data.pieces[index];
    Box& box = data.boxes[index];
    visitShared(piece, this->Columns, this->Rows,
      [&](std::size_t i, std::size_t j)
      {
        const std::size_t node = j * nodesAlong + i;
        if (this->Unknown[node])
        {
          box.kept.push_back(static_cast<std::uint32_t>(node));
        }
      });
    std::vector<std::uint32_t> all;
    if (piece.left == 0)
    {
      for (std::size_t j = piece.y.first; j <= piece.y.last; ++j)
      {
        for (std::size_t i = piece.x.first; i <= piece.x.last; ++i)
        {
          const std::size_t node = j * nodesAlong + i;
          if (this->Unknown[node])
          {
            all.push_back(static_cast<std::uint32_t>(node));
          }
        }
      }
    }
    else
    {
      const std::vector<std::uint32_t>& left = data.boxes[piece.left].kept;
      const std::vector<std::uint32_t>& right = data.boxes[piece.right].kept;
      std::set_union(left.begin(), left.end(), right.begin(), right.end(), std::back_inserter(all));
    }
    std::set_difference(all.begin(), all.end(), box.kept.begin(), box.kept.end(), std::back_inserter(box.eliminated));

    const auto placeOf = [&](std::uint32_t node) -> Eigen::Index
    {
      const auto inner = std::lower_bound(box.eliminated.begin(), box.eliminated.end(), node);
      if (inner != box.eliminated.end() && *inner == node)
      {
        return inner - box.eliminated.begin();
      }
      return static_cast<Eigen::Index>(box.eliminated.size()) +
        (std::lower_bound(box.kept.begin(), box.kept.end(), node) - box.kept.begin());
    };
    const auto size = static_cast<Eigen::Index>(all.size());
    front = Matrix::Zero(size, size);
    if (piece.left == 0)
    {
      Element values;
      for (std::size_t j = piece.y.first; j < piece.y.last; ++j)
      {
        for (std::size_t i = piece.x.first; i < piece.x.last; ++i)
        {
          values.fill(0.0);
          element(i, j, values);
          std::array<Eigen::Index, 4> place{};
          for (std::size_t a = 0; a < 4; ++a)
          {
            const std::size_t node = (j + a / 2) * nodesAlong + i + a % 2;
            place[a] = this->Unknown[node] ? placeOf(static_cast<std::uint32_t>(node)) : -1;
          }
          for (std::size_t a = 0; a < 4; ++a)
          {
            for (std::size_t b = 0; b < 4; ++b)
            {
              if (place[a] >= 0 && place[b] >= 0)
              {
                front(place[a], place[b]) += values[4 * a + b];
              }
            }
          }
        }
      }
      return;
    }
    for (const std::size_t half : { piece.left, piece.right })
    {
      Box& part = data.boxes[half];
      std::vector<Eigen::Index> place(part.kept.size());
      std::transform(part.kept.begin(), part.kept.end(), place.begin(), placeOf);
      const auto count = static_cast<Eigen::Index>(place.size());
      for (Eigen::Index b = 0; b < count; ++b)
      {
        const Eigen::Index column = place[static_cast<std::size_t>(b)];
        front(column, column) += part.schur(b, b);
        for (Eigen::Index a = b + 1; a < count; ++a)
        {
          const Complex value = part.schur(a, b);
          front(place[static_cast<std::size_t>(a)], column) += value;
          front(column, place[static_cast<std::size_t>(a)]) += value;
        }
      }
      part.schur.resize(0, 0);
    }
  };

  // Columns [begin, end) of the coupling and of the lower half of the Schur complement.
  const auto eliminate = [&](Box& box, const Matrix& front, Eigen::Index begin, Eigen::Index end)
  {
    const Eigen::Index s = box.lu.rows();
    const auto kept = static_cast<Eigen::Index>(box.kept.size());
    box.coupling.middleCols(begin, end - begin).noalias() = box.lu.solve(front.block(0, s + begin, s, end - begin));
    auto target = box.schur.block(begin, begin, kept - begin, end - begin);
    target = front.block(s + begin, s + begin, kept - begin, end - begin);
    target.noalias() -=
      front.block(0, s + begin, s, kept - begin).transpose() * box.coupling.middleCols(begin, end - begin);
  };

  const auto prepare = [&](std::size_t index, Matrix& front)
  {
    gather(index, front);
    Box& box = data.boxes[index];
    const auto s = static_cast<Eigen::Index>(box.eliminated.size());
    const auto kept = static_cast<Eigen::Index>(box.kept.size());
    box.schur.resize(kept, kept);
    if (s > 0)
    {
      box.lu.compute(front.topLeftCorner(s, s));
      const auto pivots = box.lu.matrixLU().diagonal().cwiseAbs();
      if (!(pivots.minCoeff() > 0.0) || !std::isfinite(pivots.sum()))
      {
        singular = true;
      }
      box.coupling.resize(s, kept);
    }
    else
    {
      box.schur = front;
    }
  };

  double total = 0.0;
  const auto workAt = [&](std::size_t index)
  {
    const Piece& piece = data.pieces[index];
    const auto side = static_cast<double>(std::max(piece.x.size(), piece.y.size()));
    return side * side * side;
  };
  for (std::size_t i = 0; i < data.pieces.size(); ++i)
  {
    total += workAt(i);
  }
  double done = 0.0;
  for (const std::vector<std::size_t>& level : data.levels)
  {
    // Small rectangles each on one thread, large ones one after the other by all.
    std::vector<std::size_t> small;
    std::vector<std::size_t> large;
    for (const std::size_t index : level)
    {
      const Piece& piece = data.pieces[index];
      (piece.x.size() + piece.y.size() < SharedColumns ? small : large).push_back(index);
    }
    execution.forRange(small.size(),
      [&](std::size_t begin, std::size_t end)
      {
        Matrix front;
        for (std::size_t i = begin; i < end; ++i)
        {
          prepare(small[i], front);
          Box& box = data.boxes[small[i]];
          if (!box.eliminated.empty() && !box.kept.empty())
          {
            eliminate(box, front, 0, static_cast<Eigen::Index>(box.kept.size()));
          }
        }
      });
    for (const std::size_t index : small)
    {
      done += workAt(index);
    }
    for (const std::size_t index : large)
    {
      if (!execution.report(done / total))
      {
        return false;
      }
      Matrix front;
      prepare(index, front);
      Box& box = data.boxes[index];
      const std::size_t parts = box.eliminated.empty() ? 0 : (box.kept.size() + PieceColumns - 1) / PieceColumns;
      execution.forRange(parts,
        [&](std::size_t begin, std::size_t end)
        {
          for (std::size_t part = begin; part < end; ++part)
          {
            eliminate(box, front, static_cast<Eigen::Index>(part * PieceColumns),
              static_cast<Eigen::Index>(std::min(box.kept.size(), (part + 1) * PieceColumns)));
          }
        });
      done += workAt(index);
    }
    if (singular)
    {
      data.boxes.clear();
      throw std::runtime_error("the equations of the wave field have no single solution (a singular matrix); change "
                               "the spacing of the nodes a little");
    }
    if (!execution.report(done / total))
    {
      return false;
    }
  }
  return true;
}

void NestedDissection::solve(std::vector<Complex>& values) const
{
  const Factors& data = *this->Data;
  if (data.boxes.empty() || values.size() != this->Unknown.size())
  {
    throw std::logic_error("solve() needs factor() before it, and one value a node");
  }
  const auto take = [&](const std::vector<std::uint32_t>& nodes)
  {
    Vector part(static_cast<Eigen::Index>(nodes.size()));
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      part[static_cast<Eigen::Index>(i)] = values[nodes[i]];
    }
    return part;
  };
  for (const std::vector<std::size_t>& level : data.levels)
  {
    for (const std::size_t index : level)
    {
      const Box& box = data.boxes[index];
      if (!box.eliminated.empty() && !box.kept.empty())
      {
        const Vector change = box.coupling.transpose() * take(box.eliminated);
        for (std::size_t i = 0; i < box.kept.size(); ++i)
        {
          values[box.kept[i]] -= change[static_cast<Eigen::Index>(i)];
        }
      }
    }
  }
  for (std::size_t height = data.levels.size(); height-- > 0;)
  {
    for (const std::size_t index : data.levels[height])
    {
      const Box& box = data.boxes[index];
      if (box.eliminated.empty())
      {
        continue;
      }
      Vector inner = box.lu.solve(take(box.eliminated));
      if (!box.kept.empty())
      {
        inner.noalias() -= box.coupling * take(box.kept);
      }
      for (std::size_t i = 0; i < box.eliminated.size(); ++i)
      {
        values[box.eliminated[i]] = inner[static_cast<Eigen::Index>(i)];
      }
    }
  }
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = this->Unknown[i] ? values[i] : 0.0;
  }
}

DissectionCost NestedDissection::cost(std::size_t columns, std::size_t rows)
{
  // Beyond what can be solved anywhere the law of growth will do.
  constexpr std::size_t MostCounted = 6'000'000;
  if (columns > MostCounted / rows)
  {
    DissectionCost half = cost((columns + 1) / 2, (rows + 1) / 2);
    half.bytes *= 4.4;
    half.operations *= 8.0;
    return half;
  }
  const std::vector<Piece> pieces = dissect(columns, rows);
  struct Counts
  {
    double eliminated = 0.0;
    double kept = 0.0;
  };
  std::vector<Counts> counts(pieces.size());
  struct Level
  {
    double factors = 0.0;
    double kept = 0.0; // entries of Schur complements
    double front = 0.0;
  };
  std::vector<Level> levels(pieces.front().height + 1);
  DissectionCost cost;
  for (std::size_t i = pieces.size(); i-- > 0;)
  {
    const Piece& piece = pieces[i];
    Counts& count = counts[i];
    visitShared(piece, columns, rows, [&](std::size_t, std::size_t) { count.kept += 1.0; });
    if (piece.left == 0)
    {
      count.eliminated = static_cast<double>((piece.x.size() + 1) * (piece.y.size() + 1)) - count.kept;
    }
    else
    {
      const bool acrossX = pieces[piece.left].x.last == pieces[piece.right].x.first;
      const double shared = static_cast<double>((acrossX ? piece.y.size() : piece.x.size()) + 1);
      count.eliminated = counts[piece.left].kept + counts[piece.right].kept - shared - count.kept;
    }
    const double s = count.eliminated;
    const double b = count.kept;
    cost.operations += workOf(s, b);
    Level& level = levels[piece.height];
    level.factors += s * (s + b);
    level.kept += b * b;
    level.front = std::max(level.front, (s + b) * (s + b));
  }
  double factors = 0.0;
  double before = 0.0;
  constexpr double entryBytes = sizeof(Complex);
  for (const Level& level : levels)
  {
    factors += level.factors;
    cost.bytes = std::max(cost.bytes, entryBytes * (factors + before + level.kept + level.front));
    before = level.kept;
  }
  // Lists of nodes and what an allocation takes.
  constexpr double bytesOfABox = 600.0;
  cost.bytes += bytesOfABox * static_cast<double>(pieces.size()) +
    4.0 * sizeof(Complex) * static_cast<double>((columns + 1) * (rows + 1));
  return cost;
}

}
