// Backward rays and the spectra they make, against Snell's law, fluxes of energy and action, and forward rays.
#include "Currents.h"

#include "sim/BackwardTracer.h"
#include "sim/BuiltinCurrent.h"
#include "sim/BuiltinSeafloor.h"
#include "sim/SpectralTransfer.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <thread>

using namespace swellray;
using namespace swellray::testing;

namespace
{

// At the tolerance 1e-10 a step, some hundred steps.
constexpr double Tight = 1e-10;
constexpr double TightHeading = 1e-7;
constexpr double TightGain = 1e-9;

BackwardOptions options(double tolerance = Tight)
{
  BackwardOptions chosen;
  chosen.tolerance = tolerance;
  return chosen;
}

// Waves towards -x on a beach that faces east: heading of Snell's law offshore, NaN where there is none.
double snellOffshore(double frequency, double depth, double heading)
{
  const double omega = 2.0 * Pi * frequency;
  const double ky = solveWavenumber(omega, depth) * std::sin(heading);
  const double k0 = omega * omega / StandardGravity;
  return std::abs(ky) < k0 ? Pi - std::asin(ky / k0) : std::nan("");
}

double angle(double a, double b)
{
  return std::remainder(a - b, 2.0 * Pi);
}

const auto Wide = makeBuiltinSeafloor("plane:slope=0.02,x0=-100,x1=4000,y0=-40000,y1=40000");

}

TEST(BackwardTracer, straightBeachKeepsSnellForEveryFrequencyAndDirection)
{
  const BackwardTracer tracer(*Wide, options());
  const double depth = 6.0;
  const glm::dvec2 place(300.0, 0.0);
  ASSERT_NEAR(tracer.depth(place), depth, 1e-9);
  int offshore = 0;
  int trapped = 0;
  for (const double f : { 0.05, 0.08, 0.12, 0.2 })
  {
    const double omega = 2.0 * Pi * f;
    const double k = solveWavenumber(omega, depth);
    const WaveSpeeds here = waveSpeeds(k, depth);
    const double c0 = StandardGravity / omega;
    for (int degree = 92; degree < 270; degree += 6)
    {
      const WaveOrigin origin = tracer.trace(place, f, radians(degree));
      const double exact = snellOffshore(f, depth, radians(degree));
      if (std::isnan(exact))
      {
        // Turned back to the shore at a caustic, or out through a side edge where no offshore wave fits.
        EXPECT_TRUE(std::isnan(origin.heading)) << f << " " << degree;
        ++trapped;
        continue;
      }
      ASSERT_EQ(origin.reason, EndReason::LeftScene) << f << " " << degree;
      EXPECT_NEAR(angle(origin.heading, exact), 0.0, TightHeading) << f << " " << degree;
      EXPECT_NEAR(origin.gain, 0.5 * c0 * c0 / (here.phaseSpeed * here.groupSpeed), TightGain * 100.0);
      ++offshore;
    }
  }
  EXPECT_GT(offshore, 40);
  EXPECT_GT(trapped, 10);
  // From the shore nothing comes.
  EXPECT_TRUE(std::isnan(tracer.trace(place, 0.1, 0.0).heading));
  EXPECT_EQ(tracer.trace(place, 0.1, 0.0).reason, EndReason::Aground);
}

TEST(BackwardTracer, looseToleranceIsStillGoodToAThousandthOfADegree)
{
  const BackwardTracer tracer(*Wide, options(1e-5));
  for (int degree = 120; degree <= 240; degree += 10)
  {
    const double exact = snellOffshore(0.08, 6.0, radians(degree));
    if (!std::isnan(exact))
    {
      EXPECT_NEAR(angle(tracer.trace({ 300.0, 0.0 }, 0.08, radians(degree)).heading, exact), 0.0, 2e-5) << degree;
    }
  }
}

