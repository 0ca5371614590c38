#include "sim/FoldsBeside.h"

#include "sim/RayField.h"
#include "sim/RayFolds.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

using namespace swellray;

namespace
{

constexpr double K = 0.1;
constexpr double Focus = 2000.0; // m
constexpr double Drift = 2.0;
constexpr double Step = 5.0;

/**
 * Rays in water of one depth from the line x = 0 at y = lambda, turned to each other so that each touches the caustic after
 * cos(theta) (Focus + Drift lambda) metres: d theta/d lambda = -1/(Focus + Drift lambda).
 */
double heading(double lambda)
{
  return -std::log1p(Drift * lambda / Focus) / Drift;
}

double turn(double lambda)
{
  return -1.0 / (Focus + Drift * lambda);
}

double startPhase(double lambda)
{
  // Integral of K sin(theta), by Simpson's rule.
  constexpr int steps = 200;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i)
  {
    const double a = lambda * i / steps;
    const double b = lambda * (i + 1) / steps;
    sum += (b - a) / 6.0 * (std::sin(heading(a)) + 4.0 * std::sin(heading(0.5 * (a + b))) + std::sin(heading(b)));
  }
  return K * sum;
}

double touchedAfter(double lambda)
{
  return std::cos(heading(lambda)) * (Focus + Drift * lambda);
}

double width(double lambda, double way)
{
  return std::cos(heading(lambda)) + way * turn(lambda);
}

glm::dvec2 placeOf(double lambda, double way)
{
  return { way * std::cos(heading(lambda)), lambda + way * std::sin(heading(lambda)) };
}

/** Half the phase between the ray that is at a place and the other one there, by Newton's method from beyond the fold. */
double exactHalf(double lambda, double way)
{
  const glm::dvec2 place = placeOf(lambda, way);
  double other = lambda;
  double reached = way;
  for (double from = lambda - 5.0; std::abs(other - lambda) < 1e-3 && from > lambda - 400.0; from -= 5.0)
  {
    other = from;
    reached = way;
    for (int i = 0; i < 50; ++i)
    {
      const glm::dvec2 miss = placeOf(other, reached) - place;
      const glm::dvec2 d(std::cos(heading(other)), std::sin(heading(other)));
      const glm::dvec2 n(-d.y, d.x);
      const double step = -glm::dot(miss, n) / width(other, reached);
      reached -= glm::dot(miss, d) + step * std::sin(heading(other));
      other += step;
    }
  }
  return 0.5 * std::abs(startPhase(other) + K * reached - startPhase(lambda) - K * way);
}

/** Rays that end on a front just behind where the middle one touches its caustic. */
struct Rays
{
  Rays()
  {
    for (double lambda = -202.5; lambda < 203.0; lambda += Step)
    {
      this->Parameter.push_back(lambda);
      this->Segment.push_back(0);
      this->Lee.push_back(0);
      const double last = K * Focus;
      for (double phase = last - 100.0; phase < last + 0.25; phase += 0.5)
      {
        const double beta = std::abs(width(lambda, (phase - startPhase(lambda)) / K));
        this->Phase.push_back(phase);
        this->Wavenumber.push_back(K);
        this->KrTube.push_back(1.0 / std::sqrt(beta));
        this->State.push_back(static_cast<std::uint8_t>(RayState::Alive));
      }
      this->Offsets.push_back(static_cast<std::int64_t>(this->Phase.size()));
      const double touched = startPhase(lambda) + K * touchedAfter(lambda);
      if (touched < this->Phase.back())
      {
        RayCaustic caustic;
        caustic.ray = static_cast<std::int32_t>(this->Parameter.size()) - 1;
        caustic.number = 1;
        caustic.position = placeOf(lambda, touchedAfter(lambda));
        const double theta = heading(lambda);
        caustic.rayDirection = { std::cos(theta), std::sin(theta) };
        caustic.phase = touched;
        caustic.wavenumber = K * caustic.rayDirection;
        caustic.phaseRate = caustic.fanWavenumber = K;
        caustic.widthRate = turn(lambda);
        caustic.alongRate = 2.0 * std::sin(theta) + Drift * std::cos(theta);
        caustic.alongChange = turn(lambda) * (2.0 * std::cos(theta) - Drift * std::sin(theta));
        this->Caustics.push_back(caustic);
      }
      this->CausticOffsets.push_back(this->Caustics.size());
    }
  }

  TouchingRays arrays() const
  {
    return { this->Parameter.size(), this->Offsets.data(), this->Parameter.data(), this->Segment.data(),
      this->Lee.data(), this->Caustics.data(), this->CausticOffsets.data(), this->Phase.data(), this->Wavenumber.data(),
      this->KrTube.data(), this->State.data() };
  }

  std::size_t lastPoint(std::size_t ray) const { return static_cast<std::size_t>(this->Offsets[ray + 1]) - 1; }

