// Seas that break on their way, against the energy balance of one wave on a plane beach.
#include "sim/Angles.h"
#include "sim/Breaking.h"
#include "sim/BuiltinSeafloor.h"
#include "sim/Dispersion.h"
#include "sim/SpectralSea.h"
#include "sim/SpectralSurf.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

using namespace swellray;

namespace
{

constexpr double Period = 10.0;
constexpr double Slope = 0.02;

// A sea of one direction bin and a narrow band about 0.1 Hz, of so many metres Hs, straight to the beach (towards -x).
DirectionalSpectrum narrowSea(double height)
{
  DirectionalSpectrum sea;
  sea.grid = SpectralGrid::logarithmic(0.098, 1.0 / (0.098 * Period * Period), 3, 72);
  sea.density.assign(sea.grid.size(), 0.0);
  for (std::size_t j = 0; j < sea.grid.headings.size(); ++j)
  {
    if (std::abs(std::remainder(sea.grid.headings[j] - Pi, 2.0 * Pi)) < 1e-9)
    {
      sea.density[1 * sea.grid.headings.size() + j] = 1.0;
    }
  }
  const double made = seaParameters(sea).significantHeight;
  for (double& density : sea.density)
  {
    density *= height * height / (made * made);
  }
  return sea;
}

// Hrms on a plane beach by the balance d(E Cg)/dx = -D in small steps from deep water, normal incidence; Battjes and Janssen's D
// with a gamma, Baldock's with that of each place.
double heightOnBeach(double deepHeight, double depth, std::optional<double> gamma)
{
  const double omega = 2.0 * Pi / Period;
  const auto speed = [&](double h)
  { return waveSpeeds(solveWavenumber(omega, h, StandardGravity), h, StandardGravity).groupSpeed; };
  const double c0 = 0.5 * StandardGravity / omega;
  double flux = deepHeight * deepHeight * c0; // H^2 Cg
  constexpr double Step = 1e-4;               // of the depth: its square is the error
  double h = 40.0;
  while (h > depth)
  {
    const double next = std::max(depth, h * (1.0 - Step));
    const double middle = 0.5 * (h + next);
    const double k = solveWavenumber(omega, middle, StandardGravity);
    const double highest = randomWaveLimit(k, middle, gamma.value_or(ruessinkGamma(k, middle)));
    const double height = std::sqrt(flux / speed(middle));
    const double rate =
      gamma ? randomWaveLossRate(height / highest, Period) : baldockLossRate(height / highest, height / middle, Period);
    flux *= std::exp(-rate * (h - next) / Slope / speed(middle));
    flux = gamma ? std::min(flux, highest * highest * speed(middle)) : flux;
    h = next;
  }
  return std::sqrt(flux / speed(depth));
}

struct Beach
{
  std::unique_ptr<Seafloor> Floor = makeBuiltinSeafloor("plane:slope=0.02,x0=-100,x1=2500,y0=-20000,y1=20000");
  BackwardTracer Tracer{ *Floor, BackwardOptions() };
  DirectionalSpectrum Sea;
  SpectralSeaOptions Options;

  explicit Beach(double height)
    : Sea(narrowSea(height))
  {
    this->Options.rays.grid = { this->Sea.grid.frequencies, SpectralGrid::logarithmic(0.1, 1.0, 2, 36).headings };
    this->Options.rays.perDirection = 3;
    this->Options.breaking = BreakingRule::BattjesJanssen;
    this->Options.gamma = 0.7;
  }

  std::vector<PlaceSea> at(const std::vector<double>& depths) const
  {
    std::vector<glm::dvec2> places;
    for (const double depth : depths)
    {
      places.emplace_back(depth / Slope, 0.0);
    }
    return transformSea(this->Tracer, this->Options, this->Sea, places);
  }
};

}

TEST(BackwardTracer, theWayOfAWaveKeepsSnellFromTheEdgeToThePlace)
{
  const auto floor = makeBuiltinSeafloor("plane:slope=0.02,x0=-100,x1=2500,y0=-20000,y1=20000");
  BackwardOptions options;
  options.tolerance = 1e-10;
  const BackwardTracer tracer(*floor, options);
  const glm::dvec2 place(200.0, 0.0);
  const double heading = radians(160.0);
  std::vector<RayPoint> way;
  const WaveOrigin origin = tracer.trace(place, 1.0 / Period, heading, 8.0, way);
  ASSERT_GT(way.size(), 100u);
  EXPECT_NEAR(way.front().position.x, 2500.0, 1e-6);
  EXPECT_EQ(way.back().position, place);
  EXPECT_EQ(way.front().travelTime, 0.0);
  EXPECT_EQ(way.back().travelTime, origin.travelTime);
  EXPECT_NEAR(origin.travelTime, tracer.trace(place, 1.0 / Period, heading).travelTime, 1e-6);
  const double ky = glm::length(way.back().wavenumber) * std::sin(heading);
  for (std::size_t i = 0; i + 1 < way.size(); ++i)
  {
    EXPECT_LT(way[i].travelTime, way[i + 1].travelTime);
    EXPECT_NEAR(way[i].depth, Slope * way[i].position.x, 1e-9);
    const double k = glm::length(way[i].wavenumber);
    EXPECT_NEAR(k, solveWavenumber(2.0 * Pi / Period, way[i].depth, StandardGravity), 1e-9);
    // The chord of an eighth of a wave has the direction of its middle.
    const glm::dvec2 chord = glm::normalize(way[i + 1].position - way[i].position);
    EXPECT_NEAR(0.5 * (k + glm::length(way[i + 1].wavenumber)) * chord.y, ky, 2e-4 * k);
  }
  EXPECT_TRUE(std::isnan(tracer.trace(place, 1.0 / Period, 0.0, 8.0, way).heading)); // from the shore
  tracer.trace(glm::dvec2(-50.0, 0.0), 1.0 / Period, heading, 8.0, way);             // on land
  EXPECT_TRUE(way.empty());
}

