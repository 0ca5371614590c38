#include "sim/Spray.h"

#include "RayBundle.h"

#include "sim/Angles.h"
#include "sim/Dispersion.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <vector>

using namespace swellray;
using namespace swellray::bundles;

namespace
{

constexpr double Rounding = 1e-9;

// What is drawn at random is compared within so many standard deviations of its mean.
constexpr double Deviations = 5.0;

constexpr double Omega = 2.0 * Pi / Period;
constexpr double BreakAt = 60.0;
constexpr double BreakDepth = 2.56;
constexpr double Rise = 0.02;

double depthAt(double x)
{
  return BreakDepth - Rise * (x - BreakAt);
}

/** Height as traced: shoaling up to 2 m where it breaks at H = h/1.28, from there on saturated. */
double heightAt(double x)
{
  const double g = StandardGravity;
  const auto groupSpeed = [&](double at)
  { return waveSpeeds(solveWavenumber(Omega, depthAt(at)), depthAt(at), g).groupSpeed; };
  return x <= BreakAt ? 2.0 * std::sqrt(groupSpeed(BreakAt) / groupSpeed(x)) : 2.0 * depthAt(x) / BreakDepth;
}

/** Waves of the right length on a slope, ten rays 4 m apart. */
Bundle shoaling(double last = 160.0)
{
  Bundle bundle;
  for (int i = 0; i < 10; ++i)
  {
    bundle.begin(4.0 * i);
    double phase = 0.0;
    for (double x = 0.0; x < last + 1e-9; x += 1.0)
    {
      const double k = solveWavenumber(Omega, depthAt(x));
      phase += x > 0.0 ? 0.5 * (k + bundle.Wavenumber.back()) : 0.0;
      bundle.add({ x, 4.0 * i }, phase, { 1.0, 0.0 }, heightAt(x), std::max(0.0, x - BreakAt), RayState::Alive, k);
    }
  }
  return bundle;
}

/** Q as the paper has it: pi S C/(pi S_max), with the height that waves would have had. */
double speedAt(double x)
{
  const double g = StandardGravity;
  const auto steepness = [&](double at)
  {
    const double k = solveWavenumber(Omega, depthAt(at));
    const double ratio = waveSpeeds(solveWavenumber(Omega, BreakDepth), BreakDepth, g).groupSpeed /
      waveSpeeds(k, depthAt(at), g).groupSpeed;
    return 2.0 * std::sqrt(ratio) * k / (2.0 * Pi);
  };
  return Omega / solveWavenumber(Omega, depthAt(x)) * steepness(x) / steepness(BreakAt);
}

SprayOptions plenty()
{
  SprayOptions options;
  options.rate = 400.0;
  return options;
}

glm::dvec3 startOf(const SprayParticle& particle)
{
  glm::dvec3 start = particle.position - particle.age * particle.velocity;
  start.z -= 0.5 * StandardGravity * particle.age * particle.age;
  return start;
}

/** Rays of whole waves against a wall at x = 100, whose face rises by `slope`. */
struct Wall
{
  explicit Wall(double slope)
    : Walls({ { { { 100.0, -50.0 }, { 100.0, 90.0 } }, false, 0.0, slope } })
    , Bed(10.0, 0.0)
  {
    for (int i = 0; i < 10; ++i)
    {
      this->Rays.begin(4.0 * i);
      this->Rays.Ends.push_back(static_cast<std::uint8_t>(EndReason::StoppedByObstacle));
      for (double x = 0.0; x < 100.5; x += 2.0)
      {
        this->Rays.add({ x, 4.0 * i }, K * x, { 1.0, 0.0 }, 2.0);
      }
    }
    this->Rays.Walls = &this->Walls;
  }

  Obstacles Walls;
  Slope Bed;
  Bundle Rays;
};

}

TEST(Spray, orbitalSpeedIsThatOfThePaper)
{
  // Q_avg = pi H/T = pi S C; corrected by 1/(pi S_max): as fast as the wave where S = S_max.
  EXPECT_NEAR(orbitalSpeed(0.05, 0.1, 8.0), Pi * 0.05 * 8.0 / (Pi * 0.1), Rounding);
  EXPECT_NEAR(orbitalSpeed(0.142, 0.142, 8.0), 8.0, Rounding);
}