TEST(BackwardTracer, findsTheEdgeFromWhichAForwardRayComesBack)
{
  const auto seafloor = makeBuiltinSeafloor("shoal");
  BackwardOptions chosen = options(1e-11);
  chosen.edge = EdgeRule::None;
  const BackwardTracer tracer(*seafloor, chosen);
  const Rectangle bounds = seafloor->bounds();
  const glm::dvec2 place = bounds.low + bounds.size() * glm::dvec2(0.62, 0.53);
  for (const double heading : { -0.3, 0.1, 0.9, 2.0, 3.0 })
  {
    const WaveOrigin origin = tracer.trace(place, 0.1, heading);
    ASSERT_EQ(origin.reason, EndReason::LeftScene);
    // With EdgeRule::None the heading at the edge is the heading offshore.
    RayMedium medium;
    medium.seafloor = seafloor.get();
    medium.angularFrequency = 0.2 * Pi;
    RayStart start;
    start.position = origin.edge;
    start.wavenumber = solveWavenumber(medium.angularFrequency, medium.depth(origin.edge)) *
      glm::dvec2(std::cos(origin.heading), std::sin(origin.heading));
    HamiltonianRay ray(medium, start, 1e-11);
    RayPoint point;
    ASSERT_TRUE(ray.advance(FrontMeasure::Time, origin.travelTime, point));
    EXPECT_LT(glm::length(point.position - place), 1e-5) << heading; // m, over some kilometres
    EXPECT_NEAR(angle(std::atan2(point.wavenumber.y, point.wavenumber.x), heading), 0.0, 1e-8);
  }
}

TEST(BackwardTracer, currentKeepsTheActionOfEveryComponent)
{
  // A jet along y in deep water: ky is kept, and so is the flux of action through x, E/sigma times Gx.
  const FlatBed bed({ { -3000.0, -30000.0 }, { 3000.0, 30000.0 } }, 500.0);
  const auto jet = makeBuiltinCurrent("jet:V0=2,w=200");
  BackwardOptions chosen = options(1e-11);
  chosen.current = jet.get();
  chosen.edge = EdgeRule::None;
  const BackwardTracer tracer(bed, chosen);
  const double f = 0.1;
  const double omega = 2.0 * Pi * f;
  const glm::dvec2 place(0.0, 0.0);
  const glm::dvec2 u = jet->velocity(place);
  ASSERT_NEAR(u.y, 2.0, 1e-12);
  const double k0 = omega * omega / StandardGravity;
  const auto wavenumber = [&](double heading)
  {
    // sigma + k.U = omega in deep water: g k = (omega - k u)^2, the smaller root.
    const double a = u.y * std::sin(heading);
    const double b = StandardGravity + 2.0 * omega * a;
    return a == 0.0 ? k0 : (b - std::sqrt(b * b - 4.0 * a * a * omega * omega)) / (2.0 * a * a);
  };
  for (const double degree : { -50.0, -20.0, 10.0, 40.0 })
  {
    const double heading = radians(degree);
    const WaveOrigin origin = tracer.trace(place, f, heading);
    ASSERT_EQ(origin.reason, EndReason::LeftScene);
    const auto offshore = [&](double h) { return std::asin(wavenumber(h) * std::sin(h) / k0); };
    EXPECT_NEAR(angle(origin.heading, offshore(heading)), 0.0, 1e-8) << degree;
    const double k = wavenumber(heading);
    const double sigma = std::sqrt(StandardGravity * k);
    const double gx = 0.5 * sigma / k * std::cos(heading);
    const double gx0 = 0.5 * omega / k0 * std::cos(origin.heading);
    const double step = 1e-5;
    const double slope = (offshore(heading + step) - offshore(heading - step)) / (2.0 * step);
    // E dheading gx/sigma = E0 dheading0 gx0/omega
    EXPECT_NEAR(origin.gain, slope * gx0 / omega * sigma / gx, 1e-7) << degree;
  }
}

