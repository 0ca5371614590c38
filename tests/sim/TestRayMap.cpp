#include "sim/RayMap.h"

#include "sim/Angles.h"
#include "sim/RayField.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <stdexcept>
#include <vector>

namespace
{

using namespace swellray;

// Heights and phases of plane waves are linear: only rounding is left, of phases of some hundreds.
constexpr double Rounding = 1e-11;

// Rays with their heights as a ray file has them.
struct Rays
{
  std::vector<std::int64_t> offsets{ 0 };
  std::vector<double> positions, phase, lambda, direction, wavenumber, height;
  std::vector<std::int32_t> segment, parent, caustics;
  std::vector<std::uint8_t> lee, breaking, state;

  void point(const glm::dvec2& place, double s, const glm::dvec2& k, double h, RayState is = RayState::Alive)
  {
    const double size = glm::length(k);
    this->positions.insert(this->positions.end(), { place.x, place.y, 0.0 });
    this->direction.insert(this->direction.end(), { k.x / size, k.y / size, 0.0 });
    this->phase.push_back(s);
    this->wavenumber.push_back(size);
    this->height.push_back(h);
    this->caustics.push_back(0);
    this->breaking.push_back(0);
    this->state.push_back(static_cast<std::uint8_t>(is));
  }

  void close(double parameter, std::int32_t piece, std::int32_t from = -1, bool isLee = false)
  {
    this->offsets.push_back(static_cast<std::int64_t>(this->phase.size()));
    this->lambda.push_back(parameter);
    this->segment.push_back(piece);
    this->parent.push_back(from);
    this->lee.push_back(isLee ? 1 : 0);
  }

  // A plane wave from `corner` on: rays one metre apart to the left of the way, points a metre apart.
  void addPlane(const glm::dvec2& corner, const glm::dvec2& k, int count, int steps, double h, std::int32_t piece)
  {
    const glm::dvec2 along = k / glm::length(k);
    const glm::dvec2 left(-along.y, along.x);
    for (int ray = 0; ray < count; ++ray)
    {
      for (int i = 0; i <= steps; ++i)
      {
        const glm::dvec2 place = corner + static_cast<double>(ray) * left + static_cast<double>(i) * along;
        this->point(place, glm::dot(k, place), k, h);
      }
      this->close(ray, piece);
    }
  }

  RaySheets sheets(double maxSpacing = 0.0) const
  {
    SheetRays rays;
    rays.lines.rays = this->lambda.size();
    rays.lines.offsets = this->offsets.data();
    rays.lines.positions = this->positions.data();
    rays.lines.phase = this->phase.data();
    rays.lines.launchParameter = this->lambda.data();
    rays.lines.launchSegment = this->segment.data();
    rays.parent = this->parent.data();
    rays.lee = this->lee.data();
    rays.direction = this->direction.data();
    rays.wavenumber = this->wavenumber.data();
    rays.height = this->height.data();
    rays.caustics = this->caustics.data();
    rays.breaking = this->breaking.data();
    rays.state = this->state.data();
    return RaySheets(rays, maxSpacing);
  }
};

MapGrid grid(std::size_t columns, std::size_t rows, const glm::dvec2& origin = glm::dvec2(0.0), double spacing = 1.0)
{
  return { columns, rows, origin, glm::dvec2(spacing) };
}

// Pieces of the work in any order, one item each, last first.
Execution backwards()
{
  Execution execution;
  execution.loop = [](std::size_t n, const std::function<void(std::size_t, std::size_t)>& body)
  {
    for (std::size_t i = n; i-- > 0;)
    {
      body(i, i + 1);
    }
  };
  return execution;
}

TEST(RayMap, CoversEachNodeOnceWhereNodesLieOnRaysAndFronts)
{
  Rays rays;
  rays.addPlane({ 0.0, 0.0 }, { 0.7, 0.0 }, 11, 20, 2.0, 0);
  const RayMap map = mapRays(rays.sheets(), grid(21, 11), nullptr, CombineRule::Energy);
  for (std::size_t i = 0; i < map.height.size(); ++i)
  {
    ASSERT_EQ(map.count[i], 1) << "node " << i;
    ASSERT_NEAR(map.height[i], 2.0, Rounding);
    ASSERT_NEAR(map.directionFrom[i], 270.0, Rounding);
    ASSERT_NEAR(map.wavelength[i], 2.0 * Pi / 0.7, Rounding);
  }
}

TEST(RayMap, LeavesOutWhatNoRayReaches)
{
  Rays rays;
  rays.addPlane({ 0.0, 0.0 }, { 0.7, 0.0 }, 6, 10, 2.0, 0);
  const RayMap map = mapRays(rays.sheets(), grid(21, 11), nullptr, CombineRule::Energy);
  for (std::size_t i = 0; i < map.height.size(); ++i)
  {
    const bool covered = i % 21 <= 10 && i / 21 <= 5;
    EXPECT_EQ(map.count[i], covered ? 1 : 0) << "node " << i;
    EXPECT_EQ(std::isnan(map.height[i]), !covered) << "node " << i;
    EXPECT_EQ(std::isnan(map.directionFrom[i]), !covered) << "node " << i;
    EXPECT_EQ(std::isnan(map.wavelength[i]), !covered) << "node " << i;
  }
}

TEST(RayMap, GivesNoWaveToLand)
{
  Rays rays;
  rays.addPlane({ 0.0, 0.0 }, { 0.7, 0.0 }, 3, 2, 2.0, 0);
  const std::vector<double> depth = { 1.0, 0.0, 1.0, -1.0, 1.0, std::numeric_limits<double>::quiet_NaN(), 1.0, 1.0,
    1.0 };
  const RayMap map = mapRays(rays.sheets(), grid(3, 3), depth.data(), CombineRule::Energy);
  EXPECT_EQ(map.count, (std::vector<std::int32_t>{ 1, 0, 1, 0, 1, 0, 1, 1, 1 }));
}

// Two plane waves that cross: the exact sum is known.
struct Crossing
{
  Crossing()
  {
    this->rays.addPlane({ -5.0, -5.0 }, this->k1, 31, 40, this->h1, 0);
    this->rays.addPlane({ 5.0, -15.0 }, this->k2, 31, 50, this->h2, 1);
  }

