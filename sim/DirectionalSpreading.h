#pragma once

namespace swellray
{

/** Shapes of the distribution of the energy of a sea over its directions. */
enum class SpreadingShape
{
  CosinePower,   ///< D = N cos^2s(a/2), the same at every frequency
  WrappedNormal, ///< a normal distribution wound around the circle
  Hasselmann,    ///< D = N cos^2p(a/2), p falling away from the peak
};

/** Whose exponent below the peak holds for SpreadingShape::Hasselmann. */
enum class HasselmannExponent
{
  Hasselmann1980, ///< p = 6.97 (f/fp)^4.06 below the peak, 9.77 (f/fp)^-2.34 above
  Thon2000,       ///< 9.77 on both sides
};

/**
 * Distribution D(a), 1/rad, over the angle a from the mean direction, rad; its integral over the circle is 1.
 *
 *   cos^2s:  D = 2^(2s-1) Gamma(s+1)^2/(pi Gamma(2s+1)) cos^2s(a/2)     (Longuet-Higgins, Cartwright and Smith 1963)
 *
 * Spreads are the circular standard deviation sqrt(2 (1 - r)), r the length of the mean vector (Kuik, van Vledder and
 * Holthuijsen 1988, J. Phys. Oceanogr. 18): r = s/(s+1) of cos^2s and exp(-v/2) of a wrapped normal with variance v.
 */
class DirectionalSpreading
{
public:
  /** @param spread rad, above 0.017 (1 degree) and at most 1.4 (80 degrees); throws std::invalid_argument outside */
  static DirectionalSpreading cosinePower(double spread);
  static DirectionalSpreading wrappedNormal(double spread);

  /**
   * Hasselmann, Dunckel and Ewing 1980, J. Phys. Oceanogr. 10; Thon, Dischler and Ghazanfarpour 2000, eq. 8.
   * @param peakFrequency Hz, > 0
   */
  static DirectionalSpreading hasselmann(
    double peakFrequency, HasselmannExponent exponent = HasselmannExponent::Hasselmann1980);

  SpreadingShape shape() const { return this->Shape; }

  /** D at an angle from the mean direction, rad (any), 1/rad. @param frequency Hz, > 0; only Hasselmann's depends on it */
  double density(double frequency, double angle) const;

  /** Integral of D from one angle to a larger one, at most a circle further, to 1e-6. */
  double share(double frequency, double from, double to) const;

  /** Circular standard deviation at a frequency, rad. */
  double spread(double frequency) const;

private:
  DirectionalSpreading() = default;
  double exponent(double frequency) const;

  SpreadingShape Shape = SpreadingShape::CosinePower;
  double Exponent = 1.0;  // s
  double Deviation = 0.5; // of the wrapped normal, rad
  double Peak = 0.1;
  double BelowPeak = 6.97;
};

}
