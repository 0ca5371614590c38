// The surface of a sea: its own spectrum and height against those asked for, its motion, tiles and rays.
#include "sim/Angles.h"
#include "sim/Dispersion.h"
#include "sim/SeaSurface.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <stdexcept>
#include <vector>

using namespace swellray;

namespace
{

// Hs over a long record.
constexpr double LongHeight = 0.03;

// Energy of a band below fmax: its edges cut through cells of the sampled spectrum, 3 % of the frequency wide on either side,
// bands are some 25 % wide.
constexpr double BandBelow = 0.25;

// Beyond fmax turbulence is fitted at fmax alone; its octaves make a ripple.
constexpr double BandBeyond = 0.4;

SeaSurface surfaceOf(const SeaSurfaceOptions& options, double height = 2.0, double period = 8.0)
{
  return SeaSurface(
    FrequencySpectrum::piersonMoskowitz(height, period), DirectionalSpreading::hasselmann(1.0 / period), 0.4, options);
}

// Mean square of each wavenumber of a square of n x n heights, 0 to n/2 and the negative ones, by summing rows, then columns.
std::vector<double> squareSpectrum(const std::vector<double>& heights, std::size_t n)
{
  using Complex = std::complex<double>;
  std::vector<Complex> turns(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    turns[i] = std::polar(1.0, -2.0 * Pi * static_cast<double>(i) / static_cast<double>(n));
  }
  std::vector<Complex> rows(n * n);
  for (std::size_t y = 0; y < n; ++y)
  {
    for (std::size_t k = 0; k < n; ++k)
    {
      Complex sum = 0.0;
      for (std::size_t x = 0; x < n; ++x)
      {
        sum += heights[y * n + x] * turns[k * x % n];
      }
      rows[y * n + k] = sum / static_cast<double>(n);
    }
  }
  std::vector<double> squares(n * n);
  for (std::size_t k = 0; k < n; ++k)
  {
    for (std::size_t l = 0; l < n; ++l)
    {
      Complex sum = 0.0;
      for (std::size_t y = 0; y < n; ++y)
      {
        sum += rows[y * n + k] * turns[l * y % n];
      }
      squares[l * n + k] = std::norm(sum / static_cast<double>(n));
    }
  }
  return squares;
}

}

TEST(SeaSurface, hasTheSignificantHeightOverALongRecord)
{
  for (const unsigned seed : { 1u, 2u })
  {
    SeaSurfaceOptions options;
    options.seed = seed;
    const SeaSurface sea = surfaceOf(options);
    double square = 0.0;
    constexpr int Count = 14400; // four hours
    for (int i = 0; i < Count; ++i)
    {
      square += std::pow(sea.height({ 12.0, -7.0 }, 1.0 * i), 2.0) / Count;
    }
    EXPECT_NEAR(4.0 * std::sqrt(square), 2.0, LongHeight * 2.0) << seed;
    EXPECT_NEAR(4.0 * std::sqrt(sea.meanSquare()), 2.0, 1e-9);
  }
}

TEST(SeaSurface, hasTheSpectrumAskedFor)
{
  SeaSurfaceOptions options;
  options.tile = 800.0; // eight waves
  const SeaSurface sea = surfaceOf(options);
  constexpr std::size_t n = 192;
  std::vector<double> heights(n * n);
  sampleSea(sea, { 0.0, 0.0 }, 800.0 / n, n, n, 3.0, heights.data(), nullptr);
  for (std::size_t i = 0; i < heights.size(); ++i)
  {
    heights[i] = sea.height(800.0 / n * glm::dvec2(i % n, i / n), 3.0); // nothing left out
  }
  const std::vector<double> squares = squareSpectrum(heights, n);
  const auto spectrum = FrequencySpectrum::piersonMoskowitz(2.0, 8.0);
  const double peak = 0.125;
  const std::vector<double> edges{ 0.75, 1.0, 1.25, 1.6, 2.1, 2.6, 3.3 };
  double whole = 0.0;
  std::vector<double> bands(edges.size() - 1, 0.0);
  double alongWind = 0.0;
  double acrossWind = 0.0;
  for (std::size_t i = 0; i < n * n; ++i)
  {
    const auto folded = [](std::size_t k)
    { return static_cast<double>(k) - (k > n / 2 ? static_cast<double>(n) : 0.0); };
    const glm::dvec2 k = 2.0 * Pi / 800.0 * glm::dvec2(folded(i % n), folded(i / n));
    const double f = std::sqrt(9.81 * glm::length(k)) / (2.0 * Pi) / peak;
    whole += squares[i];
    for (std::size_t band = 0; band + 1 < edges.size(); ++band)
    {
      bands[band] += f >= edges[band] && f < edges[band + 1] ? squares[i] : 0.0;
    }
    const double along = k.x * std::cos(0.4) + k.y * std::sin(0.4);
    const double across = k.y * std::cos(0.4) - k.x * std::sin(0.4);
    const double square = std::max(along * along + across * across, 1e-12);
    alongWind += squares[i] * along * along / square;
    acrossWind += squares[i] * across * across / square;
  }
  for (std::size_t band = 0; band < bands.size(); ++band)
  {
    const double wanted =
      (spectrum.shareBelow(edges[band + 1] * peak) - spectrum.shareBelow(edges[band] * peak)) * 0.25;
    const bool beyond = edges[band + 1] * peak > sea.highestFrequency();
    EXPECT_NEAR(bands[band], wanted, (beyond ? BandBeyond : BandBelow) * wanted) << "from " << edges[band] << " fp";
  }
  EXPECT_NEAR(4.0 * std::sqrt(whole), 2.0, LongHeight * 2.0);
  EXPECT_GT(alongWind, 1.5 * acrossWind); // waves go with the wind
  EXPECT_GT(sea.highestFrequency(), 1.4 * peak);
}