TEST(BackwardTracer, frictionTakesItsShareOnTheWay)
{
  const FlatBed bed({ { 0.0, -5000.0 }, { 4000.0, 5000.0 } }, 8.0);
  BackwardOptions chosen = options();
  chosen.friction = JonswapFriction;
  const BackwardTracer tracer(bed, chosen);
  BackwardOptions smooth = options();
  const BackwardTracer without(bed, smooth);
  const double f = 0.1;
  const double k = solveWavenumber(2.0 * Pi * f, 8.0);
  const double u = 2.0 * Pi * f / (StandardGravity * std::sinh(8.0 * k));
  const double time = 3000.0 / waveSpeeds(k, 8.0).groupSpeed;
  const WaveOrigin origin = tracer.trace({ 3000.0, 0.0 }, f, 0.0);
  EXPECT_NEAR(origin.travelTime, time, 1e-6 * time);
  EXPECT_NEAR(
    origin.gain / without.trace({ 3000.0, 0.0 }, f, 0.0).gain, std::exp(-JonswapFriction * u * u * time), 1e-9);
  EXPECT_LT(origin.gain, 0.9 * without.trace({ 3000.0, 0.0 }, f, 0.0).gain);
}

TEST(SpectralTransfer, deepWaterKeepsTheSpectrum)
{
  const FlatBed bed({ { -1000.0, -1000.0 }, { 1000.0, 1000.0 } }, 3000.0);
  SpectralRays rays;
  rays.grid = SpectralGrid::logarithmic(0.04, 0.4, 25, 72);
  const BackwardTracer tracer(bed, options(1e-5));
  const auto sea = DirectionalSpectrum::sample(
    rays.grid, FrequencySpectrum::jonswap(2.0, 11.0), DirectionalSpreading::cosinePower(radians(20.0)), 1.1);
  const auto origins = traceOrigins(tracer, rays, { { 100.0, -200.0 } });
  DirectionalSpectrum there;
  SpectralTransfer(rays, sea.grid, origins[0]).apply(sea.density, there);
  // What is asked for: energy to 1e-3. The means over bins spread a sea of 20 degrees by 5^2/6 degrees squared: 0.1.
  EXPECT_NEAR(seaParameters(there).significantHeight, 2.0, 1e-3 * 2.0);
  EXPECT_NEAR(seaParameters(there).meanDirectionFrom, seaParameters(sea).meanDirectionFrom, 1e-3);
  EXPECT_NEAR(seaParameters(there).spread, seaParameters(sea).spread, 0.15);
}

TEST(SpectralTransfer, straightBeachKeepsTheFluxOfEnergy)
{
  // m0 = integral of E0 Cg0 cos(a0)/(Cg cos(a)) over frequencies and directions offshore, by sums over 0.1 degrees.
  const auto spectrum = FrequencySpectrum::jonswap(1.5, 10.0);
  for (const double spread : { 5.0, 30.0 })
  {
    const auto spreading = DirectionalSpreading::cosinePower(radians(spread));
    const double mean = Pi - radians(25.0);
    SpectralRays rays;
    rays.grid = SpectralGrid::logarithmic(0.05, 0.35, 20, 36);
    rays.perDirection = 2;
    SpectralGrid fine = rays.grid;
    fine.headings = SpectralGrid::logarithmic(0.05, 0.35, 2, 180).headings;
    const auto sea = DirectionalSpectrum::sample(fine, spectrum, spreading, mean);
    const BackwardTracer tracer(*Wide, options(1e-6));
    double before = 0.0;
    for (const double depth : { 4.0, 12.0, 40.0 })
    {
      const auto origins = traceOrigins(tracer, rays, { { depth / 0.02, 0.0 } });
      const SpectralTransfer transfer(rays, fine, origins[0]);
      DirectionalSpectrum there;
      transfer.apply(sea.density, there);
      const std::vector<double> df = fine.frequencyWeights();
      double m0 = 0.0;
      for (std::size_t i = 0; i < df.size(); ++i)
      {
        const double omega = 2.0 * Pi * fine.frequencies[i];
        const double k0 = omega * omega / StandardGravity;
        const double k = solveWavenumber(omega, depth);
        const double ratio = 0.5 * omega / k0 / waveSpeeds(k, depth).groupSpeed;
        const int n = 1800;
        for (int j = 0; j < n; ++j)
        {
          const double a0 = -0.5 * Pi + Pi * (j + 0.5) / n;
          const double cosine = std::sqrt(1.0 - std::pow(k0 / k * std::sin(a0), 2.0));
          m0 += df[i] * sea.interpolate(fine.frequencies[i], Pi - a0) * ratio * std::cos(a0) / cosine * Pi / n;
        }
      }
      const double height = 4.0 * std::sqrt(m0);
      // Bins of 10 degrees in two parts each, means of a linear map in them: second order, below 1 %.
      EXPECT_NEAR(seaParameters(there).significantHeight / height, 1.0, 0.01) << spread << " " << depth;
      EXPECT_NE(seaParameters(there).significantHeight, before);
      before = seaParameters(there).significantHeight;
      // The weights of the sums are those of the spectrum.
      const std::vector<double> over = there.overFrequency();
      for (std::size_t i = 0; i < df.size(); ++i)
      {
        double sum = 0.0;
        for (std::size_t m = 0; m < fine.headings.size(); ++m)
        {
          sum += transfer.frequencyWeights()[(i * fine.headings.size() + m) * 3] * sea.at(i, m);
        }
        EXPECT_NEAR(sum, over[i], 1e-12);
      }
    }
  }
}