  double coherent(const glm::dvec2& x) const
  {
    return std::abs(std::polar(this->h1, glm::dot(this->k1, x)) + std::polar(this->h2, glm::dot(this->k2, x)));
  }

  glm::dvec2 k1{ 0.8, 0.0 };
  glm::dvec2 k2{ 0.8 * std::cos(1.1), 0.8 * std::sin(1.1) };
  double h1 = 1.5;
  double h2 = 0.9;
  Rays rays;
};

TEST(RayMap, AddsEnergiesOrInterferes)
{
  const Crossing crossing;
  const RaySheets sheets = crossing.rays.sheets();
  const MapGrid nodes = grid(40, 30, { 0.3, 0.2 }, 0.37);
  const RayMap energy = mapRays(sheets, nodes, nullptr, CombineRule::Energy);
  const RayMap phase = mapRays(sheets, nodes, nullptr, CombineRule::Phase);
  const glm::dvec2 mean = 1.5 * 1.5 * crossing.k1 + 0.9 * 0.9 * crossing.k2;
  int both = 0;
  for (std::size_t i = 0; i < energy.height.size(); ++i)
  {
    if (energy.count[i] < 2)
    {
      continue;
    }
    ++both;
    const glm::dvec2 x = nodes.origin + nodes.spacing * glm::dvec2(i % 40, i / 40);
    ASSERT_EQ(energy.count[i], 2);
    ASSERT_NEAR(energy.height[i], std::hypot(1.5, 0.9), Rounding);
    ASSERT_NEAR(energy.directionFrom[i], nauticalFromVector(mean), 1e-9);
    ASSERT_NEAR(energy.wavelength[i], 2.0 * Pi / 0.8, Rounding);
    // The place is moved inwards by 1e-7 of the scene, 5e-6 m.
    ASSERT_NEAR(phase.height[i], crossing.coherent(x), 1e-5);
  }
  EXPECT_GT(both, 300);
}

TEST(RayMap, IsTheSameForAnyOrderOfWork)
{
  const Crossing crossing;
  const RaySheets sheets = crossing.rays.sheets();
  const MapGrid nodes = grid(77, 65, { 0.3, 0.2 }, 0.21);
  const RayMap once = mapRays(sheets, nodes, nullptr, CombineRule::Phase);
  const RayMap again = mapRays(sheets, nodes, nullptr, CombineRule::Phase, backwards());
  EXPECT_EQ(once.count, again.count);
  for (std::size_t i = 0; i < once.height.size(); ++i)
  {
    ASSERT_TRUE(once.height[i] == again.height[i] || (std::isnan(once.height[i]) && std::isnan(again.height[i])));
  }
}

TEST(RayMap, SamplesGiveWhatTheMapGivesAtItsNodes)
{
  const Crossing crossing;
  const RaySheets sheets = crossing.rays.sheets();
  const MapGrid nodes = grid(50, 45, { -7.0, -8.0 }, 0.71);
  std::vector<glm::dvec2> places;
  for (std::size_t i = 0; i < nodes.columns * nodes.rows; ++i)
  {
    places.push_back(nodes.origin + nodes.spacing * glm::dvec2(i % nodes.columns, i / nodes.columns));
  }
  const RayMap map = mapRays(sheets, nodes, nullptr, CombineRule::Phase);
  const RayMap samples = sampleRays(sheets, places, nullptr, CombineRule::Phase, backwards());
  EXPECT_EQ(map.count, samples.count);
  EXPECT_EQ(
    std::count(map.count.begin(), map.count.end(), 0), std::count(samples.count.begin(), samples.count.end(), 0));
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (map.count[i] > 0)
    {
      ASSERT_DOUBLE_EQ(map.height[i], samples.height[i]);
      ASSERT_DOUBLE_EQ(map.directionFrom[i], samples.directionFrom[i]);
    }
  }
}

