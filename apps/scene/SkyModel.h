#pragma once

#include <array>

namespace swellray::scene
{

/** A value for luminance and the chromaticities x and y of CIE 1931. */
using Yxy = std::array<double, 3>;

/** Red, green, blue of linear sRGB; more than 1 where it is bright. */
using Light = std::array<double, 3>;

/**
 * Clear daylight sky (A. J. Preetham, P. Shirley and B. Smits, A practical analytic model for daylight, SIGGRAPH 1999):
 *   value(theta, gamma) = zenith F(theta, gamma)/F(0, theta_s),
 *   F = (1 + A exp(B/cos theta)) (1 + C exp(D gamma) + E cos^2 gamma)
 * theta: angle from the zenith, gamma: from the sun, for luminance and both chromaticities, whose A to E go linearly
 * with turbidity.
 */
class SkyModel
{
public:
  /**
   * @param azimuth of the sun, nautical degrees
   * @param elevation of the sun, degrees over the horizon, 2 to 90
   * @param turbidity 2 (clear) to 10 (hazy)
   * @throws std::invalid_argument out of range
   */
  SkyModel(double azimuth, double elevation, double turbidity = 2.2);

  /** Unit vector to the sun: east, north, up. */
  const std::array<double, 3>& sun() const { return this->Sun; }

  /** Light from a direction, a unit vector; below the horizon that of the horizon. Luminance in kcd/m2. */
  Light light(const std::array<double, 3>& direction) const;

  /** A to E; each for luminance, x and y. */
  const std::array<Yxy, 5>& coefficients() const { return this->Coefficients; }

  /** Zenith over F(0, theta_s). */
  const Yxy& scale() const { return this->Scale; }

  /** Luminance that a picture shows as a middle tone, kcd/m2: of the sky a quarter turn from the sun. */
  double middleLuminance() const;

private:
  Yxy distribution(double cosZenith, double sunAngle) const;

  std::array<double, 3> Sun;
  std::array<Yxy, 5> Coefficients;
  Yxy Scale;
};

}
