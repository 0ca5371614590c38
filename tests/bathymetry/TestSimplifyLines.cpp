#include "bathymetry/SimplifyLines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace swellray;

namespace
{

double distanceToSegment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b)
{
  const glm::dvec2 d = b - a;
  const glm::dvec2 r = p - a;
  const double length = d.x * d.x + d.y * d.y;
  const double t = length > 0.0 ? std::min(1.0, std::max(0.0, (r.x * d.x + r.y * d.y) / length)) : 0.0;
  return std::hypot(r.x - t * d.x, r.y - t * d.y);
}

double distanceToLine(const glm::dvec2& p, const LineSet& lines, std::size_t line)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = lines.offsets[line]; i + 1 < lines.offsets[line + 1]; ++i)
  {
    nearest = std::min(nearest, distanceToSegment(p, lines.points[i], lines.points[i + 1]));
  }
  return nearest;
}

// Wavy rings inside each other, closed.
LineSet rings(std::size_t count, std::size_t points)
{
  LineSet lines;
  for (std::size_t line = 0; line < count; ++line)
  {
    for (std::size_t i = 0; i <= points; ++i)
    {
      const double t = 2.0 * std::acos(-1.0) * static_cast<double>(i % points) / static_cast<double>(points);
      const double radius = 1000.0 + 40.0 * static_cast<double>(line) + 15.0 * std::sin(9.0 * t);
      lines.points.emplace_back(radius * std::cos(t), radius * std::sin(t));
    }
    lines.offsets.push_back(lines.points.size());
  }
  return lines;
}

}

TEST(SimplifyLines, EveryPointStaysWithinTheTolerance)
{
  const LineSet lines = rings(4, 2000);
  for (const double tolerance : { 0.5, 5.0, 20.0 })
  {
    const LineSet simple = simplifyLines(lines, tolerance);
    ASSERT_EQ(simple.offsets.size(), lines.offsets.size());
    EXPECT_LT(simple.points.size(), lines.points.size() / 5);
    for (std::size_t line = 0; line + 1 < lines.offsets.size(); ++line)
    {
      EXPECT_EQ(simple.points[simple.offsets[line]], lines.points[lines.offsets[line]]);
      EXPECT_EQ(simple.points[simple.offsets[line + 1] - 1], lines.points[lines.offsets[line + 1] - 1]);
      for (std::size_t i = lines.offsets[line]; i < lines.offsets[line + 1]; ++i)
      {
        ASSERT_LE(distanceToLine(lines.points[i], simple, line), tolerance * (1.0 + 1e-12));
      }
    }
  }
}

TEST(SimplifyLines, SmallRingsDoNotCollapse)
{
  const LineSet lines = rings(1, 40);
  const LineSet simple = simplifyLines(lines, 1e5);
  EXPECT_GE(simple.points.size(), 3u);
  EXPECT_EQ(simple.points.front(), simple.points.back());
}

TEST(SimplifyLines, ShortRepeatedAndEmptyLinesPass)
{
  LineSet lines;
  lines.points = { { 0.0, 0.0 }, { 1.0, 1.0 }, { 5.0, 5.0 }, { 7.0, 7.0 }, { 7.0, 7.0 }, { 8.0, 7.0 }, { 9.0, 7.0 } };
  lines.offsets = { 0, 2, 2, 3, 7 };
  const LineSet simple = simplifyLines(lines, 0.1);
  EXPECT_EQ(simple.offsets, (std::vector<std::size_t>{ 0, 2, 2, 3, 5 }));
  EXPECT_EQ(simple.points.back(), glm::dvec2(9.0, 7.0));
  EXPECT_EQ(simplifyLines(lines, 0.0).points.size(), lines.points.size());
  EXPECT_EQ(simplifyLines(LineSet(), 1.0).offsets.size(), 1u);
}

TEST(SimplifyLines, WrongCalls)
{
  EXPECT_THROW(simplifyLines(LineSet(), -1.0), std::invalid_argument);
  EXPECT_THROW(simplifyLines(LineSet(), std::nan("")), std::invalid_argument);
  LineSet bad;
  bad.offsets = { 0, 3 };
  EXPECT_THROW(simplifyLines(bad, 1.0), std::invalid_argument);
}