TEST(RayMap, PhaseOfACurvedFrontIsOfThirdOrder)
{
  // Waves from a point: S = k r. The error of the phase falls by 8 where the mesh is twice as fine.
  const auto error = [](int rays)
  {
    constexpr double k = 0.5;
    Rays circular;
    const double angle = 0.8 / rays;
    for (int ray = 0; ray <= rays; ++ray)
    {
      const glm::dvec2 along(std::cos(ray * angle), std::sin(ray * angle));
      for (int i = 0; i <= rays; ++i)
      {
        const double r = 20.0 + 20.0 * i / rays;
        circular.point(r * along, k * r, k * along, 1.0);
      }
      circular.close(ray, 0);
    }
    const RaySheets sheets = circular.sheets();
    double worst = 0.0;
    for (int i = 0; i < 400; ++i)
    {
      const double r = 21.0 + 18.0 * (i % 20) / 19.3;
      const double at = 0.05 + 0.7 * (i / 20) / 20.0;
      const glm::dvec2 place = r * glm::dvec2(std::cos(at), std::sin(at));
      for (const RaySheets::Triangle& triangle : sheets.triangles())
      {
        WaveSheet wave;
        if (sheets.wave(triangle, place, wave))
        {
          worst = std::max(worst, std::abs(wave.phase - k * r));
        }
      }
    }
    return worst;
  };
  const double coarse = error(8);
  const double fine = error(16);
  EXPECT_LT(coarse, 1e-3);
  // Near 8, between the second order of a linear phase (4) and what places missed by chance allow.
  EXPECT_GT(coarse / fine, 6.0);
  EXPECT_GT(fine, 0.0);
}

// Ai(-z) by its power series (Abramowitz and Stegun 1964, eq. 10.4.2).
double airyOf(double z)
{
  const double cube = -z * z * z;
  double f = 1.0;
  double g = -z;
  double fTerm = 1.0;
  double gTerm = -z;
  for (int n = 1; n < 60; ++n)
  {
    fTerm *= cube / ((3.0 * n - 1.0) * 3.0 * n);
    gTerm *= cube / (3.0 * n * (3.0 * n + 1.0));
    f += fTerm;
    g += gTerm;
  }
  return 0.355028053887817239 * f - 0.258819403792806798 * g;
}