TEST(Spray, elasticCollisionsKeepTheSpeedAndTurnAtTheFace)
{
  const glm::dvec3 forward(1.0, 0.0, 0.0);
  const glm::dvec3 back = elasticReflection(forward, faceNormal({ -1.0, 0.0 }, 0.0));
  EXPECT_NEAR(glm::distance(back, glm::dvec3(-1.0, 0.0, 0.0)), 0.0, Rounding);
  // A face of 45 degrees throws straight up.
  const glm::dvec3 up = elasticReflection(forward, faceNormal({ -1.0, 0.0 }, 1.0));
  EXPECT_NEAR(glm::distance(up, glm::dvec3(0.0, 0.0, 1.0)), 0.0, Rounding);
  const glm::dvec3 aslant =
    elasticReflection(glm::normalize(glm::dvec3(1.0, 0.4, 0.0)), faceNormal({ -1.0, 0.0 }, 2.0));
  EXPECT_NEAR(glm::length(aslant), 1.0, Rounding);
  EXPECT_GT(aslant.z, 0.0);
  EXPECT_LT(aslant.x, 0.0);
}

TEST(Spray, obstaclesThrowMostAsTheCrestIsThere)
{
  EXPECT_EQ(impactShare(0.0), 1.0);
  EXPECT_NEAR(impactShare(Pi / 8.0), 0.5, Rounding);
  EXPECT_NEAR(impactShare(-Pi / 8.0), 0.5, Rounding);
  EXPECT_EQ(impactShare(Pi / 4.0), 0.0);
  EXPECT_EQ(impactShare(-Pi), 0.0);
}

TEST(Spray, crestsThrowAsMuchAsTheyAreFasterThanTheWave)
{
  const Slope bed(depthAt(0.0), Rise);
  const Bundle rays = shoaling();
  const Surface surface(rays, bed);
  const Spray spray(*surface.Moved, bed, nullptr, plenty());
  const auto section = makeWaveSection("airy");
  // Of the youngest particles none has fallen yet: a frame has those of a moment, everywhere.
  constexpr double moment = 0.05;
  std::map<int, std::vector<double>> speeds;
  double expected = 0.0;
  double thrown = 0.0;
  for (int frame = 0; frame < 30; ++frame)
  {
    const double time = 3.0 + 0.27 * frame;
    for (const SprayParticle& particle : spray.at(time, *section))
    {
      if (particle.age > moment)
      {
        continue;
      }
      ASSERT_EQ(particle.source, SpraySource::Crest);
      const glm::dvec3 start = startOf(particle);
      ASSERT_GT(start.x, BreakAt - 0.3); // half a step of the rays
      ASSERT_NEAR(start.z, 0.5 * heightAt(start.x), 0.02);
      thrown += 1.0;
      speeds[static_cast<int>(start.x / 20.0)].push_back(particle.velocity.x / speedAt(start.x));
    }
    // The same moment of the crests that are on their way, on 36 m of crest.
    for (int part = 0; part < 5; ++part)
    {
      const double passed = Omega * (time - moment * (part + 0.5) / 5.0);
      for (std::size_t i = 1; i < 161; ++i)
      {
        const double crest = passed + 2.0 * Pi * std::ceil((rays.Phase[i - 1] - passed) / (2.0 * Pi));
        const double x = static_cast<double>(i) - 0.5;
        if (crest < rays.Phase[i] && x > BreakAt)
        {
          const double faster = std::max(0.0, speedAt(x) - Omega / solveWavenumber(Omega, depthAt(x)));
          const double unbroken = speedAt(x) * 2.0 / speedAt(BreakAt); // Q is proportional to it at a constant period
          expected += 400.0 * faster * heightAt(x) / unbroken * 36.0 * moment / 5.0;
        }
      }
    }
  }
  ASSERT_GT(expected, 500.0);
  EXPECT_NEAR(thrown, expected, Deviations * std::sqrt(expected));
  int places = 0;
  for (const auto& [place, values] : speeds)
  {
    if (values.size() < 100)
    {
      continue;
    }
    double mean = 0.0;
    double square = 0.0;
    for (const double value : values)
    {
      mean += value / static_cast<double>(values.size());
    }
    for (const double value : values)
    {
      square += (value - mean) * (value - mean) / static_cast<double>(values.size());
    }
    EXPECT_NEAR(mean, 1.0, Deviations * 0.25 / std::sqrt(static_cast<double>(values.size()))) << place;
    EXPECT_NEAR(std::sqrt(square), 0.25, 0.02) << place;
    ++places;
  }
  EXPECT_GE(places, 3);
}

