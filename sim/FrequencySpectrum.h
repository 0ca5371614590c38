#pragma once

#include "sim/IncidentWave.h"

#include <array>

namespace swellray
{

/** Shapes of the spectrum of a sea. */
enum class SpectrumShape
{
  PiersonMoskowitz, ///< fully developed sea
  Jonswap,          ///< growing sea: a sharper peak
  Tma,              ///< JONSWAP in finite depth
  OchiHubble,       ///< sum of two seas
};

/** One of the two seas of Ochi and Hubble. */
struct OchiHubbleSea
{
  double height = 1.0;  ///< Hs of this sea alone, m, >= 0
  double period = 10.0; ///< its peak period, s, > 0
  double shape = 1.0;   ///< lambda, > 0.25: 1 is Pierson-Moskowitz, larger is narrower
};

/** Peak enhancement of the mean JONSWAP spectrum. */
constexpr double StandardPeakedness = 3.3;

/**
 * Spectrum S(f) of the surface elevation at a point, m2/Hz, f in Hz. With x = f/fp
 *
 *   Pierson-Moskowitz  S = A f^-5 exp(-5/4 x^-4)
 *   JONSWAP            S = A f^-5 exp(-5/4 x^-4) gamma^r,  r = exp(-(x - 1)^2/(2 s^2)),  s = 0.07 for x <= 1, else 0.09
 *   TMA                the same times phi = tanh^2(kh)/(2 n), n = Cg/C
 *   Ochi-Hubble        S = sum of Hj^2/(4 Gamma(l)) (a fj^4)^l f^(-4l-1) exp(-a (fj/f)^4),  a = l + 1/4
 *
 * Pierson and Moskowitz 1964, J. Geophys. Res. 69; Hasselmann et al. 1973, Dtsch. Hydrogr. Z. A8 (12); Bouws, Guenther,
 * Rosenthal and Vincent 1985, J. Geophys. Res. 90, with phi of Kitaigorodskii, Krasitskii and Zaslavskii 1975 as
 * written by Bouws et al.; Ochi and Hubble 1976, Proc. 15th ICCE, eq. 5 (in omega there).
 *
 * A is such that the significant height Hs = 4 sqrt(m0) is the one asked for, unless the wind sets it.
 */
class FrequencySpectrum
{
public:
  /**
   * @param height Hs, m, > 0
   * @param peakPeriod Tp: the spectrum is largest at 1/Tp, s, > 0
   * @throws std::invalid_argument naming the value that is out of range; so do all of these
   */
  static FrequencySpectrum piersonMoskowitz(double height, double peakPeriod);

  /** @param peakedness gamma, 1 to 20 */
  static FrequencySpectrum jonswap(double height, double peakPeriod, double peakedness = StandardPeakedness);

  /** @param depth m, > 0 */
  static FrequencySpectrum tma(double height, double peakPeriod, double depth, double peakedness = StandardPeakedness,
    double gravity = StandardGravity);

  static FrequencySpectrum ochiHubble(const std::array<OchiHubbleSea, 2>& seas);

  /**
   * Fully developed sea of a wind: A = 0.0081 g^2 (2 pi)^-4, fp = 0.13 g/U10.
   * @param wind U10, m/s at a height of 10 m, > 0
   */
  static FrequencySpectrum piersonMoskowitzOfWind(double wind, double gravity = StandardGravity);

  /**
   * Growing sea: A = alpha g^2 (2 pi)^-4 with alpha = 0.076 X^-0.22, fp = 3.5 (g/U10) X^-0.33, X = g F/U10^2
   * (Hasselmann et al. 1973).
   * @param wind U10, m/s, > 0
   * @param fetch F, m, > 0
   */
  static FrequencySpectrum jonswapOfWind(
    double wind, double fetch, double peakedness = StandardPeakedness, double gravity = StandardGravity);

  SpectrumShape shape() const { return this->Shape; }

  /** S(f), m2/Hz; 0 for f <= 0. */
  double density(double frequency) const;

  /** m_n = integral of f^n S over all f, m2 Hz^n, to 1e-9 relative. @param order n, -2 to 3 (m_4 does not exist) */
  double moment(int order) const;

  /** Share of m0 that lies below a frequency, 0 to 1. */
  double shareBelow(double frequency) const;

  double significantHeight() const; ///< Hs = 4 sqrt(m0), m
  double peakFrequency() const { return this->Peak; }
  double peakPeriod() const { return 1.0 / this->Peak; } ///< Tp, s
  double meanPeriod01() const;                           ///< Tm01 = m0/m1, s
  double meanPeriod02() const;                           ///< Tm02 = sqrt(m0/m2), s: between zero crossings
  double energyPeriod() const;                           ///< Tm-10 = m-1/m0, s

private:
  explicit FrequencySpectrum(SpectrumShape shape)
    : Shape(shape)
  {
  }

  double unscaled(double frequency) const;
  double integrate(int order, double to) const;
  void scaleTo(double height);
  void findPeak(double from, double to);

  SpectrumShape Shape;
  double Scale = 1.0;
  double Peak = 0.1;     // of the whole, Hz
  double FormPeak = 0.1; // fp of the formula; that of TMA lies lower than its peak
  double Peakedness = 1.0;
  double Depth = 0.0;
  double Gravity = StandardGravity;
  std::array<OchiHubbleSea, 2> Seas;
};

}