TEST(SeaSurface, takesTheWavesOfGreatestAmplitude)
{
  SeaSurfaceOptions options;
  options.turbulence = false;
  options.components = 40;
  const SeaSurface few = surfaceOf(options);
  options.components = 400;
  const SeaSurface many = surfaceOf(options);
  EXPECT_EQ(few.components().size(), 40u);
  EXPECT_EQ(many.components().size(), 400u);
  EXPECT_LT(few.highestFrequency(), many.highestFrequency());
  EXPECT_EQ(few.turbulence(), nullptr);
  // All of the energy is in them.
  double square = 0.0;
  for (const SeaComponent& wave : few.components())
  {
    square += 0.5 * wave.amplitude * wave.amplitude;
    const double k = glm::length(wave.wavenumber);
    EXPECT_NEAR(wave.frequency * wave.frequency, 9.81 * k, 1e-9);
    EXPECT_GT(wave.frequency * 8.0 / (2.0 * Pi), 0.7); // near the peak
    EXPECT_LT(wave.frequency * 8.0 / (2.0 * Pi), 1.5);
  }
  EXPECT_NEAR(square, 0.25, 1e-9);
}

TEST(SeaSurface, oneWaveMovesAtItsPhaseSpeed)
{
  SeaSurfaceOptions options;
  options.turbulence = false;
  options.components = 1;
  options.depth = 15.0;
  options.sharpness = 3.0;
  const SeaSurface sea = surfaceOf(options);
  const SeaComponent& wave = sea.components()[0];
  const double k = glm::length(wave.wavenumber);
  EXPECT_NEAR(k, solveWavenumber(wave.frequency, 15.0), 1e-9);
  const glm::dvec2 way = wave.frequency / k * wave.wavenumber / k;
  for (const double x : { 0.0, 11.0, 50.0 })
  {
    EXPECT_NEAR(sea.height(glm::dvec2(x, 3.0) + 7.0 * way, 7.0), sea.height({ x, 3.0 }, 0.0), 1e-9);
  }
}

TEST(SeaSurface, tilesFitAndOthersDoNotRepeat)
{
  SeaSurfaceOptions options;
  options.tile = 400.0;
  const SeaSurface tile = surfaceOf(options);
  options.tile.reset();
  const SeaSurface open = surfaceOf(options);
  const glm::dvec2 p(17.0, 33.0);
  EXPECT_NEAR(tile.height(p + glm::dvec2(400.0, -800.0), 9.0), tile.height(p, 9.0), 1e-9);
  EXPECT_GT(std::abs(open.height(p + glm::dvec2(400.0, -800.0), 9.0) - open.height(p, 9.0)), 1e-3);
  EXPECT_EQ(surfaceOf(options).height(p, 9.0), open.height(p, 9.0));
  options.seed = 5;
  EXPECT_NE(surfaceOf(options).height(p, 9.0), open.height(p, 9.0));
}

