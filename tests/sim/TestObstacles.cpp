#include "sim/Obstacles.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <stdexcept>

using namespace swellray;

namespace
{

// Roots of polynomials with coefficients about 1: rounding.
constexpr double Rounding = 1e-13;

Obstacle line(const std::vector<glm::dvec2>& points, double reflection = 0.0)
{
  return { points, false, reflection };
}

Obstacle ring(const std::vector<glm::dvec2>& points)
{
  return { points, true, 0.0 };
}

PathPiece way(const glm::dvec2& from, const glm::dvec2& to)
{
  return { { from, to - from } };
}

double cross(const glm::dvec2& a, const glm::dvec2& b)
{
  return a.x * b.y - a.y * b.x;
}

// Share of the way from a to b at which it crosses the segment c to d; 2 where it does not.
double crossing(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d)
{
  const double area = cross(b - a, d - c);
  const double s = cross(c - a, d - c) / area;
  const double t = cross(c - a, b - a) / area;
  return s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0 ? s : 2.0;
}

std::string messageOf(const std::function<void()>& call)
{
  try
  {
    call();
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "";
}

}

TEST(Obstacles, aCurvedPathMeetsAWallWhereItsPolynomialSays)
{
  // x = t - 1/2, y = (t - 0.2)(t - 0.4)(t - 0.6)(t - 0.9) above the wall y = 0.
  const double roots[] = { 0.2, 0.4, 0.6, 0.9 };
  double c[5] = { 1.0, 0.0, 0.0, 0.0, 0.0 };
  for (int degree = 1; degree <= 4; ++degree)
  {
    for (int i = degree; i > 0; --i)
    {
      c[i] = c[i - 1] - roots[degree - 1] * c[i];
    }
    c[0] *= -roots[degree - 1];
  }
  PathPiece path;
  for (std::size_t i = 0; i < 5; ++i)
  {
    path.coefficients[i] = { i == 0 ? -0.5 : i == 1 ? 1.0 : 0.0, c[i] };
  }
  const auto hitOf = [&](double from, double to) {
    return Obstacles({ line({ { from - 0.5, 0.0 }, { to - 0.5, 0.0 } }) }).firstHit(path);
  };
  // Walls that hold one crossing each, and all of them.
  for (const double root : roots)
  {
    const auto hit = hitOf(root - 0.05, root + 0.05);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->theta, root, Rounding);
  }
  const auto first = hitOf(0.0, 1.0);
  ASSERT_TRUE(first);
  EXPECT_NEAR(first->theta, 0.2, Rounding);
  // y falls from above: from the left of a wall that runs along +x.
  EXPECT_EQ(first->side, 1.0);
  EXPECT_NEAR(glm::distance(first->normal, glm::dvec2(0.0, 1.0)), 0.0, Rounding);
  EXPECT_FALSE(hitOf(0.65, 0.85));
  // Not beyond where it is asked to look.
  EXPECT_FALSE(Obstacles({ line({ { -0.5, 0.0 }, { 0.5, 0.0 } }) }).firstHit(path, 0.19));
}

TEST(Obstacles, aPathThatTouchesHasNotMetTheWall)
{
  // y = (t - 1/2)^2
  const PathPiece path{ { glm::dvec2(0.0, 0.25), glm::dvec2(1.0, -1.0), glm::dvec2(0.0, 1.0) } };
  EXPECT_FALSE(Obstacles({ line({ { 0.0, -1e-12 }, { 1.0, -1e-12 } }) }).firstHit(path));
  EXPECT_TRUE(Obstacles({ line({ { 0.0, 1e-6 }, { 1.0, 1e-6 } }) }).firstHit(path));
}

TEST(Obstacles, noPathSlipsThroughACorner)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1000.0, 1000.0);
  for (int i = 0; i < 2000; ++i)
  {
    const glm::dvec2 corner(any(random), any(random));
    const Obstacles walls(
      { line({ corner + glm::dvec2(-100.0, any(random)), corner, corner + glm::dvec2(100.0, any(random)) }) });
    const auto hit = walls.firstHit(way(corner + glm::dvec2(1.3, 2000.0), corner - glm::dvec2(1.3, 2000.0)));
    EXPECT_TRUE(hit) << corner.x << " " << corner.y;
  }
}

TEST(Obstacles, cornersAndFreeEndsAreToldFromWalls)
{
  const Obstacles walls({ line({ { -1.0, 0.0 }, { 0.0, 0.0 }, { 1.0, 0.01 }, { 1.0, 1.0 } }) });
  const auto at = [&](double x, double y) { return walls.firstHit(way({ x, y - 1.0 }, { x, y + 1.0 })); };
  EXPECT_TRUE(at(-1.0, 0.0)->corner);
  EXPECT_FALSE(at(-0.5, 0.0)->corner);
  EXPECT_FALSE(at(0.0, 0.0)->corner) << "a wall that turns by half a degree is a curve";
  EXPECT_TRUE(walls.firstHit(way({ 2.0, -0.99 }, { 0.0, 1.01 }))->corner);
}

TEST(Obstacles, leavingAWallIsNotMeetingIt)
{
  const Obstacles walls({ line({ { -10.0, 0.0 }, { 10.0, 0.0 } }) });
  const auto hit = walls.firstHit(way({ 0.0, 1.0 }, { 0.3, -1.0 }));
  ASSERT_TRUE(hit);
  for (const double rounding : { -1e-13, 0.0, 1e-13 })
  {
    EXPECT_FALSE(walls.firstHit(way({ 0.15, rounding }, { 0.3, 1.0 }), 1.0, hit->wall, hit->side));
  }
  // Back to it from the same side it is met again: y = t (1 - 2 t).
  const PathPiece back{ { glm::dvec2(0.0, 0.0), glm::dvec2(1.0, 1.0), glm::dvec2(0.0, -2.0) } };
  const auto again = walls.firstHit(back, 1.0, hit->wall, hit->side);
  ASSERT_TRUE(again);
  EXPECT_NEAR(again->theta, 0.5, Rounding);
}