TEST(SpectralSurf, aNarrowSeaBreaksAsTheEnergyBalanceOfItsWave)
{
  const Beach beach(2.0);
  const std::vector<double> depths{ 12.0, 4.0, 2.5, 1.5, 0.8 };
  const std::vector<PlaceSea> seas = beach.at(depths);
  // The bin of 5 degrees and the narrow band spread the sea by some thousandths of its height; knots lie a wave apart.
  constexpr double Tolerance = 0.01;
  for (std::size_t i = 0; i < depths.size(); ++i)
  {
    const double exact = heightOnBeach(2.0 / std::sqrt(2.0), depths[i], 0.7);
    EXPECT_NEAR(seas[i].parameters.significantHeight / std::sqrt(2.0), exact, Tolerance * exact) << depths[i];
  }
  EXPECT_FALSE(seas[0].breaking);
  EXPECT_TRUE(seas[3].breaking);
}

TEST(SpectralSurf, baldockHasTheIndexOfEachPlace)
{
  Beach beach(2.0);
  beach.Options.breaking = BreakingRule::Baldock;
  beach.Options.gamma = std::nullopt;
  const std::vector<double> depths{ 12.0, 4.0, 2.5, 1.5, 0.8 };
  const std::vector<PlaceSea> seas = beach.at(depths);
  constexpr double Tolerance = 0.01; // as above
  for (std::size_t i = 0; i < depths.size(); ++i)
  {
    const double exact = heightOnBeach(2.0 / std::sqrt(2.0), depths[i], std::nullopt);
    EXPECT_NEAR(seas[i].parameters.significantHeight / std::sqrt(2.0), exact, Tolerance * exact) << depths[i];
  }
  EXPECT_FALSE(seas[0].breaking);
  EXPECT_TRUE(seas[3].breaking);
}

TEST(SpectralSurf, aLowSeaLosesNothing)
{
  Beach beach(0.1);
  const std::vector<PlaceSea> broken = beach.at({ 3.0 });
  beach.Options.breaking = BreakingRule::None;
  const std::vector<PlaceSea> unbroken = beach.at({ 3.0 });
  EXPECT_NEAR(broken[0].parameters.significantHeight, unbroken[0].parameters.significantHeight, 1e-9);
}

TEST(SpectralSurf, withoutAWayTheDepthAtThePlaceCounts)
{
  const Beach beach(2.0);
  const SpectralSurf surf(beach.Tracer, beach.Options.rays, beach.Sea, BreakingRule::BattjesJanssen, 0.7);
  DirectionalSpectrum high = narrowSea(3.0);
  std::rotate(high.density.begin(), high.density.begin() + 36, high.density.end()); // from the land: no such wave
  ASSERT_NEAR(seaParameters(high).meanDirectionFrom, 270.0, 1e-6);
  const double depth = 1.0;
  const SpectralSurf::Outcome outcome = surf.at({ depth / Slope, 0.0 }, depth, high);
  const double k = solveWavenumber(2.0 * Pi / Period, depth, StandardGravity);
  const double highest = randomWaveLimit(k, depth, 0.7);
  EXPECT_NEAR(outcome.share * 4.5, highest * highest, 1e-3 * highest * highest);
  EXPECT_TRUE(outcome.breaking);
}

TEST(SpectralSurf, gammaIsThatOfTheSteepnessUnlessGiven)
{
  const Beach beach(2.0);
  const double deepLength = StandardGravity * Period * Period / (2.0 * Pi);
  const SpectralSurf surf(beach.Tracer, beach.Options.rays, beach.Sea, BreakingRule::BattjesJanssen, std::nullopt);
  EXPECT_NEAR(surf.gamma(), battjesStiveGamma(2.0 / std::sqrt(2.0) / deepLength), 1e-3);
  EXPECT_THROW(SpectralSurf(beach.Tracer, beach.Options.rays, beach.Sea, BreakingRule::BattjesJanssen, 0.0),
    std::invalid_argument);
  EXPECT_THROW(
    SpectralSurf(beach.Tracer, beach.Options.rays, beach.Sea, BreakingRule::Dally, 0.7), std::invalid_argument);
}

TEST(SpectralSurf, isRefusedWhereItCannotBe)
{
  Beach beach(1.0);
  const std::vector<SpectralOrigins> origins = traceOrigins(beach.Tracer, beach.Options.rays, { { 200.0, 0.0 } });
  EXPECT_THROW(transformSea(beach.Options, beach.Sea, origins), std::invalid_argument);
  beach.Options.breaking = BreakingRule::Dally;
  EXPECT_THROW(beach.at({ 3.0 }), std::invalid_argument);
}