TEST(Spray, fallsFreelySoThatAnyFrameStandsAlone)
{
  const Slope bed(depthAt(0.0), Rise);
  const Surface surface(shoaling(), bed);
  SprayOptions few;
  few.rate = 10.0;
  const Spray spray(*surface.Moved, bed, nullptr, few);
  const auto section = makeWaveSection("jeschke");
  const double time = 20.0;
  const double later = time + 0.3;
  const auto now = spray.at(time, *section);
  const auto then = spray.at(later, *section);
  ASSERT_GT(now.size(), 20u);
  std::size_t found = 0;
  for (const SprayParticle& particle : now)
  {
    for (const SprayParticle& other : then)
    {
      if (std::abs((later - other.age) - (time - particle.age)) < 1e-10)
      {
        const double passed = later - time;
        glm::dvec3 expected = particle.position + passed * particle.velocity;
        expected.z -= 0.5 * StandardGravity * passed * passed;
        EXPECT_NEAR(glm::distance(other.position, expected), 0.0, 1e-8);
        EXPECT_NEAR(other.velocity.z, particle.velocity.z - StandardGravity * passed, 1e-8);
        ++found;
      }
    }
  }
  EXPECT_GT(found, now.size() / 10); // the others have come down
  EXPECT_LE(found, now.size());
  // Neither what was asked before nor the loop matters.
  Execution backwards;
  backwards.loop = [](std::size_t n, const std::function<void(std::size_t, std::size_t)>& body)
  {
    for (std::size_t i = n; i-- > 0;)
    {
      body(i, i + 1);
    }
  };
  const Spray fresh(*surface.Moved, bed, nullptr, few);
  const auto again = fresh.at(later, *section, backwards);
  ASSERT_EQ(again.size(), then.size());
  for (std::size_t i = 0; i < then.size(); ++i)
  {
    EXPECT_EQ(again[i].position, then[i].position);
    EXPECT_LE(then[i].age, spray.longestLife());
  }
  few.seed = 2;
  const auto other = Spray(*surface.Moved, bed, nullptr, few).at(later, *section);
  EXPECT_FALSE(other.size() == then.size() && other.front().position == then.front().position);
}

TEST(Spray, comesWhereTheGivenSteepnessIsPassed)
{
  // Deep water, no breaking in the trace: storm waves throw spray where S > S_max, others do not.
  const Slope bed(100.0, 0.0);
  const Surface surface(straight(2.0), bed); // 1 m over 40 m
  const auto section = makeWaveSection("airy");
  SprayOptions options = plenty();
  EXPECT_TRUE(Spray(*surface.Moved, bed, nullptr, options).at(5.0, *section).empty());
  options.steepest = 0.026;
  EXPECT_TRUE(Spray(*surface.Moved, bed, nullptr, options).at(5.0, *section).empty());
  options.steepest = 0.024;
  const auto particles = Spray(*surface.Moved, bed, nullptr, options).at(5.0, *section);
  ASSERT_GT(particles.size(), 100u);
  double mean = 0.0;
  for (const SprayParticle& particle : particles)
  {
    mean += particle.velocity.x / static_cast<double>(particles.size());
  }
  const double speed = Omega / K * 0.025 / 0.024;
  EXPECT_NEAR(mean, speed, Deviations * 0.25 * speed / std::sqrt(static_cast<double>(particles.size())));
}