TEST(Obstacles, theTreeFindsWhatLookingAtAllOfThemFinds)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> any(0.0, 1000.0);
  std::uniform_real_distribution<double> little(-30.0, 30.0);
  std::vector<Obstacle> obstacles;
  for (int i = 0; i < 700; ++i)
  {
    const glm::dvec2 from(any(random), any(random));
    obstacles.push_back(line({ from, from + glm::dvec2(little(random), little(random)) }));
  }
  const Obstacles walls(obstacles);
  EXPECT_EQ(walls.segmentCount(), 700u);
  int hits = 0;
  for (int i = 0; i < 3000; ++i)
  {
    const glm::dvec2 a(any(random), any(random));
    const glm::dvec2 b = a + 2.0 * glm::dvec2(little(random), little(random));
    double first = 2.0;
    std::size_t which = 0;
    for (std::size_t j = 0; j < obstacles.size(); ++j)
    {
      const double at = crossing(a, b, obstacles[j].points[0], obstacles[j].points[1]);
      which = at < first ? j : which;
      first = std::min(first, at);
    }
    const auto hit = walls.firstHit(way(a, b));
    ASSERT_EQ(hit.has_value(), first <= 1.0);
    EXPECT_EQ(walls.crosses(a, b), first <= 1.0);
    if (hit)
    {
      ++hits;
      EXPECT_NEAR(hit->theta, first, 1e-10); // crossings at small angles
      EXPECT_EQ(hit->obstacle, which);
    }
  }
  EXPECT_GT(hits, 500);
}

TEST(Obstacles, waysThatEndOnAWallDoNotCrossIt)
{
  const Obstacles walls({ line({ { -10.0, 0.0 }, { 10.0, 0.0 } }) });
  EXPECT_TRUE(walls.crosses({ 0.0, 1.0 }, { 1.0, -1.0 }));
  EXPECT_FALSE(walls.crosses({ 0.0, 1.0 }, { 1.0, 0.0 }));
  EXPECT_FALSE(walls.crosses({ 0.0, 1.0 }, { 1.0, -1e-8 }));
  EXPECT_FALSE(walls.crosses({ 0.0, 0.0 }, { 1.0, 0.0 }));
  EXPECT_FALSE(walls.crosses({ 11.0, 1.0 }, { 11.0, -1.0 }));
}

TEST(Obstacles, insideIsWhereRingsWindAround)
{
  // A square with a square hole, an islet in it, and a line through all.
  const auto square = [](double half) -> std::vector<glm::dvec2> {
    return { { -half, -half }, { half, -half }, { half, half }, { -half, half } };
  };
  std::vector<glm::dvec2> hole = square(2.0);
  std::reverse(hole.begin(), hole.end());
  const Obstacles walls({ ring(square(3.0)), ring(hole), ring(square(1.0)), line({ { -5.0, 0.1 }, { 5.0, 0.1 } }) });
  for (double x = -3.9; x < 4.0; x += 0.2)
  {
    for (double y = -3.9; y < 4.0; y += 0.2)
    {
      const double reach = std::max(std::abs(x), std::abs(y));
      EXPECT_EQ(walls.inside({ x, y }), reach < 1.0 || (reach > 2.0 && reach < 3.0)) << x << " " << y;
    }
  }
  EXPECT_FALSE(Obstacles().inside({ 0.0, 0.0 }));
}

TEST(Obstacles, insideHoldsForRingsOfManyCorners)
{
  // A star: r = 100 + 30 cos 17 a.
  std::vector<glm::dvec2> star;
  constexpr int corners = 20000;
  for (int i = 0; i < corners; ++i)
  {
    const double a = 2.0 * M_PI * i / corners;
    star.push_back((100.0 + 30.0 * std::cos(17.0 * a)) * glm::dvec2(std::cos(a), std::sin(a)));
  }
  const Obstacles walls({ ring(star) });
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-140.0, 140.0);
  for (int i = 0; i < 5000; ++i)
  {
    const glm::dvec2 p(any(random), any(random));
    const double r = 100.0 + 30.0 * std::cos(17.0 * std::atan2(p.y, p.x));
    if (std::abs(glm::length(p) - r) > 0.01) // sagitta of the sides
    {
      EXPECT_EQ(walls.inside(p), glm::length(p) < r);
    }
  }
}

TEST(Obstacles, sayWhatIsWrong)
{
  const auto make = [](const Obstacle& obstacle) { return [=] { Obstacles({ obstacle }); }; };
  EXPECT_EQ(messageOf(make(line({ { 0.0, 0.0 } }))), "obstacle 0: 1 points; a line has at least 2");
  EXPECT_EQ(messageOf(make(ring({ { 0.0, 0.0 }, { 1.0, 0.0 } }))), "obstacle 0: 2 points; a ring has at least 3");
  EXPECT_EQ(messageOf(make(line({ { 0.0, 0.0 }, { 1.0, 0.0 } }, 1.5))),
    "obstacle 0: the reflection coefficient must be 0 to 1, not 1.5");
  EXPECT_EQ(
    messageOf(make(line({ { 0.0, 0.0 }, { 1.0, std::nan("") } }))), "obstacle 0: a corner has no finite coordinates");
  EXPECT_TRUE(Obstacles({ line({ { 0.0, 0.0 }, { 0.0, 1e-9 } }) }).empty()) << "walls of no length are none";
}