TEST(RayMap, InterferenceAtAPlaneFoldIsTheAiryFunction)
{
  // k^2 = k0^2 - mu x: rays are parabolas that all turn at xt. x = kx0 t - mu t^2/4, y = y0 + ky t, dS = k^2 dt.
  constexpr double kx0 = 0.05153756633785532;
  constexpr double ky = 0.089265683395616885;
  constexpr double xt = 400.0;
  constexpr double mu = kx0 * kx0 / xt;
  constexpr int steps = 400;
  constexpr double spacing = 5.0;
  Rays rays;
  for (double y0 = -2900.0; y0 < 100.0; y0 += spacing)
  {
    for (int i = 0; i <= steps; ++i)
    {
      const double t = 4.0 * kx0 / mu * i / steps;
      const double kx = kx0 - 0.5 * mu * t;
      const double phase = ky * (y0 + ky * t) + 2.0 / (3.0 * mu) * (kx0 * kx0 * kx0 - kx * kx * kx);
      rays.point({ kx0 * t - 0.25 * mu * t * t, y0 + ky * t }, phase, { kx, ky }, std::sqrt(kx0 / std::abs(kx)));
      rays.caustics.back() = kx < 0.0 ? 1 : 0;
    }
    rays.close(y0, 0);
  }
  std::vector<glm::dvec2> places;
  for (int i = 1; i < 200; ++i)
  {
    places.emplace_back(xt * i / 200.0, 0.5);
  }
  const RayMap map = sampleRays(rays.sheets(), places, nullptr, CombineRule::Phase);
  const double z0 = std::cbrt(mu) * xt;
  const double factor = 2.0 * std::sqrt(Pi) * std::pow(z0, 0.25);
  // Of the largest value, that of the Airy function at z = 1.0188.
  const double tolerance = 1e-2 * factor * airyOf(1.0188);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const double z = std::cbrt(mu) * (xt - places[i].x);
    ASSERT_EQ(map.count[i], 2) << places[i].x;
    EXPECT_NEAR(map.height[i], factor * std::abs(airyOf(z)), tolerance) << places[i].x;
  }
}

TEST(RaySheets, TurnedTubesCountTheirCaustic)
{
  // Two parallel strips; in the second the ray of the higher parameter stands to the right, as behind a caustic.
  for (const bool turned : { false, true })
  {
    Rays rays;
    for (int ray = 0; ray < 2; ++ray)
    {
      for (int i = 0; i < 2; ++i)
      {
        rays.point({ 3.0 * i, turned ? -ray : ray }, 3.0 * i, { 1.0, 0.0 }, 1.0);
        rays.caustics.back() = ray; // the two disagree
      }
      rays.close(ray, 0);
    }
    const RaySheets sheets = rays.sheets();
    WaveSheet wave;
    int found = 0;
    for (const RaySheets::Triangle& triangle : sheets.triangles())
    {
      for (const double y : { 0.1, 0.9 })
      {
        if (sheets.wave(triangle, { 1.0, turned ? -y : y }, wave))
        {
          EXPECT_EQ(wave.caustics, turned ? 1 : 0);
          ++found;
        }
      }
    }
    EXPECT_EQ(found, 2);
  }
}

TEST(RaySheets, BreakWhereARayBetweenHasEnded)
{
  Rays rays;
  for (int ray = 0; ray < 3; ++ray)
  {
    for (int i = 0; i <= (ray == 1 ? 5 : 10); ++i)
    {
      rays.point({ 4.0 * i, ray }, 4.0 * i, { 1.0, 0.0 }, 1.0);
    }
    rays.close(ray, 0);
  }
  const RayMap map = sampleRays(
    rays.sheets(), { { 18.0, 0.5 }, { 18.0, 1.5 }, { 30.0, 0.5 }, { 30.0, 1.5 } }, nullptr, CombineRule::Energy);
  EXPECT_EQ(map.count, (std::vector<std::int32_t>{ 1, 1, 0, 0 }));
}

TEST(RaySheets, GoOnAlongTheNeighbourToTheEdgeOfTheScene)
{
  // Rays leave over an edge at 45 degrees: what lies between their ends belongs to the sheet.
  Rays rays;
  for (int ray = 0; ray < 5; ++ray)
  {
    const double end = 20.0 + ray;
    for (double x = 0.0; x < end; x += 0.25)
    {
      rays.point({ x, ray }, x, { 1.0, 0.0 }, 1.0);
    }
    rays.point({ end, ray }, end, { 1.0, 0.0 }, 1.0, RayState::Dead);
    rays.close(ray, 0);
  }
  const RayMap map = sampleRays(
    rays.sheets(), { { 20.4, 0.5 }, { 20.6, 0.5 }, { 22.45, 2.5 }, { 22.55, 2.5 } }, nullptr, CombineRule::Energy);
  EXPECT_EQ(map.count, (std::vector<std::int32_t>{ 1, 0, 1, 0 }));
}

