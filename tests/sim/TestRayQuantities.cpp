#include "sim/RayQuantities.h"

#include "sim/Angles.h"
#include "sim/Dispersion.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

using namespace swellray;

namespace
{

// A few roundings of doubles in each formula.
constexpr double Rounding = 1e-14;

RayField fieldOfOnePoint(double depth, double heading, double tubeWidth, double spacingWidth, const IncidentWave& wave)
{
  RayField field;
  const double k = solveWavenumber(wave.angularFrequency(), depth, wave.gravity);
  RayPoint point;
  point.position = { 100.0, -20.0 };
  point.wavenumber = k * glm::dvec2(std::cos(heading), std::sin(heading));
  point.rayDirection = { 0.6, 0.8 };
  point.depth = depth;
  point.phase = 12.5;
  point.travelTime = 33.0;
  point.tubeWidth = tubeWidth;
  point.spacingWidth = spacingWidth;
  point.caustics = 3;
  point.state = RayState::Flat;
  field.rays.resize(1);
  field.points.push_back(point);
  field.offsets.push_back(1);
  return field;
}

}

TEST(RayQuantities, areThoseOfLinearWaves)
{
  IncidentWave wave;
  wave.period = 8.0;
  const double depth = 5.0;
  const double heading = radians(30.0);
  const RayField field = fieldOfOnePoint(depth, heading, -0.25, 4.0, wave);

  std::array<double, 3> position{};
  std::array<double, 3> direction{};
  std::array<double, 3> rayDirection{};
  double h = 0, phase = 0, time = 0, k = 0, length = 0, c = 0, cg = 0, from = 0, krSpacing = 0, krTube = 0, beta = 0,
         ks = 0;
  std::int32_t caustics = 0;
  std::uint8_t state = 0;
  RayQuantities q;
  q.position = position.data();
  q.direction = direction.data();
  q.rayDirection = rayDirection.data();
  q.depth = &h;
  q.phase = &phase;
  q.travelTime = &time;
  q.wavenumber = &k;
  q.wavelength = &length;
  q.phaseSpeed = &c;
  q.groupSpeed = &cg;
  q.directionFrom = &from;
  q.krSpacing = &krSpacing;
  q.krTube = &krTube;
  q.tubeWidth = &beta;
  q.shoaling = &ks;
  q.caustics = &caustics;
  q.state = &state;
  computeRayQuantities(field, wave, 1.5, q);

  EXPECT_EQ(position, (std::array<double, 3>{ 100.0, -20.0, 1.5 }));
  EXPECT_NEAR(direction[0], std::cos(heading), Rounding);
  EXPECT_NEAR(direction[1], std::sin(heading), Rounding);
  EXPECT_EQ(direction[2], 0.0);
  EXPECT_EQ(rayDirection, (std::array<double, 3>{ 0.6, 0.8, 0.0 }));
  EXPECT_EQ(h, depth);
  EXPECT_EQ(phase, 12.5);
  EXPECT_EQ(time, 33.0);
  // The speeds are checked against their own definitions: L = C T, and C of the dispersion relation.
  const double omega = 2.0 * Pi / wave.period;
  EXPECT_NEAR(omega * omega, wave.gravity * k * std::tanh(k * h), Rounding);
  EXPECT_NEAR(length, c * wave.period, Rounding * length);
  const double n = 0.5 * (1.0 + 2.0 * k * h / std::sinh(2.0 * k * h));
  EXPECT_NEAR(cg, n * omega / k, Rounding * cg);
  // Half the phase speed in deep water: the offshore group speed.
  EXPECT_NEAR(ks, std::sqrt(0.5 * wave.gravity / omega / cg), Rounding);
  EXPECT_NEAR(from, 240.0, 360.0 * Rounding);
  EXPECT_EQ(krSpacing, 0.5);
  EXPECT_EQ(krTube, 2.0);
  EXPECT_EQ(beta, -0.25);
  EXPECT_EQ(caustics, 3);
  EXPECT_EQ(state, 2);
}

TEST(RayQuantities, coefficientAtACausticAndWithoutATube)
{
  EXPECT_EQ(refractionCoefficient(0.0), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(refractionCoefficient(std::numeric_limits<double>::quiet_NaN())));
}

TEST(RayQuantities, fillsOnlyWhatIsWantedOverAnyLoop)
{
  const IncidentWave wave;
  RayField field = fieldOfOnePoint(10.0, 0.0, 1.0, 1.0, wave);
  field.points.resize(7, field.points.front());
  for (std::size_t i = 0; i < field.points.size(); ++i)
  {
    field.points[i].phase = static_cast<double>(i);
  }
  field.offsets.back() = field.points.size();
  std::vector<double> phase(field.points.size(), -1.0);
  RayQuantities q;
  q.phase = phase.data();
  Execution execution;
  execution.loop = [](std::size_t n, const std::function<void(std::size_t, std::size_t)>& body)
  {
    body(n / 2, n);
    body(0, n / 2);
  };
  computeRayQuantities(field, wave, 0.0, q, execution);
  EXPECT_EQ(phase, (std::vector<double>{ 0, 1, 2, 3, 4, 5, 6 }));
}

TEST(RayQuantities, refusesABadWave)
{
  IncidentWave wave;
  wave.period = 0.0;
  EXPECT_THROW(computeRayQuantities(RayField(), wave, 0.0, RayQuantities()), std::invalid_argument);
}
