#include "sim/GaussianBeams.h"

#include "sim/Angles.h"
#include "sim/RayField.h"
#include "sim/RayMap.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <vector>

namespace
{

using namespace swellray;

constexpr double Wavenumber = 1.0; // rad/m
constexpr double Length = 1000.0;  // F, m: way from the launch to the focus
constexpr double Fall = 0.25;      // rad, over which the amplitude falls

// Terms of the next order are those of the amplitude's second derivative over a beam, 1/(k F fall^2) = 0.016.
constexpr double NextOrder = 0.016;

// Beams end at 1e-4 of what they are on their rays.
constexpr double Ends = 2e-4;

/**
 * Rays of the waves u = integral of a exp(i (k (x cos theta + y sin theta) + phi)) d theta on level ground. The ray of angle
 * theta passes the origin at n0 = -phi'/k to its left, has the phase k s + phi at the way s past it, and a tube of the
 * width s + n0' d theta. With lambda = -F theta it is -(s + n0')/F times as wide as at s = -F, where the height of the waves
 * is a (2 pi/(k F))^(1/2).
 */
struct Fan
{
  std::function<double(double)> amplitude; // a
  double quartic = 0.0;                    // phi = quartic theta^4
  std::vector<std::int64_t> offsets{ 0 };
  std::vector<double> positions, phase, lambda, direction, wavenumber, height, refraction, tube;
  std::vector<std::int32_t> segment, parent, caustics;
  std::vector<std::uint8_t> lee, breaking, state;
  std::vector<RayCaustic> touched;

  double offset(double theta) const { return -4.0 * this->quartic * theta * theta * theta / Wavenumber; }

  void addRay(double theta)
  {
    const glm::dvec2 along(std::cos(theta), std::sin(theta));
    const glm::dvec2 left(-along.y, along.x);
    const double n0 = this->offset(theta);
    const double turn = -12.0 * this->quartic * theta * theta / Wavenumber; // n0'
    const double closing = -turn;
    const double unit = this->amplitude(theta) * std::sqrt(2.0 * Pi / (Wavenumber * Length));
    for (double s = -Length; s <= 2.0 * Length; s += 7.0)
    {
      const double width = -(s - closing) / Length;
      this->point(s * along + n0 * left, along, Wavenumber * s + this->quartic * std::pow(theta, 4), unit, width,
        s > closing ? 1 : 0);
    }
    RayCaustic caustic;
    caustic.ray = static_cast<std::int32_t>(this->lambda.size());
    caustic.number = 1;
    caustic.position = closing * along + n0 * left;
    caustic.rayDirection = along;
    caustic.phase = Wavenumber * closing + this->quartic * std::pow(theta, 4);
    caustic.wavenumber = Wavenumber * along;
    caustic.phaseRate = Wavenumber;
    caustic.fanWavenumber = Wavenumber;
    caustic.widthRate = -1.0 / Length;
    caustic.alongRate = (-24.0 * this->quartic * theta / Wavenumber + n0) / Length;
    caustic.alongChange = -(-24.0 * this->quartic / Wavenumber + turn) / (Length * Length);
    this->touched.push_back(caustic);
    this->close(-Length * theta, 0);
  }

  // A plane wave of height 1 beside it, its rays from x = -F on.
  void addPlane(const glm::dvec2& along, double spacing)
  {
    const glm::dvec2 left(-along.y, along.x);
    for (double n = -2500.0; n <= 2500.0; n += spacing)
    {
      for (double s = -2000.0; s <= 2000.0; s += 7.0)
      {
        this->point(s * along + n * left, along, Wavenumber * s, 1.0, 1.0, 0);
      }
      this->close(n, 1);
    }
  }

  void point(const glm::dvec2& place, const glm::dvec2& along, double s, double unit, double width, std::int32_t turned)
  {
    this->positions.insert(this->positions.end(), { place.x, place.y, 0.0 });
    this->direction.insert(this->direction.end(), { along.x, along.y, 0.0 });
    this->phase.push_back(s);
    this->wavenumber.push_back(Wavenumber);
    this->tube.push_back(width);
    this->refraction.push_back(1.0 / std::sqrt(std::abs(width)));
    this->height.push_back(unit * this->refraction.back());
    this->caustics.push_back(turned);
    this->breaking.push_back(0);
    this->state.push_back(static_cast<std::uint8_t>(RayState::Alive));
  }

  void close(double parameter, std::int32_t piece)
  {
    this->offsets.push_back(static_cast<std::int64_t>(this->phase.size()));
    this->lambda.push_back(parameter);
    this->segment.push_back(piece);
    this->parent.push_back(-1);
    this->lee.push_back(0);
  }

