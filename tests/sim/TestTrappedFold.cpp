// The fold on which edge-trapped rays turn, against the Airy function of the wave across straight contours.
#include "sim/BuiltinSeafloor.h"
#include "sim/Caustic.h"
#include "sim/CausticRates.h"
#include "sim/HamiltonianRay.h"
#include "sim/RayFolds.h"

#include "RayComparison.h"
#include "TrappedRay.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace swellray;
using namespace swellray::reference;

namespace
{

// Those of the reference, and two others.
const TrappedRay Trapped[] = { { 0.02, 10.0, 100.0, 50.0 }, { 0.01, 60.0, 300.0, 30.0 }, { 0.05, 8.0, 60.0, 70.0 },
  { 0.015, 20.0, 150.0, 40.0 } };

/** A plane beach h = s x and the wave of a trapped ray, whose wavenumber along the shore is kept. */
struct Beach
{
  explicit Beach(const TrappedRay& c)
    : Slope(c.slope)
    , Omega(2.0L * reference::Pi / c.period)
    , Along(wavenumber(Omega, static_cast<Real>(c.slope) * c.x0) * std::sin(c.theta0 * reference::Pi / 180.0L))
    , Turning(std::atanh(Omega * Omega / (reference::Gravity * Along)) / Along / c.slope)
  {
  }

  /** Across the contours: k^2 - ky^2. */
  Real square(Real x) const
  {
    const Real k = wavenumber(this->Omega, this->Slope * x);
    return k * k - this->Along * this->Along;
  }

  /** Half the phase between the two branches at x: the integral of the wavenumber across from there to where it vanishes. */
  Real half(Real x) const
  {
    // With x = turning - u^2 nothing is singular.
    const Real end = std::sqrt(this->Turning - x);
    constexpr int parts = 200;
    Real sum = 0.0L;
    for (int i = 0; i < parts; ++i)
    {
      const Real u = end * (i + 0.5L) / parts;
      sum += 2.0L * u * std::sqrt(this->square(this->Turning - u * u)) * end / parts;
    }
    return sum;
  }

  Real Slope;
  Real Omega;
  Real Along;   // ky, rad/m
  Real Turning; // x of the caustic, m
};

}

TEST(TrappedFold, IsTheLineOnWhichTheRaysTurn)
{
  for (const TrappedRay& c : Trapped)
  {
    const Beach beach(c);
    const auto bed = makeBuiltinSeafloor("plane:s=" + std::to_string(c.slope) + ",x0=-100,x1=200000,y0=-1e6,y1=1e6");
    const RayMedium medium = mediumOf(*bed, c.period, 0.1);
    const double theta0 = c.theta0 * swellray::Pi / 180.0;
    const double k0 = static_cast<double>(wavenumber(beach.Omega, beach.Slope * static_cast<Real>(c.x0)));
    RayField field;
    std::vector<double> phases;
    std::vector<double> wavenumbers;
    std::vector<double> widths;
    std::vector<double> places;
    const double step = 0.05; // rad
    for (const double y : { -1.0, 0.0, 1.0 })
    {
      RayStart start;
      start.position = { c.x0, y };
      start.wavenumber = k0 * glm::dvec2(std::cos(theta0), std::sin(theta0));
      start.dPosition = { 0.0, 1.0 / std::cos(theta0) }; // contours are straight: the rays are one, moved along them
      start.phase = start.wavenumber.y * y;
      HamiltonianRay ray(medium, start, 1e-12);
      RayPoint point;
      for (double s = start.phase; ray.caustics().empty() || s < ray.caustics().front().phase + 3.0; s += step)
      {
        ASSERT_TRUE(ray.advance(FrontMeasure::Phase, s, point));
        if (y == 0.0)
        {
          phases.push_back(point.phase);
          wavenumbers.push_back(glm::length(point.wavenumber));
          widths.push_back(point.tubeWidth);
          places.push_back(point.position.x);
        }
        field.points.push_back(point);
      }
      for (RayCaustic caustic : ray.caustics())
      {
        caustic.ray = static_cast<std::int32_t>(field.rays.size());
        field.caustics.push_back(caustic);
      }
      field.rays.emplace_back();
      field.rays.back().launchParameter = y * std::cos(theta0);
      field.offsets.push_back(field.points.size());
    }
    findCausticRates(field);
    ASSERT_EQ(field.caustics.size(), 3u);
    const RayCaustic& caustic = field.caustics[1];
    const double turning = static_cast<double>(beach.Turning);
    EXPECT_NEAR(caustic.position.x, turning, 1e-7 * turning);
    EXPECT_NEAR(caustic.wavenumber.y / static_cast<double>(beach.Along), 1.0, 1e-9);

    // Near the line the wave across the contours is an Airy function, phi'' + mu (xt - x) phi = 0. The modulus of the two
    // branches there is, with beta = sqrt(mu (xt - x))/(ky cos theta0),
    //   sqrt(pi) (Ai(0)^2 + Bi(0)^2)^(1/2) (ky cos theta0)^(1/2) mu^(-1/6)
    const Real h = 1e-4L * beach.Turning;
    const Real mu = (beach.square(beach.Turning - h) - beach.square(beach.Turning + h)) / (2.0L * h); // to 1e-8
    const double airy = 2.0 * 0.35502805388781724;
    const double peak = std::sqrt(swellray::Pi) * airy *
      std::sqrt(static_cast<double>(beach.Along) * std::cos(theta0)) * std::pow(static_cast<double>(mu), -1.0 / 6.0);
    const RayFolds folds(&caustic, 1, phases.data(), wavenumbers.data(), phases.size());
    EXPECT_NEAR(folds.highestPeak() / peak, 1.0, 1e-6);

    // Away from it the modulus is that of half the phase between the branches (Langer 1937), whose logarithm changes by a sixth of
    // that of the phase at most; and the phase by RayFolds, exact for a linear k^2, is off by no more than k^2 bends.
    std::size_t compared = 0;
    for (std::size_t i = 0; i < phases.size(); i += 5)
    {
      const double away = (turning - places[i]) / turning;
      if (std::abs(phases[i] - caustic.phase) > 40.0 || !(away > 1e-6))
      {
        continue;
      }
      const double half = static_cast<double>(beach.half(places[i]));
      const double exact = foldModulus(half) / std::sqrt(std::abs(widths[i]));
      EXPECT_NEAR(folds.refraction(i, widths[i]) / exact, 1.0, away / 6.0 + 1e-4) << c.period << " s at " << places[i];
      ++compared;
    }
    EXPECT_GT(compared, 5u);
  }
}