TEST(SpectralTransfer, comesToTheFluxOfEnergyAtSecondOrder)
{
  const double depth = 8.0;
  const auto spectrum = FrequencySpectrum::jonswap(1.5, 10.0);
  const auto spreading = DirectionalSpreading::cosinePower(radians(20.0));
  const BackwardTracer tracer(*Wide, options(1e-8));
  std::vector<double> heights;
  for (const std::size_t parts : { 1u, 2u, 4u, 8u })
  {
    SpectralRays rays;
    rays.grid = SpectralGrid::logarithmic(0.05, 0.35, 8, 36);
    rays.perDirection = parts;
    SpectralGrid fine = rays.grid;
    fine.headings = SpectralGrid::logarithmic(0.05, 0.35, 2, 720).headings;
    const auto sea = DirectionalSpectrum::sample(fine, spectrum, spreading, Pi - 0.4);
    const auto origins = traceOrigins(tracer, rays, { { depth / 0.02, 0.0 } });
    DirectionalSpectrum there;
    SpectralTransfer(rays, fine, origins[0]).apply(sea.density, there);
    heights.push_back(seaParameters(there).significantHeight);
  }
  const double first = std::abs(heights[1] - heights[0]);
  const double second = std::abs(heights[2] - heights[1]);
  const double third = std::abs(heights[3] - heights[2]);
  EXPECT_GT(first / third, 8.0); // 16 at second order
  EXPECT_LT(second, first);
  EXPECT_LT(third, 1e-3);
}

TEST(SpectralTransfer, countsTheStepsOfItsRaysOnAnyThread)
{
  const BackwardTracer tracer(*Wide, options(1e-6));
  SpectralRays rays;
  rays.grid = SpectralGrid::logarithmic(0.05, 0.35, 6, 12);
  const std::vector<glm::dvec2> places{ { 200.0, 0.0 }, { 400.0, 30.0 }, { -100.0, 0.0 } };
  Execution threads;
  threads.loop = [](std::size_t count, const std::function<void(std::size_t, std::size_t)>& body)
  {
    std::thread half([&] { body(0, count / 2); });
    body(count / 2, count);
    half.join();
  };
  const auto origins = traceOrigins(tracer, rays, places, threads);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    std::size_t steps = 0;
    for (const double frequency : rays.grid.frequencies)
    {
      for (const double heading : rays.grid.headings)
      {
        steps += tracer.trace(places[i], frequency, heading).steps;
      }
    }
    EXPECT_EQ(origins[i].steps, steps) << i;
  }
  EXPECT_GT(origins[0].steps, 6u * 12u);
  EXPECT_EQ(origins[2].steps, 0u); // on land
}

