#include "sim/NestedDissection.h"

#include <gtest/gtest.h>

#include <thread>

using namespace swellray;

namespace
{

using Complex = NestedDissection::Complex;
using Element = NestedDissection::Element;

// Rounding of some thousand unknowns, of values near 1.
constexpr double Rounding = 1e-11;

/** Elements of a Helmholtz equation with a coefficient that changes from one to the next, some of them missing. */
struct Scene
{
  std::size_t columns;
  std::size_t rows;
  bool hole = false;

  bool missing(std::size_t i, std::size_t j) const
  {
    return this->hole && i >= this->columns / 3 && i < this->columns / 2 && j >= this->rows / 4 && j < this->rows / 2;
  }

  void fill(std::size_t i, std::size_t j, Element& values) const
  {
    values.fill(0.0);
    if (this->missing(i, j))
    {
      return;
    }
    const Complex k2(0.2 + 0.03 * static_cast<double>((7 * i + 3 * j) % 5), 0.05);
    for (std::size_t a = 0; a < 4; ++a)
    {
      for (std::size_t b = 0; b < 4; ++b)
      {
        const bool sameX = a % 2 == b % 2;
        const bool sameY = a / 2 == b / 2;
        const double massX = sameX ? 1.0 / 3.0 : 1.0 / 6.0;
        const double massY = sameY ? 1.0 / 3.0 : 1.0 / 6.0;
        values[4 * a + b] = (sameX ? 1.0 : -1.0) * massY + massX * (sameY ? 1.0 : -1.0) - k2 * massX * massY;
      }
    }
  }

  std::vector<std::uint8_t> unknown() const
  {
    std::vector<std::uint8_t> flags((this->columns + 1) * (this->rows + 1), 0);
    for (std::size_t j = 0; j < this->rows; ++j)
    {
      for (std::size_t i = 0; i < this->columns; ++i)
      {
        for (std::size_t a = 0; a < 4 && !this->missing(i, j); ++a)
        {
          flags[(j + a / 2) * (this->columns + 1) + i + a % 2] = 1;
        }
      }
    }
    return flags;
  }

