// Many seas at many places by matrix products, against one sea at one place at a time.
#include "sim/Angles.h"
#include "sim/BuiltinSeafloor.h"
#include "sim/SeaTransfer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <thread>

using namespace swellray;

namespace
{

// The same sums in another order.
constexpr double Rounding = 1e-11;

struct Scene
{
  Scene()
  {
    this->Options.rays.grid = SpectralGrid::logarithmic(0.06, 0.3, 8, 24);
    this->Options.rays.perDirection = 2;
    this->Options.breaking = BreakingRule::Gamma;
    this->Options.gamma = 0.5;
    this->Origins = traceOrigins(this->Tracer, this->Options.rays, { { 400.0, 0.0 }, { 50.0, 30.0 }, { -50.0, 0.0 } });
    this->Offshore = { this->Options.rays.grid.frequencies, SpectralGrid::logarithmic(0.1, 1.0, 2, 72).headings };
  }

  DirectionalSpectrum sea(double height, double period, double from) const
  {
    return DirectionalSpectrum::sample(this->Offshore, FrequencySpectrum::jonswap(height, period),
      DirectionalSpreading::cosinePower(radians(20.0)), headingFromNautical(from));
  }

  std::unique_ptr<Seafloor> Floor = makeBuiltinSeafloor("plane:slope=0.02,x0=-100,x1=2000,y0=-5000,y1=5000");
  BackwardTracer Tracer{ *this->Floor, BackwardOptions() };
  SpectralSeaOptions Options;
  std::vector<SpectralOrigins> Origins;
  SpectralGrid Offshore;
};

}

TEST(SeaTransfer, isWhatEachSeaGivesAlone)
{
  const Scene scene;
  // More than one block, high and low, and one of nothing.
  std::vector<DirectionalSpectrum> seas;
  for (int i = 0; i < 70; ++i)
  {
    seas.push_back(scene.sea(0.2 + 0.1 * i, 7.0 + 0.05 * i, 50.0 + i));
  }
  seas[33].density.assign(scene.Offshore.size(), 0.0);
  std::vector<double> all;
  for (const DirectionalSpectrum& sea : seas)
  {
    all.insert(all.end(), sea.density.begin(), sea.density.end());
  }
  const SeaTransfer transfer(scene.Options.rays, scene.Offshore, scene.Origins, scene.Options.gamma);
  ASSERT_EQ(transfer.placeCount(), 3u);
  const std::vector<PlaceSea> together = transfer.apply(all, seas.size());
  ASSERT_EQ(together.size(), 3 * seas.size());
  int breaking = 0;
  for (std::size_t i = 0; i < seas.size(); ++i)
  {
    const std::vector<PlaceSea> alone = transformSea(scene.Options, seas[i], scene.Origins);
    for (std::size_t p = 0; p < 3; ++p)
    {
      const PlaceSea& a = alone[p];
      const PlaceSea& b = together[3 * i + p];
      EXPECT_EQ(a.known, b.known);
      EXPECT_EQ(a.breaking, b.breaking);
      breaking += b.breaking ? 1 : 0;
      EXPECT_EQ(a.depth, b.depth);
      if (i == 33 || p == 2)
      {
        EXPECT_TRUE(std::isnan(b.parameters.peakPeriod));
        EXPECT_TRUE(p == 2 ? std::isnan(b.parameters.significantHeight) : b.parameters.significantHeight == 0.0);
        continue;
      }
      EXPECT_NEAR(b.parameters.significantHeight, a.parameters.significantHeight, Rounding * 10.0);
      EXPECT_NEAR(b.parameters.peakPeriod, a.parameters.peakPeriod, Rounding * 1e3);
      EXPECT_NEAR(b.parameters.meanPeriod01, a.parameters.meanPeriod01, Rounding * 10.0);
      EXPECT_NEAR(b.parameters.meanPeriod02, a.parameters.meanPeriod02, Rounding * 10.0);
      EXPECT_NEAR(b.parameters.energyPeriod, a.parameters.energyPeriod, Rounding * 10.0);
      EXPECT_NEAR(b.parameters.meanDirectionFrom, a.parameters.meanDirectionFrom, Rounding * 1e3);
      EXPECT_NEAR(b.parameters.spread, a.parameters.spread, Rounding * 1e3);
    }
  }
  EXPECT_GT(breaking, 20);
  EXPECT_LT(breaking, 140);
}

TEST(SeaTransfer, transformingTracedPlacesIsTransformingPlaces)
{
  const Scene scene;
  const DirectionalSpectrum sea = scene.sea(1.0, 9.0, 80.0);
  std::vector<DirectionalSpectrum> spectra;
  const std::vector<PlaceSea> traced = transformSea(scene.Options, sea, scene.Origins, {}, &spectra);
  const std::vector<PlaceSea> direct =
    transformSea(scene.Tracer, scene.Options, sea, { { 400.0, 0.0 }, { 50.0, 30.0 }, { -50.0, 0.0 } });
  for (std::size_t p = 0; p < 2; ++p)
  {
    EXPECT_EQ(traced[p].parameters.significantHeight, direct[p].parameters.significantHeight);
    EXPECT_EQ(traced[p].parameters.meanDirectionFrom, direct[p].parameters.meanDirectionFrom);
  }
  EXPECT_FALSE(direct[2].known);
  EXPECT_EQ(spectra[0].density.size(), scene.Options.rays.grid.size());
}

TEST(SeaTransfer, isTheSameForAnyLoop)
{
  const Scene scene;
  Execution parallel;
  parallel.loop = [](std::size_t n, const std::function<void(std::size_t, std::size_t)>& body)
  {
    std::thread other([&] { body(n / 2, n); });
    body(0, n / 2);
    other.join();
  };
  const DirectionalSpectrum sea = scene.sea(1.0, 9.0, 80.0);
  const auto one = SeaTransfer(scene.Options.rays, scene.Offshore, scene.Origins, {}).apply(sea.density, 1);
  const auto two = SeaTransfer(scene.Options.rays, scene.Offshore, scene.Origins, {}, parallel).apply(sea.density, 1);
  EXPECT_EQ(one[0].parameters.significantHeight, two[0].parameters.significantHeight);
  EXPECT_EQ(one[1].parameters.significantHeight, two[1].parameters.significantHeight);
}

TEST(SeaTransfer, refusesWhatDoesNotFit)
{
  const Scene scene;
  const SeaTransfer transfer(scene.Options.rays, scene.Offshore, scene.Origins, {});
  EXPECT_THROW(transfer.apply(std::vector<double>(10), 1), std::invalid_argument);
  EXPECT_THROW(SeaTransfer(scene.Options.rays, scene.Offshore, scene.Origins, -1.0), std::invalid_argument);
  EXPECT_THROW(SeaTransfer(scene.Options.rays, SpectralGrid::logarithmic(0.1, 0.3, 8, 24), scene.Origins, {}),
    std::invalid_argument);
}