TEST(SpectralTransfer, islandsCastShadows)
{
  const auto island = makeBuiltinSeafloor("island");
  const Rectangle bounds = island->bounds();
  SpectralRays rays;
  rays.grid = SpectralGrid::logarithmic(0.07, 0.15, 4, 72);
  const auto sea = DirectionalSpectrum::sample(SpectralGrid::logarithmic(0.02, 1.0, 40, 72),
    FrequencySpectrum::jonswap(1.0, 10.0), DirectionalSpreading::wrappedNormal(radians(4.0)), 0.0);
  DirectionalSpectrum offshore;
  offshore.grid = rays.grid;
  for (const double f : rays.grid.frequencies)
  {
    for (const double h : rays.grid.headings)
    {
      offshore.density.push_back(sea.interpolate(f, h));
    }
  }
  const BackwardTracer tracer(*island, options(1e-6));
  const glm::dvec2 middle = 0.5 * (bounds.low + bounds.high);
  const double reach = 0.5 * bounds.size().x;
  const std::vector<glm::dvec2> places{ middle - glm::dvec2(0.9 * reach, 0.0), middle + glm::dvec2(0.5 * reach, 0.0),
    middle };
  const auto origins = traceOrigins(tracer, rays, places);
  std::vector<double> heights;
  for (const auto& place : origins)
  {
    DirectionalSpectrum there;
    SpectralTransfer(rays, offshore.grid, place).apply(offshore.density, there);
    heights.push_back(seaParameters(there).significantHeight);
  }
  const double open = seaParameters(offshore).significantHeight;
  EXPECT_NEAR(heights[0], open, 0.1 * open);
  EXPECT_LT(heights[1], 0.8 * open); // behind the island
  EXPECT_EQ(heights[2], 0.0);        // on it
  EXPECT_TRUE(origins[2].headings.empty());
}

TEST(SpectralTransfer, isTheSameForAnyLoop)
{
  const auto seafloor = makeBuiltinSeafloor("shoal");
  const BackwardTracer tracer(*seafloor, options(1e-5));
  SpectralRays rays;
  rays.grid = SpectralGrid::logarithmic(0.08, 0.2, 3, 12);
  const glm::dvec2 middle = 0.5 * (seafloor->bounds().low + seafloor->bounds().high);
  const std::vector<glm::dvec2> places{ middle, middle + 300.0, middle - 500.0 };
  const auto alone = traceOrigins(tracer, rays, places);
  Execution parallel;
  parallel.loop = [](std::size_t n, const std::function<void(std::size_t, std::size_t)>& body)
  {
    std::thread other([&] { body(n / 2, n); });
    body(0, n / 2);
    other.join();
  };
  const auto together = traceOrigins(tracer, rays, places, parallel);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    for (std::size_t j = 0; j < alone[i].headings.size(); ++j)
    {
      EXPECT_EQ(alone[i].gains[j], together[i].gains[j]);
      EXPECT_TRUE(alone[i].headings[j] == together[i].headings[j] || std::isnan(alone[i].headings[j]));
    }
  }
  Execution impatient;
  double last = 0.0;
  impatient.progress = [&](double share)
  {
    last = share;
    return share < 0.3;
  };
  traceOrigins(tracer, rays, places, impatient);
  EXPECT_LT(last, 0.35);
}

TEST(SpectralTransfer, refusesWhatDoesNotFit)
{
  SpectralRays rays;
  rays.grid = SpectralGrid::logarithmic(0.08, 0.2, 3, 12);
  SpectralOrigins none;
  EXPECT_THROW(SpectralTransfer(rays, SpectralGrid::logarithmic(0.08, 0.3, 3, 12), none), std::invalid_argument);
  rays.grid.headings[3] += 0.1;
  EXPECT_THROW(rays.validate(), std::invalid_argument);
  BackwardOptions bad;
  bad.tolerance = 0.0;
  EXPECT_THROW(BackwardTracer(*Wide, bad), std::invalid_argument);
}