  RaySheets sheets() const
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
    rays.refraction = this->refraction.data();
    rays.tubeWidth = this->tube.data();
    rays.caustics = this->caustics.data();
    rays.breaking = this->breaking.data();
    rays.state = this->state.data();
    rays.touched = this->touched.data();
    rays.touchedCount = this->touched.size();
    return RaySheets(rays, 0.0);
  }

  // exp(-i pi/4): on its way to the focus a wave of rays has the phase S + pi/4.
  std::complex<double> exact(const glm::dvec2& place) const
  {
    constexpr int count = 20000;
    constexpr double widest = 1.2;
    std::complex<double> sum = 0.0;
    for (int i = 0; i < count; ++i)
    {
      const double theta = widest * (2.0 * (i + 0.5) / count - 1.0);
      const double angle = Wavenumber * (place.x * std::cos(theta) + place.y * std::sin(theta));
      sum += std::polar(this->amplitude(theta), angle + this->quartic * std::pow(theta, 4));
    }
    return sum * (2.0 * widest / count) * std::polar(1.0, -0.25 * Pi);
  }
};

// Amplitudes that fall to nothing before the fan ends, so that it has no edges.
Fan fan(double quartic, double spacing, double fall = Fall)
{
  Fan rays;
  rays.amplitude = [fall](double theta) { return std::exp(-theta * theta / (2.0 * fall * fall)); };
  rays.quartic = quartic;
  // Half a distance aside, so that no ray runs into the cusp itself.
  const double step = spacing / Length;
  for (int i = static_cast<int>(1.2 / step); i >= -static_cast<int>(1.2 / step); --i)
  {
    rays.addRay((i + 0.5) * step);
  }
  return rays;
}

std::complex<double> wave(const GaussianBeams& beams, const glm::dvec2& place)
{
  BeamShare share;
  share.weight = 1.0;
  beams.addRow(place, 1.0, 1, &share);
  return share.wave;
}

std::vector<glm::dvec2> placesAround(double reach)
{
  std::vector<glm::dvec2> places;
  for (double x = -0.4 * reach; x <= reach; x += 0.2 * reach)
  {
    for (double y = -reach; y <= reach; y += 0.125 * reach)
    {
      places.emplace_back(x, 0.4 * y);
    }
  }
  return places;
}

// Largest error over the largest wave.
double errorOf(const Fan& rays, const GaussianBeams& beams, const std::vector<glm::dvec2>& places)
{
  double error = 0.0;
  double largest = 0.0;
  for (const glm::dvec2& place : places)
  {
    const std::complex<double> exact = rays.exact(place);
    largest = std::max(largest, std::abs(exact));
    error = std::max(error, std::abs(wave(beams, place) - exact));
  }
  return error / largest;
}

TEST(GaussianBeams, AFocusIsASuperpositionOfPlaneWaves)
{
  const Fan rays = fan(0.0, 10.0);
  const RaySheets sheets = rays.sheets();
  const GaussianBeams beams(sheets);
  ASSERT_EQ(beams.foci().size(), 1U);
  EXPECT_LT(glm::length(beams.foci()[0].position), 1e-9);
  EXPECT_NEAR(beams.foci()[0].length, Length, 1e-9 * Length);
  EXPECT_LT(errorOf(rays, beams, placesAround(250.0)), NextOrder);
}

// At the origin, where phi is all that is left, Pearcey's integral is a Gamma function: 2 Gamma(5/4) quartic^(-1/4).
TEST(GaussianBeams, ACuspIsPearceysIntegral)
{
  const Fan rays = fan(1000.0, 10.0);
  const RaySheets sheets = rays.sheets();
  const GaussianBeams beams(sheets);
  ASSERT_EQ(beams.foci().size(), 1U);
  EXPECT_LT(errorOf(rays, beams, placesAround(250.0)), NextOrder);
  // The integral is over 1000^(-1/4) = 0.18 rad, over which the amplitude falls by a fifth.
  const double peak = 2.0 * std::tgamma(1.25) * std::pow(1000.0, -0.25);
  EXPECT_NEAR(std::abs(wave(beams, glm::dvec2(0.0))) / peak, 1.0, 0.2);
}