TEST(RaySheets, InsertedRaysBeginWithATriangle)
{
  Rays rays;
  for (const double y : { 0.0, 2.0 })
  {
    for (int i = 0; i <= 10; ++i)
    {
      rays.point({ i, y }, i, { 1.0, 0.0 }, 1.0);
    }
    rays.close(y, 0);
  }
  for (int i = 5; i <= 10; ++i)
  {
    rays.point({ i, 1.0 }, i, { 1.0, 0.0 }, 3.0);
  }
  rays.close(1.0, 0, 0);
  const RaySheets sheets = rays.sheets();
  const RayMap map = mapRays(sheets, grid(101, 21, { 0.0, 0.0 }, 0.1), nullptr, CombineRule::Energy);
  EXPECT_EQ(std::count(map.count.begin(), map.count.end(), 1), 101 * 21);
  const RayMap heights = sampleRays(sheets, { { 2.0, 1.0 }, { 7.0, 1.0 }, { 7.0, 0.5 } }, nullptr, CombineRule::Energy);
  EXPECT_NEAR(heights.height[0], 1.0, Rounding);
  EXPECT_NEAR(heights.height[1], 3.0, 1e-5); // the place is moved inwards by 1e-6 m
  EXPECT_NEAR(heights.height[2], 2.0, 1e-5);
}

TEST(RaySheets, DoNotSpanTheShoreNorWideGaps)
{
  const auto covered = [](double width, RayState second, bool lee, double maxSpacing)
  {
    Rays rays;
    for (int ray = 0; ray < 2; ++ray)
    {
      for (int i = 0; i <= 4; ++i)
      {
        rays.point({ 5.0 * i, ray * width }, 5.0 * i, { 1.0, 0.0 }, 1.0, second);
      }
      rays.close(ray, 0, -1, lee && ray == 1);
    }
    return sampleRays(rays.sheets(maxSpacing), { { 11.0, 0.3 * width } }, nullptr, CombineRule::Energy).count[0] == 1;
  };
  EXPECT_TRUE(covered(7.9, RayState::Alive, false, 1.0));
  EXPECT_FALSE(covered(8.1, RayState::Alive, false, 1.0));
  EXPECT_TRUE(covered(80.0, RayState::Alive, false, 0.0));
  EXPECT_TRUE(covered(1.9, RayState::Alive, true, 1.0));
  EXPECT_FALSE(covered(2.1, RayState::Alive, true, 1.0));
  EXPECT_FALSE(covered(1.0, RayState::Aground, false, 1.0));
}

TEST(RaySheets, AnInfiniteHeightStaysOnItsPoint)
{
  Rays rays;
  for (int ray = 0; ray < 2; ++ray)
  {
    for (int i = 0; i < 2; ++i)
    {
      rays.point({ i, ray }, i, { 1.0, 0.0 }, ray == 1 ? std::numeric_limits<double>::infinity() : 2.0);
    }
    rays.close(ray, 0);
  }
  // A tube that closes: its width, and with it 1/H^2, falls linearly to nothing.
  const RayMap map = sampleRays(rays.sheets(), { { 0.3, 0.75 } }, nullptr, CombineRule::Energy);
  EXPECT_NEAR(map.height[0], 2.0 / std::sqrt(0.25), 1e-5);
}

TEST(RaySheets, RefusesWhatIsNoWave)
{
  Rays rays;
  rays.addPlane({ 0.0, 0.0 }, { 0.7, 0.0 }, 2, 2, 2.0, 0);
  rays.phase[4] = std::numeric_limits<double>::quiet_NaN();
  try
  {
    rays.sheets();
    FAIL() << "a phase that is not finite was taken";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_NE(std::string(error.what()).find("ray 1: its point 1"), std::string::npos) << error.what();
  }
}

TEST(RayMap, RefusesAGridWithoutNodes)
{
  Rays rays;
  rays.addPlane({ 0.0, 0.0 }, { 0.7, 0.0 }, 2, 2, 2.0, 0);
  const RaySheets sheets = rays.sheets();
  EXPECT_THROW(mapRays(sheets, grid(0, 3), nullptr, CombineRule::Energy), std::invalid_argument);
  EXPECT_THROW(mapRays(sheets, grid(3, 3, {}, 0.0), nullptr, CombineRule::Energy), std::invalid_argument);
  EXPECT_THROW(mapRays(sheets, grid(3, 3, {}, std::nan("")), nullptr, CombineRule::Energy), std::invalid_argument);
}

TEST(RayMap, OfNoRaysIsEmpty)
{
  const Rays rays;
  const RayMap map = mapRays(rays.sheets(), grid(2, 2), nullptr, CombineRule::Energy);
  EXPECT_EQ(map.count, (std::vector<std::int32_t>(4, 0)));
}

}