TEST(SeaSurface, aFootprintLeavesShortWavesOut)
{
  const SeaSurface sea = surfaceOf({});
  double before = 1e9;
  for (const double footprint : { 0.0, 1.0, 5.0, 15.0, 40.0, 300.0 })
  {
    double square = 0.0;
    for (int i = 0; i < 2000; ++i)
    {
      square += std::pow(sea.height({ 37.0 * i, 11.0 * i }, 0.0, footprint), 2.0) / 2000.0;
    }
    EXPECT_LT(square, before);
    before = square;
  }
  EXPECT_EQ(before, 0.0);
  EXPECT_EQ(footprintWeight(10.0, 2.5), 1.0);
  EXPECT_EQ(footprintWeight(10.0, 5.0), 0.0);
  EXPECT_NEAR(footprintWeight(10.0, 10.0 / 3.0), 0.5, 1e-12);
}

TEST(SeaSurface, gridsHoldHeightsAndNormals)
{
  const SeaSurface sea = surfaceOf({});
  constexpr double Spacing = 2.0;
  std::vector<double> heights(30);
  std::vector<float> normals(90);
  sampleSea(sea, { 5.0, -3.0 }, Spacing, 6, 5, 4.0, heights.data(), normals.data());
  const auto at = [&](double i, double j) {
    return sea.height({ 5.0 + Spacing * i, -3.0 + Spacing * j }, 4.0, Spacing);
  };
  for (std::size_t i = 0; i < 30; ++i)
  {
    const auto x = static_cast<double>(i % 6);
    const auto y = static_cast<double>(i / 6);
    EXPECT_EQ(heights[i], at(x, y));
    const glm::dvec3 wanted =
      glm::normalize(glm::dvec3(at(x - 1, y) - at(x + 1, y), at(x, y - 1) - at(x, y + 1), 2.0 * Spacing));
    for (std::size_t c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(normals[3 * i + c], wanted[static_cast<int>(c)], 1e-6);
    }
  }
  const glm::dvec3 normal = sea.normal({ 5.0, -3.0 }, 4.0, 2.0 * Spacing);
  EXPECT_NEAR(glm::length(normal), 1.0, 1e-12);
  EXPECT_GT(normal.z, 0.5);
}

TEST(SeaSurface, raysEndOnIt)
{
  const SeaSurface sea = surfaceOf({});
  const auto down = sea.march({ 3.0, 4.0, 50.0 }, { 0.0, 0.0, -1.0 }, 2.0, 100.0, 0.0);
  ASSERT_TRUE(down);
  EXPECT_NEAR(*down, 50.0 - sea.height({ 3.0, 4.0 }, 2.0), 2e-3);
  EXPECT_FALSE(sea.march({ 3.0, 4.0, 50.0 }, { 0.0, 0.0, -1.0 }, 2.0, 40.0, 0.0));
  EXPECT_FALSE(sea.march({ 3.0, 4.0, 5.0 }, { 0.6, 0.0, 0.8 }, 2.0, 1e5, 0.0));
  EXPECT_FALSE(sea.march({ 3.0, 4.0, 50.0 }, { 1.0, 0.0, 0.0 }, 2.0, 1e5, 0.0));
  for (const double tilt : { 0.02, 0.1, 0.5 })
  {
    const glm::dvec3 direction = glm::normalize(glm::dvec3(0.8, 0.6, -tilt));
    const glm::dvec3 origin(0.0, 0.0, 6.0);
    const auto hit = sea.march(origin, direction, 2.0, 2000.0, 0.001);
    ASSERT_TRUE(hit) << tilt;
    const glm::dvec3 p = origin + *hit * direction;
    const double footprint = 0.001 * *hit;
    EXPECT_NEAR(p.z, sea.height({ p.x, p.y }, 2.0, footprint), footprint);
    // Nothing stands before it, but for tips thinner than a footprint.
    for (double s = 0.0; s < *hit - 1.0; s += 0.05)
    {
      const glm::dvec3 q = origin + s * direction;
      EXPECT_GT(q.z, sea.height({ q.x, q.y }, 2.0, 0.001 * s) - 0.05) << tilt << ' ' << s;
    }
  }
}

TEST(SeaSurface, refusesWhatMakesNoSea)
{
  SeaSurfaceOptions options;
  options.tile = 150.0;
  EXPECT_THROW(surfaceOf(options), std::invalid_argument); // a wave and a half
  options.tile = 30000.0;
  EXPECT_THROW(surfaceOf(options), std::invalid_argument);
  options.tile.reset();
  options.components = 0;
  EXPECT_THROW(surfaceOf(options), std::invalid_argument);
  options.components = 10;
  options.sharpness = -1.0;
  EXPECT_THROW(surfaceOf(options), std::invalid_argument);
}