// The trapezoidal rule of a Gaussian, whose places are x widths apart, is off by 2 exp(-2 pi^2/x^2).
TEST(GaussianBeams, TheSumOverRaysConvergesFasterThanAnyPower)
{
  const Fan fine = fan(1000.0, 5.0);
  const RaySheets fineSheets = fine.sheets();
  const GaussianBeams exact(fineSheets);
  const std::complex<double> spread = exact.foci()[0].spread;
  const double peak = std::abs(wave(exact, glm::dvec2(0.0)));
  for (const double spacing : { 90.0, 75.0, 60.0, 45.0 })
  {
    const Fan rays = fan(1000.0, spacing);
    const RaySheets sheets = rays.sheets();
    const GaussianBeams beams(sheets);
    double error = 0.0;
    for (const glm::dvec2& place : placesAround(20.0))
    {
      error = std::max(error, std::abs(wave(beams, place) - wave(exact, place)) / peak);
    }
    // The widest tubes at the cusp are those 0.25 rad aside, 0.75 wide.
    const double x = spacing * std::abs(0.75 * spread + Wavenumber / Length) / std::sqrt(spread.imag());
    const double bound = 2.0 * std::exp(-2.0 * Pi * Pi / (x * x));
    EXPECT_LT(error, 2.0 * bound + Ends) << spacing;
    if (spacing > 80.0)
    {
      EXPECT_GT(error, 0.1 * bound); // or there is nothing to see
    }
  }
}

// The next order goes with 1/(k F).
TEST(GaussianBeams, ErrorsAreOfTheNextOrder)
{
  std::vector<double> errors;
  for (const double fall : { 0.15, 0.3 })
  {
    Fan rays = fan(0.0, 10.0, fall);
    const RaySheets sheets = rays.sheets();
    const GaussianBeams beams(sheets);
    errors.push_back(errorOf(rays, beams, placesAround(100.0)));
  }
  // Of the second power of the beam's angle over that in which the amplitude falls.
  EXPECT_NEAR(errors[0] / errors[1], 4.0, 1.0) << errors[0] << " " << errors[1];
}

TEST(GaussianBeams, APlaneWaveThatCrossesIsReproduced)
{
  Fan rays = fan(1000.0, 10.0);
  const RaySheets aloneSheets = rays.sheets();
  const GaussianBeams alone(aloneSheets);
  Fan both = fan(1000.0, 10.0);
  const glm::dvec2 along(std::cos(1.0), std::sin(1.0));
  both.addPlane(along, 20.0);
  const RaySheets bothSheets = both.sheets();
  const GaussianBeams beams(bothSheets);
  for (const glm::dvec2& place : placesAround(250.0))
  {
    const std::complex<double> plane = wave(beams, place) - wave(alone, place);
    const std::complex<double> exact = std::polar(1.0, Wavenumber * glm::dot(along, place));
    ASSERT_LT(std::abs(plane - exact), Ends) << place.x << " " << place.y;
  }
}

TEST(GaussianBeams, ARowIsItsPlaces)
{
  const Fan rays = fan(1000.0, 20.0);
  const RaySheets sheets = rays.sheets();
  const GaussianBeams beams(sheets);
  std::vector<BeamShare> row(60);
  for (std::size_t i = 0; i < row.size(); ++i)
  {
    row[i].weight = i % 3 == 0 ? 0.0 : 1.0;
  }
  beams.addRow({ -300.0, 37.0 }, 13.0, row.size(), row.data());
  for (std::size_t i = 0; i < row.size(); ++i)
  {
    if (i % 3 == 0)
    {
      EXPECT_EQ(row[i].wave, std::complex<double>(0.0));
      EXPECT_EQ(row[i].weight, 0.0);
      continue;
    }
    BeamShare one;
    one.weight = 1.0;
    beams.addRow({ -300.0 + 13.0 * static_cast<double>(i), 37.0 }, 1.0, 1, &one);
    EXPECT_EQ(row[i].wave, one.wave) << i;
    EXPECT_EQ(row[i].weight, one.weight) << i;
  }
}

// What the map says is the wave itself, whatever the order of work.
TEST(GaussianBeams, MapsCarryThem)
{
  const Fan rays = fan(1000.0, 10.0);
  const RaySheets sheets = rays.sheets();
  const MapGrid grid{ 21, 21, { -20.0, -20.0 }, glm::dvec2(2.0) };
  const RayMap map = mapRays(sheets, grid, nullptr, CombineRule::Phase);
  Execution backwards;
  backwards.loop = [](std::size_t n, const std::function<void(std::size_t, std::size_t)>& body)
  {
    for (std::size_t i = n; i-- > 0;)
    {
      body(i, i + 1);
    }
  };
  const RayMap again = mapRays(sheets, grid, nullptr, CombineRule::Phase, backwards);
  std::vector<glm::dvec2> places;
  double largest = 0.0;
  for (std::size_t i = 0; i < map.height.size(); ++i)
  {
    places.push_back(grid.origin +
      grid.spacing * glm::dvec2(static_cast<double>(i % grid.columns), static_cast<double>(i / grid.columns)));
    largest = std::max(largest, std::abs(rays.exact(places[i])));
  }
  const RayMap samples = sampleRays(sheets, places, nullptr, CombineRule::Phase);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    ASSERT_NEAR(map.height[i], std::abs(rays.exact(places[i])), NextOrder * largest)
      << places[i].x << " " << places[i].y;
    ASSERT_EQ(map.height[i], again.height[i]);
    ASSERT_EQ(map.height[i], samples.height[i]);
  }
}

