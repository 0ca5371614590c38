#include "sim/Crests.h"

#include "sim/Angles.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace
{

using namespace swellray;

// Interpolation between points some 100 m apart.
constexpr double Rounding = 1e-11;

// Rays as a ray file has them, in any order of lambda.
struct Rays
{
  std::vector<std::int64_t> offsets{ 0 };
  std::vector<double> positions;
  std::vector<double> phase;
  std::vector<double> lambda;
  std::vector<std::int32_t> segment;

  // A ray along +x at height y with a crest every wavelength of 1 m, its phase from `first` to `last` crests.
  void add(double y, double first, double last, double pointsPerWave = 8.0, std::int32_t piece = 0)
  {
    const int steps = std::max(1, static_cast<int>(std::lround((last - first) * pointsPerWave)));
    for (int i = 0; i <= steps; ++i)
    {
      const double crests = first + (last - first) * i / steps;
      this->positions.insert(this->positions.end(), { crests, y, 0.0 });
      this->phase.push_back(2.0 * Pi * crests);
    }
    close(y, piece);
  }

  void close(double parameter, std::int32_t piece)
  {
    this->offsets.push_back(static_cast<std::int64_t>(this->phase.size()));
    this->lambda.push_back(parameter);
    this->segment.push_back(piece);
  }

  CrestLines crests(double maxGap = 0.0, std::int64_t every = 1) const
  {
    RayLines lines;
    lines.rays = this->lambda.size();
    lines.offsets = this->offsets.data();
    lines.positions = this->positions.data();
    lines.phase = this->phase.data();
    lines.launchParameter = this->lambda.data();
    lines.launchSegment = this->segment.data();
    return extractCrests(lines, maxGap, every);
  }

  glm::dvec2 at(const RayPlace& place) const
  {
    const auto value = [&](std::int64_t point, int axis)
    { return this->positions[static_cast<std::size_t>(3 * point + axis)]; };
    glm::dvec2 p;
    for (int axis = 0; axis < 2; ++axis)
    {
      p[axis] = (1.0 - place.weight) * value(place.point, axis) + place.weight * value(place.point + 1, axis);
    }
    return p;
  }

  // y of the places of every line of one crest; all rays of these tests have a whole y.
  std::vector<std::vector<double>> linesOf(const CrestLines& crests, std::int64_t number) const
  {
    std::vector<std::vector<double>> result;
    for (std::size_t i = 0; i < crests.number.size(); ++i)
    {
      if (crests.number[i] == number)
      {
        result.emplace_back();
        for (std::size_t j = crests.offsets[i]; j < crests.offsets[i + 1]; ++j)
        {
          const glm::dvec2 p = at(crests.places[j]);
          EXPECT_NEAR(p.x, static_cast<double>(number), Rounding);
          EXPECT_NEAR(p.y, std::round(p.y), Rounding);
          result.back().push_back(std::round(p.y));
        }
      }
    }
    return result;
  }
};

using Lines = std::vector<std::vector<double>>;

TEST(Crests, EverySoMany)
{
  Rays rays;
  rays.add(0.0, 0.0, 10.0);
  rays.add(1.0, 2.5, 10.0);
  EXPECT_EQ(rays.crests(0.0, 4).number, (std::vector<std::int64_t>{ 4, 8 }));
  EXPECT_EQ(rays.linesOf(rays.crests(0.0, 4), 8), (std::vector<std::vector<double>>{ { 0.0, 1.0 } }));
  EXPECT_THROW(rays.crests(0.0, 0), std::invalid_argument);
}

TEST(Crests, StandWhereThePhaseIsAMultipleOfTwoPi)
{
  Rays rays;
  rays.add(0.0, 0.0, 3.0);
  rays.add(1.0, 0.0, 3.0);
  rays.add(2.0, 0.0, 3.0);
  const CrestLines crests = rays.crests();
  EXPECT_EQ(crests.number, (std::vector<std::int64_t>{ 0, 1, 2, 3 }));
  EXPECT_EQ(crests.offsets, (std::vector<std::size_t>{ 0, 3, 6, 9, 12 }));
  for (std::int64_t n = 0; n <= 3; ++n)
  {
    EXPECT_EQ(rays.linesOf(crests, n), (Lines{ { 0.0, 1.0, 2.0 } }));
  }
}

TEST(Crests, AreFoundBetweenPoints)
{
  // Phases that meet no multiple of 2 pi, other points on every ray, and several crests in one step.
  Rays rays;
  rays.add(0.0, 0.3, 4.7, 3.0);
  rays.add(1.0, 0.9, 4.2, 0.5);
  rays.add(2.0, -1.4, 5.8, 7.0);
  const CrestLines crests = rays.crests();
  EXPECT_EQ(crests.number, (std::vector<std::int64_t>{ 1, 2, 3, 4 }));
  for (std::int64_t n = 1; n <= 4; ++n)
  {
    EXPECT_EQ(rays.linesOf(crests, n), (Lines{ { 0.0, 1.0, 2.0 } }));
  }
  for (const RayPlace& place : crests.places)
  {
    EXPECT_GE(place.weight, 0.0);
    EXPECT_LE(place.weight, 1.0);
  }
}

TEST(Crests, FollowTheLaunchParameterNotTheOrderOfRays)
{
  Rays rays;
  rays.add(0.0, 0.0, 2.0);
  rays.add(3.0, 0.0, 2.0);
  rays.add(1.0, 0.0, 2.0);
  rays.add(2.0, 0.0, 2.0);
  EXPECT_EQ(rays.linesOf(rays.crests(), 1), (Lines{ { 0.0, 1.0, 2.0, 3.0 } }));
}

TEST(Crests, BreakWhereARayHasEnded)
{
  Rays rays;
  rays.add(0.0, 0.0, 3.0);
  rays.add(1.0, 0.0, 3.0);
  rays.add(2.0, 0.0, 1.5); // behind it lies land
  rays.add(3.0, 0.0, 3.0);
  rays.add(4.0, 0.0, 3.0);
  const CrestLines crests = rays.crests();
  EXPECT_EQ(rays.linesOf(crests, 1), (Lines{ { 0.0, 1.0, 2.0, 3.0, 4.0 } }));
  EXPECT_EQ(rays.linesOf(crests, 2), (Lines{ { 0.0, 1.0 }, { 3.0, 4.0 } }));
  EXPECT_EQ(rays.linesOf(crests, 3), (Lines{ { 0.0, 1.0 }, { 3.0, 4.0 } }));
}

TEST(Crests, ARayThatEndsOnACrestIsPartOfIt)
{
  Rays rays;
  rays.add(0.0, 0.0, 3.0);
  rays.add(1.0, 0.0, 2.0);
  rays.add(2.0, 0.0, 3.0);
  rays.phase[static_cast<std::size_t>(rays.offsets[2] - 1)] -= 1e-8; // to the accuracy of an integration
  EXPECT_EQ(rays.crests().number, (std::vector<std::int64_t>{ 0, 1, 2 }));
  EXPECT_EQ(rays.crests().offsets.back(), 9u);
}

TEST(Crests, RaysInsertedLaterDoNotBreakThem)
{
  Rays rays;
  rays.add(0.0, 0.0, 3.0);
  rays.add(1.0, 1.5, 3.0);
  rays.add(2.0, 0.0, 3.0);
  const CrestLines crests = rays.crests();
  EXPECT_EQ(rays.linesOf(crests, 1), (Lines{ { 0.0, 2.0 } }));
  EXPECT_EQ(rays.linesOf(crests, 2), (Lines{ { 0.0, 1.0, 2.0 } }));
}

TEST(Crests, BreakBetweenSegments)
{
  Rays rays;
  rays.add(0.0, 0.0, 1.0, 8.0, 0);
  rays.add(1.0, 0.0, 1.0, 8.0, 0);
  rays.add(2.0, 0.0, 1.0, 8.0, 1);
  rays.add(3.0, 0.0, 1.0, 8.0, 1);
  rays.add(4.0, 0.0, 1.0, 8.0, 2);
  EXPECT_EQ(rays.linesOf(rays.crests(), 1), (Lines{ { 0.0, 1.0 }, { 2.0, 3.0 } }));
}

TEST(Crests, BreakAtGapsWhereALimitIsSet)
{
  Rays rays;
  for (const double y : { 0.0, 1.0, 4.0, 5.0 })
  {
    rays.add(y, 0.0, 1.0);
  }
  EXPECT_EQ(rays.linesOf(rays.crests(0.0), 1), (Lines{ { 0.0, 1.0, 4.0, 5.0 } }));
  EXPECT_EQ(rays.linesOf(rays.crests(2.0), 1), (Lines{ { 0.0, 1.0 }, { 4.0, 5.0 } }));
  EXPECT_EQ(rays.linesOf(rays.crests(3.0), 1), (Lines{ { 0.0, 1.0, 4.0, 5.0 } }));
}

TEST(Crests, OneRayIsNoCrest)
{
  Rays rays;
  EXPECT_TRUE(rays.crests().number.empty());
  EXPECT_EQ(rays.crests().offsets, (std::vector<std::size_t>{ 0 }));
  rays.add(0.0, 0.0, 5.0);
  EXPECT_TRUE(rays.crests().number.empty());
  rays.add(1.0, 0.0, 2.0);
  EXPECT_EQ(rays.crests().number, (std::vector<std::int64_t>{ 0, 1, 2 }));
}

TEST(Crests, RaysWithoutALengthOnlyEndThem)
{
  // A ray of one point ended where it began; one without points tells nothing.
  Rays rays;
  rays.add(0.0, 0.0, 2.0);
  rays.positions.insert(rays.positions.end(), { 0.0, 1.0, 0.0 });
  rays.phase.push_back(0.0);
  rays.close(1.0, 0);
  rays.add(2.0, 0.0, 2.0);
  rays.close(2.5, 0);
  rays.add(3.0, 0.0, 2.0);
  const CrestLines crests = rays.crests();
  EXPECT_EQ(rays.linesOf(crests, 1), (Lines{ { 2.0, 3.0 } }));
}

TEST(Crests, RefuseWhatIsNoPhase)
{
  for (const double bad : { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e300 })
  {
    Rays rays;
    rays.add(0.0, 0.0, 2.0);
    rays.add(1.0, 0.0, 2.0);
    rays.phase.back() = bad;
    EXPECT_THROW(rays.crests(), std::runtime_error) << bad;
  }
}

TEST(Crests, CurvedCrestsKeepTheirShape)
{
  // Rays from a point: crests are circles. Points on equal phases, so that interpolation has no error.
  Rays rays;
  for (int r = 0; r <= 40; ++r)
  {
    const double angle = 0.03 * r;
    for (int i = 0; i <= 40; ++i)
    {
      const double radius = 5.0 * i;
      rays.positions.insert(rays.positions.end(), { radius * std::cos(angle), radius * std::sin(angle), 0.0 });
      rays.phase.push_back(2.0 * Pi * radius / 20.0);
    }
    rays.close(angle, 0);
  }
  const CrestLines crests = rays.crests();
  ASSERT_EQ(crests.number.size(), 11u);
  for (std::size_t i = 0; i < crests.number.size(); ++i)
  {
    EXPECT_EQ(crests.offsets[i + 1] - crests.offsets[i], 41u);
    for (std::size_t j = crests.offsets[i]; j < crests.offsets[i + 1]; ++j)
    {
      EXPECT_NEAR(glm::length(rays.at(crests.places[j])), 20.0 * static_cast<double>(crests.number[i]), Rounding);
    }
  }
}

TEST(Crests, ManyRaysWithManyEndings)
{
  // Every third ray ends early: all gaps are found, in order, against a search by hand.
  Rays rays;
  for (int r = 0; r < 300; ++r)
  {
    rays.add(r, 0.0, r % 3 == 1 ? 2.5 + r % 7 : 20.0, 1.0);
  }
  const CrestLines crests = rays.crests();
  for (std::int64_t n = 0; n <= 20; ++n)
  {
    Lines expected{ {} };
    for (int r = 0; r < 300; ++r)
    {
      const double last = r % 3 == 1 ? 2.5 + r % 7 : 20.0;
      if (last < static_cast<double>(n))
      {
        expected.emplace_back();
      }
      else
      {
        expected.back().push_back(r);
      }
    }
    Lines longer;
    for (const auto& line : expected)
    {
      if (line.size() > 1)
      {
        longer.push_back(line);
      }
    }
    EXPECT_EQ(rays.linesOf(crests, n), longer) << n;
  }
}

}
