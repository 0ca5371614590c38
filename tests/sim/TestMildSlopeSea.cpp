// A short-crested sea behind a shoal by two ways that share nothing but the dispersion relation: energies of mild-slope
// fields, one a direction offshore, and rays followed back from each place (Longuet-Higgins 1957).
#include "sim/Angles.h"
#include "sim/BackwardTracer.h"
#include "sim/BuiltinSeafloor.h"
#include "sim/MildSlope.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace swellray;

namespace
{

constexpr double Period = 6.0;
constexpr double Depth = 8.0;
constexpr double Spread = 12.0; // s of cos^2s of half the angle

/** Share of the energy a radian, up to a factor, of waves this far off the main direction. */
double spreading(double angle)
{
  return std::pow(std::cos(0.5 * angle), 2.0 * Spread);
}

}

TEST(MildSlopeSea, HasTheHeightsOfRaysFollowedBack)
{
  // The shoal is wide and focuses behind the scene: no caustics, so that both theories hold. What rays leave out is of the
  // order of (k sg)^-2 = 0.3 %; of what the mesh has wrong (0.5 % of the surface) the mean over directions keeps a part.
  constexpr double Tolerance = 0.005;
  const auto seafloor = makeBuiltinSeafloor("shoal:kind=gauss,h0=8,a=2.5,sg=130,x0=-330,x1=420,y0=-330,y1=330");
  std::vector<glm::dvec2> places;
  for (double x = -200.0; x <= 400.0; x += 60.0)
  {
    for (double y = -240.0; y <= 240.0; y += 60.0)
    {
      places.emplace_back(x, y);
    }
  }

  std::vector<double> energy(places.size(), 0.0);
  double total = 0.0;
  for (double degrees = -60.0; degrees <= 60.0; degrees += 7.5)
  {
    IncidentWave wave;
    wave.period = Period;
    wave.directionFrom = 270.0 + degrees;
    wave.height = 1.0;
    wave.offshoreDepth = Depth;
    MildSlopeOptions options;
    options.height.breaking = BreakingRule::None;
    const MildSlopeWaves waves = solveMildSlope(*seafloor, 0.0, wave, options).sample(places);
    const double weight = spreading(radians(degrees));
    total += weight;
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      energy[i] += weight * waves.height[i] * waves.height[i];
    }
  }

  BackwardOptions options;
  options.offshoreDepth = Depth;
  const BackwardTracer tracer(*seafloor, options);
  constexpr double Step = 0.5; // degrees
  double whole = 0.0;
  for (double degrees = -179.75; degrees < 180.0; degrees += Step)
  {
    whole += std::abs(degrees) <= 63.75 ? spreading(radians(degrees)) : 0.0;
  }
  double highest = 0.0;
  double lowest = 2.0;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    double sum = 0.0;
    for (double degrees = -90.0; degrees <= 90.0; degrees += Step)
    {
      const WaveOrigin origin = tracer.trace(places[i], 1.0 / Period, radians(degrees));
      const bool within = std::abs(origin.heading) <= radians(63.75); // what the fields have
      sum += within ? origin.gain * spreading(origin.heading) : 0.0;
    }
    const double byRays = std::sqrt(sum / whole);
    const double byWaves = std::sqrt(energy[i] / total);
    EXPECT_NEAR(byWaves / byRays, 1.0, Tolerance) << places[i].x << ", " << places[i].y;
    highest = std::max(highest, byRays);
    lowest = std::min(lowest, byRays);
  }
  EXPECT_GT(highest, 1.1); // there is something to agree on
  EXPECT_LT(lowest, 0.97);
}