TEST(Spray, obstaclesThrowItInTheDirectionOfTheElasticCollision)
{
  const Wall wall(1.0);
  const Surface surface(wall.Rays, wall.Bed);
  const Spray spray(*surface.Moved, wall.Bed, &wall.Walls, plenty());
  EXPECT_EQ(spray.impactCount(), 10u);
  const auto section = makeWaveSection("airy");
  const double speed = Omega / K * 2.0 / (10.0 * 0.78); // C times the ripeness
  double before = 0.0;
  double after = 0.0;
  glm::dvec3 mean(0.0);
  constexpr double moment = 0.05;
  for (int frame = 0; frame < 200; ++frame)
  {
    const double time = 0.04 * frame; // one period
    for (const SprayParticle& particle : spray.at(time, *section))
    {
      ASSERT_EQ(particle.source, SpraySource::Obstacle);
      if (particle.age > moment)
      {
        continue;
      }
      const glm::dvec3 start = startOf(particle);
      const double phase = K * 100.0 - Omega * (time - particle.age);
      const double fromCrest = phase - 2.0 * Pi * std::round(phase / (2.0 * Pi));
      ASSERT_LT(std::abs(fromCrest), Pi / 4.0 + 0.11); // a slot of time more
      ASSERT_NEAR(start.x, 100.0, 1e-6);
      ASSERT_GE(start.y, 0.0);
      ASSERT_LE(start.y, 36.0);
      ASSERT_NEAR(start.z, std::cos(fromCrest), 0.01);
      (fromCrest > 0.0 ? before : after) += 1.0;
      mean += particle.velocity + glm::dvec3(0.0, 0.0, StandardGravity * particle.age);
    }
  }
  const double count = before + after;
  ASSERT_GT(count, 500.0);
  EXPECT_NEAR(before, after, Deviations * std::sqrt(count));
  mean /= count;
  const double spread = Deviations * 0.25 * speed / std::sqrt(count);
  EXPECT_NEAR(mean.x, 0.0, spread);
  EXPECT_NEAR(mean.y, 0.0, spread);
  EXPECT_NEAR(mean.z, 0.7 * speed, spread);
  // As many as the rate says: the raised cosine is half of the quarter of a period that it lasts, on 36 m.
  EXPECT_NEAR(
    count, 400.0 * speed * 36.0 * Period / 8.0 * moment / 0.04, Deviations * std::sqrt(count) * moment / 0.04);
}

TEST(Spray, wallsThrowItBackAndSteepShoresUp)
{
  const auto section = makeWaveSection("airy");
  const Wall wall(0.0);
  const Surface against(wall.Rays, wall.Bed);
  double mean = 0.0;
  const auto thrownBack = Spray(*against.Moved, wall.Bed, &wall.Walls, plenty()).at(4.0, *section);
  for (const SprayParticle& particle : thrownBack)
  {
    mean += particle.velocity.x / static_cast<double>(thrownBack.size());
  }
  EXPECT_LT(mean, -0.5);

  for (const double slope : { 0.8, 0.1 })
  {
    // The shore at x = 100: rays run aground in 0.1 m of water and go on along it.
    const Slope shore(100.0 * slope, slope);
    Bundle rays;
    for (int i = 0; i < 5; ++i)
    {
      rays.begin(4.0 * i);
      for (double x = 0.0; x < 99.5; x += 1.0)
      {
        rays.add({ x, 4.0 * i }, K * x, { 1.0, 0.0 }, 1.0);
      }
      const double x = 100.0 - 0.1 / slope;
      for (int walk = 0; walk < 3; ++walk)
      {
        rays.add({ x, 4.0 * i + walk }, K * (x + walk), { walk > 0 ? 0.0 : 1.0, walk > 0 ? 1.0 : 0.0 }, 0.05,
          1.0 + walk, RayState::Aground);
      }
    }
    const Surface surface(rays, shore);
    const Spray spray(*surface.Moved, shore, nullptr, plenty());
    EXPECT_EQ(spray.impactCount(), slope > 0.5 ? 5u : 0u);
  }
}

TEST(Spray, refusesWhatMakesNoSense)
{
  const Slope bed(depthAt(0.0), Rise);
  const Surface surface(shoaling(), bed);
  const auto made = [&](const auto& change)
  {
    SprayOptions options;
    change(options);
    return Spray(*surface.Moved, bed, nullptr, options);
  };
  EXPECT_THROW(made([](SprayOptions& o) { o.rate = -1.0; }), std::invalid_argument);
  EXPECT_THROW(made([](SprayOptions& o) { o.scatter = 2.0; }), std::invalid_argument);
  EXPECT_THROW(made([](SprayOptions& o) { o.steepest = -0.1; }), std::invalid_argument);
  EXPECT_THROW(made([](SprayOptions& o) { o.gravity = 0.0; }), std::invalid_argument);
  SprayOptions flood;
  flood.maxParticles = 10;
  const auto section = makeWaveSection("airy");
  EXPECT_THROW(Spray(*surface.Moved, bed, nullptr, flood).at(20.0, *section), std::runtime_error);
}