TEST(GaussianBeams, GiveWayWhereTheirRaysEnd)
{
  Fan rays = fan(1000.0, 10.0);
  // All rays of one half, up to the middle, run aground before the cusp.
  for (std::size_t ray = 0; ray < rays.lambda.size(); ++ray)
  {
    for (std::int64_t i = rays.offsets[ray]; rays.lambda[ray] < -200.0 && i < rays.offsets[ray + 1]; ++i)
    {
      rays.state[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(
        rays.phase[static_cast<std::size_t>(i)] < -200.0 ? RayState::Alive : RayState::Aground);
    }
  }
  const RaySheets sheets = rays.sheets();
  const GaussianBeams beams(sheets);
  ASSERT_FALSE(beams.empty());
  const auto weightAt = [&](const glm::dvec2& place)
  {
    BeamShare share;
    share.weight = 1.0;
    beams.addRow(place, 1.0, 1, &share);
    return share.weight;
  };
  const auto on = [&](double theta, double s)
  {
    const glm::dvec2 along(std::cos(theta), std::sin(theta));
    return s * along + rays.offset(theta) * glm::dvec2(-along.y, along.x);
  };
  // On the last ray of the rest, and far from it.
  EXPECT_EQ(weightAt(on(0.2, 100.0)), 0.0);
  EXPECT_EQ(weightAt(on(-0.4, 100.0)), 1.0);
}

TEST(GaussianBeams, AWallPartsThem)
{
  const Fan rays = fan(1000.0, 10.0);
  const RaySheets sheets = rays.sheets();
  const GaussianBeams open(sheets);
  Obstacle wall;
  wall.points = { { 50.0, 30.0 }, { 400.0, 30.0 } };
  const Obstacles walls({ wall });
  SheetRays withWalls = sheets.rays();
  const std::vector<std::uint8_t> ends(rays.lambda.size(), static_cast<std::uint8_t>(EndReason::LeftScene));
  withWalls.obstacles = &walls;
  withWalls.endReason = ends.data();
  const RaySheets wallSheets(withWalls, 0.0);
  const GaussianBeams beams(wallSheets);
  BeamShare share;
  share.weight = 1.0;
  open.addRow({ 200.0, 40.0 }, 1.0, 1, &share);
  EXPECT_EQ(share.weight, 1.0);
  share.weight = 1.0;
  beams.addRow({ 200.0, 40.0 }, 1.0, 1, &share);
  EXPECT_EQ(share.weight, 0.0);
}

TEST(GaussianBeams, ThereAreNoneWithoutAFocus)
{
  Fan rays = fan(1000.0, 10.0);
  // One arm of the cusp alone is a fold.
  rays.touched.erase(std::remove_if(rays.touched.begin(), rays.touched.end(),
                       [](const RayCaustic& caustic) { return caustic.alongRate < 0.02; }),
    rays.touched.end());
  ASSERT_GT(rays.touched.size(), 10U);
  const RaySheets folds = rays.sheets();
  EXPECT_TRUE(GaussianBeams(folds).empty());
  // Nor on a current.
  Fan current = fan(1000.0, 10.0);
  for (RayCaustic& caustic : current.touched)
  {
    caustic.fanWavenumber *= 1.1;
  }
  const RaySheets drifting = current.sheets();
  EXPECT_TRUE(GaussianBeams(drifting).empty());
}

TEST(GaussianBeams, ReachAllAroundButNotFarAhead)
{
  const Fan rays = fan(1000.0, 10.0);
  const RaySheets sheets = rays.sheets();
  const GaussianBeams beams(sheets);
  EXPECT_EQ(beams.reach({ 0.0, 0.0 }), 1.0);
  EXPECT_EQ(beams.reach({ 4.9 * Length, 0.0 }), 1.0);
  EXPECT_EQ(beams.reach({ 8.1 * Length, 0.0 }), 0.0);
  EXPECT_EQ(beams.reach({ -0.5 * Length, 0.0 }), 1.0);
  EXPECT_EQ(beams.reach({ -1.3 * Length, 0.0 }), 0.0);
}

}
