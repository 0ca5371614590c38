#pragma once

#include "sim/Execution.h"

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace swellray
{

/** What a factorisation takes. */
struct DissectionCost
{
  double bytes = 0.0;      ///< at its largest, factors and what they are made from
  double operations = 0.0; ///< multiplications of complex numbers
};

/**
 * Direct solution of A u = f for finite elements of four nodes on a regular grid, A complex symmetric and sparse: the
 * nested dissection of George (1973), written out for a rectangle of elements that is cut in halves again and again.
 * A rectangle keeps the Schur complement on those of its nodes that elements outside of it share; two halves are joined
 * by eliminating the nodes of the line between them, by a dense LU decomposition with partial pivoting (Eigen).
 *
 * Work grows with the nodes to the power 3/2, storage with n log n. Rounding is that of dense LU; solve() is followed by
 * iterative refinement where the caller has a residual.
 *
 * Elements are counted along x first, columns x rows of them; nodes likewise, (columns + 1) x (rows + 1).
 */
class NestedDissection
{
public:
  using Complex = std::complex<double>;

  /** Entries of a symmetric element matrix, its nodes at (0,0), (1,0), (0,1), (1,1), row after row. */
  using Element = std::array<Complex, 16>;

  /**
   * @param columns, rows elements along x and y, >= 1
   * @param unknown one a node: 0 where u is 0 and no equation holds
   * @throws std::invalid_argument where the sizes do not fit
   */
  NestedDissection(std::size_t columns, std::size_t rows, std::vector<std::uint8_t> unknown);
  ~NestedDissection();
  NestedDissection(NestedDissection&&) noexcept;
  NestedDissection& operator=(NestedDissection&&) noexcept;

  /**
   * Factorise. A node that is unknown must be part of an element that is not zero.
   * @param element fills the matrix of element (i, j); called from the loop's threads
   * @return false when cancelled
   * @throws std::runtime_error where the matrix is singular
   */
  bool factor(const std::function<void(std::size_t, std::size_t, Element&)>& element, const Execution& execution = {});

  /** Solve in place: in f, out u, one a node; entries of nodes that are not unknown are not read, and become 0. */
  void solve(std::vector<Complex>& values) const;

  /** Cost for a grid all nodes of which are unknown. */
  static DissectionCost cost(std::size_t columns, std::size_t rows);

private:
  struct Box;
  struct Factors;

  std::size_t Columns;
  std::size_t Rows;
  std::vector<std::uint8_t> Unknown;
  std::unique_ptr<Factors> Data;
};

}