  /** Refraction coefficient at the end of a ray. */
  double refraction(std::size_t ray, const double* beside) const
  {
    const auto first = static_cast<std::size_t>(this->Offsets[ray]);
    const std::size_t count = this->lastPoint(ray) + 1 - first;
    const RayFolds folds(this->Caustics.data() + this->CausticOffsets[ray],
      this->CausticOffsets[ray + 1] - this->CausticOffsets[ray], this->Phase.data() + first,
      this->Wavenumber.data() + first, count, beside ? beside + first : nullptr);
    return folds.refraction(count - 1, 1.0 / std::pow(this->KrTube[this->lastPoint(ray)], 2));
  }

  std::vector<std::int64_t> Offsets{ 0 };
  std::vector<double> Parameter, Phase, Wavenumber, KrTube;
  std::vector<std::int32_t> Segment;
  std::vector<std::uint8_t> Lee, State;
  std::vector<RayCaustic> Caustics;
  std::vector<std::size_t> CausticOffsets{ 0 };
};

}

TEST(FoldsBeside, haveThePhaseBetweenBothBranches)
{
  const Rays rays;
  const std::vector<double> half = foldsBeside(rays.arrays());
  // A changes along the front by its own share of Drift lambda/Focus, a few times; heights go with the sixth root of it.
  const auto tolerance = [](double lambda) { return 0.02 + 2.5 * Drift * lambda / Focus; };
  int seen = 0;
  for (std::size_t ray = 0; ray < rays.Parameter.size(); ++ray)
  {
    const std::size_t point = rays.lastPoint(ray);
    if (rays.CausticOffsets[ray + 1] > rays.CausticOffsets[ray])
    {
      EXPECT_TRUE(std::isinf(half[point])) << rays.Parameter[ray];
      continue;
    }
    const double way = (rays.Phase[point] - startPhase(rays.Parameter[ray])) / K;
    const double exact = exactHalf(rays.Parameter[ray], way);
    if (exact < 1.0)
    {
      EXPECT_NEAR(half[point], exact, tolerance(rays.Parameter[ray]) * exact) << rays.Parameter[ray];
      ++seen;
    }
  }
  EXPECT_GT(seen, 5);
}

TEST(FoldsBeside, giveBothSidesOfACausticOneHeight)
{
  const Rays rays;
  const std::vector<double> half = foldsBeside(rays.arrays());
  std::size_t first = 0; // that does not touch it
  while (rays.CausticOffsets[first + 1] > rays.CausticOffsets[first])
  {
    ++first;
  }
  ASSERT_GT(first, 2u);
  constexpr double step = 0.08; // from ray to ray, of the height
  for (std::size_t ray = first - 1; ray < first + 2; ++ray)
  {
    EXPECT_NEAR(rays.refraction(ray, half.data()) / rays.refraction(ray - 1, half.data()), 1.0, step)
      << rays.Parameter[ray];
  }
  // Without them the sheet has a spike at the first ray.
  EXPECT_GT(rays.refraction(first, nullptr), 1.5 * rays.refraction(first - 1, nullptr));
}

TEST(FoldsBeside, loneCausticsHaveTheRateOfTheWidthsAroundThem)
{
  Rays rays;
  const std::vector<RayCaustic> exact = rays.Caustics;
  for (std::size_t i = 0; i < exact.size(); i += 2)
  {
    rays.Caustics[i].alongRate = std::numeric_limits<double>::quiet_NaN();
  }
  const std::vector<RayCaustic> filled = loneCausticRates(rays.arrays());
  ASSERT_EQ(filled.size(), exact.size());
  // The widths of both neighbours together are right to the second order of their distance.
  constexpr double tolerance = 0.01;
  int seen = 0;
  for (std::size_t i = 0; i < exact.size(); ++i)
  {
    const auto ray = static_cast<std::size_t>(exact[i].ray);
    if (i % 2 == 1)
    {
      EXPECT_EQ(filled[i].alongRate, exact[i].alongRate);
    }
    else if (ray > 0 && exact[i].phase > rays.Phase.front() + 1.0)
    {
      EXPECT_NEAR(filled[i].alongRate, exact[i].alongRate, tolerance * exact[i].alongRate) << rays.Parameter[ray];
      ++seen;
    }
  }
  EXPECT_GT(seen, 10);
}

TEST(FoldsBeside, areThoseOfNeighboursAlone)
{
  Rays rays;
  const auto isFree = [](const std::vector<double>& half)
  { return std::all_of(half.begin(), half.end(), [](double value) { return std::isinf(value); }); };
  EXPECT_FALSE(isFree(foldsBeside(rays.arrays())));
  // Rays on the other side of a corner of the launch line are no neighbours.
  for (std::size_t ray = 0; ray < rays.Segment.size(); ++ray)
  {
    rays.Segment[ray] = rays.CausticOffsets[ray + 1] > rays.CausticOffsets[ray] ? 0 : 1;
  }
  EXPECT_TRUE(isFree(foldsBeside(rays.arrays())));
  EXPECT_TRUE(foldsBeside({}).empty());
}