  std::vector<Complex> product(const std::vector<Complex>& u) const
  {
    std::vector<Complex> f(u.size(), 0.0);
    const std::size_t along = this->columns + 1;
    Element values;
    for (std::size_t j = 0; j < this->rows; ++j)
    {
      for (std::size_t i = 0; i < this->columns; ++i)
      {
        this->fill(i, j, values);
        for (std::size_t a = 0; a < 4; ++a)
        {
          for (std::size_t b = 0; b < 4; ++b)
          {
            f[(j + a / 2) * along + i + a % 2] += values[4 * a + b] * u[(j + b / 2) * along + i + b % 2];
          }
        }
      }
    }
    return f;
  }
};

std::vector<Complex> someValues(const std::vector<std::uint8_t>& unknown)
{
  std::vector<Complex> u(unknown.size());
  for (std::size_t n = 0; n < u.size(); ++n)
  {
    const auto a = static_cast<double>(n % 17);
    const auto b = static_cast<double>(n % 13);
    u[n] = unknown[n] ? Complex(a / 8.0 - 1.0, b / 6.0 - 1.0) : 0.0;
  }
  return u;
}

std::vector<Complex> solved(const Scene& scene, const std::vector<Complex>& f, const Execution& execution = {})
{
  NestedDissection solver(scene.columns, scene.rows, scene.unknown());
  EXPECT_TRUE(solver.factor([&](std::size_t i, std::size_t j, Element& e) { scene.fill(i, j, e); }, execution));
  std::vector<Complex> u = f;
  solver.solve(u);
  return u;
}

double largestDifference(const std::vector<Complex>& a, const std::vector<Complex>& b)
{
  double largest = 0.0;
  for (std::size_t n = 0; n < a.size(); ++n)
  {
    largest = std::max(largest, std::abs(a[n] - b[n]));
  }
  return largest;
}

TEST(NestedDissection, SolvesGridsOfAnyShape)
{
  for (const Scene& scene : { Scene{ 1, 1 }, Scene{ 3, 2 }, Scene{ 4, 5 }, Scene{ 37, 11 }, Scene{ 8, 50 },
         Scene{ 61, 64, true }, Scene{ 5, 5, true } })
  {
    const std::vector<Complex> u = someValues(scene.unknown());
    EXPECT_LT(largestDifference(solved(scene, scene.product(u)), u), Rounding) << scene.columns << " x " << scene.rows;
  }
}

TEST(NestedDissection, LeavesKnownNodesAtZero)
{
  const Scene scene{ 20, 16, true };
  std::vector<Complex> f(scene.unknown().size(), 1.0);
  const std::vector<Complex> u = solved(scene, f);
  const std::vector<std::uint8_t> unknown = scene.unknown();
  for (std::size_t n = 0; n < u.size(); ++n)
  {
    EXPECT_EQ(u[n] == 0.0, unknown[n] == 0);
  }
}

TEST(NestedDissection, IsTheSameOnAnyNumberOfThreads)
{
  // Large enough for fronts that are shared among threads.
  const Scene scene{ 420, 30 };
  Execution threads;
  threads.loop = [](std::size_t n, const std::function<void(std::size_t, std::size_t)>& body)
  {
    std::vector<std::thread> workers;
    const std::size_t part = (n + 2) / 3;
    for (std::size_t begin = 0; begin < n; begin += part)
    {
      workers.emplace_back(body, begin, std::min(n, begin + part));
    }
    for (std::thread& worker : workers)
    {
      worker.join();
    }
  };
  const std::vector<Complex> f = scene.product(someValues(scene.unknown()));
  EXPECT_EQ(solved(scene, f), solved(scene, f, threads));
}

TEST(NestedDissection, CanBeCancelledAndReportsItsProgress)
{
  const Scene scene{ 60, 60 };
  NestedDissection solver(scene.columns, scene.rows, scene.unknown());
  double last = 0.0;
  Execution execution;
  execution.progress = [&](double share)
  {
    EXPECT_GE(share, last);
    EXPECT_LE(share, 1.0 + 1e-12);
    last = share;
    return share < 0.5;
  };
  EXPECT_FALSE(solver.factor([&](std::size_t i, std::size_t j, Element& e) { scene.fill(i, j, e); }, execution));
  EXPECT_GE(last, 0.5);
}

TEST(NestedDissection, RefusesWhatDoesNotFit)
{
  EXPECT_THROW(NestedDissection(3, 3, std::vector<std::uint8_t>(9, 1)), std::invalid_argument);
  EXPECT_THROW(NestedDissection(0, 3, std::vector<std::uint8_t>(4, 1)), std::invalid_argument);
  NestedDissection empty(2, 2, std::vector<std::uint8_t>(9, 1));
  EXPECT_THROW(empty.factor([](std::size_t, std::size_t, Element& e) { e.fill(0.0); }), std::runtime_error);
  std::vector<Complex> values(9);
  EXPECT_THROW(empty.solve(values), std::logic_error);
}

TEST(NestedDissection, CostsGrowAsTheyAreSaidTo)
{
  const DissectionCost small = NestedDissection::cost(250, 250);
  const DissectionCost large = NestedDissection::cost(1000, 1000);
  // 16 times the nodes: n^(3/2) is 64 times the work, n log n some 20 times the memory.
  EXPECT_NEAR(large.operations / small.operations, 64.0, 16.0);
  EXPECT_NEAR(large.bytes / small.bytes, 20.0, 3.0);
  EXPECT_LT(large.bytes, 3e9);
  // The law of growth that takes over beyond goes on from there.
  const DissectionCost counted = NestedDissection::cost(2400, 2400);
  const DissectionCost guessed = NestedDissection::cost(2600, 2600);
  EXPECT_NEAR(guessed.bytes / counted.bytes, 1.2, 0.1);
}

}
