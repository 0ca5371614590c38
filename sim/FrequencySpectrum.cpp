#include "sim/FrequencySpectrum.h"

#include "sim/Dispersion.h"
#include "sim/GaussRule.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace swellray
{

namespace
{

void require(bool good, const char* what, double value)
{
  if (!good)
  {
    throw std::invalid_argument(std::string(what) + ", not " + std::to_string(value));
  }
}

void requirePositive(const char* name, double value)
{
  require(value > 0.0 && std::isfinite(value), (std::string(name) + " must be above 0").c_str(), value);
}

void requirePeakedness(double value)
{
  require(value >= 1.0 && value <= 20.0, "the peakedness must be within 1 to 20", value);
}

double fifthPower(double x)
{
  const double x2 = x * x;
  return x2 * x2 * x;
}

}

double FrequencySpectrum::unscaled(double frequency) const
{
  if (!(frequency > 0.0))
  {
    return 0.0;
  }
  if (this->Shape == SpectrumShape::OchiHubble)
  {
    double sum = 0.0;
    for (const OchiHubbleSea& sea : this->Seas)
    {
      // By logarithms: the powers leave the range of a double where the spectrum does not.
      const double a = sea.shape + 0.25;
      const double u = a / std::pow(sea.period * frequency, 4.0);
      sum +=
        sea.height * sea.height / (4.0 * frequency) * std::exp(sea.shape * std::log(u) - u - std::lgamma(sea.shape));
    }
    return sum;
  }
  const double x = frequency / this->FormPeak;
  const double distance = (x - 1.0) / (x <= 1.0 ? 0.07 : 0.09);
  double density =
    std::exp(-1.25 / (x * x * x * x) + std::log(this->Peakedness) * std::exp(-0.5 * distance * distance)) /
    fifthPower(frequency);
  if (this->Shape == SpectrumShape::Tma && density > 0.0)
  {
    const double k = solveWavenumber(2.0 * Pi * frequency, this->Depth, this->Gravity);
    const double t = std::tanh(k * this->Depth);
    density *= t * t / (2.0 * waveSpeeds(k, this->Depth, this->Gravity).groupRatio);
  }
  return density;
}

double FrequencySpectrum::density(double frequency) const
{
  return this->Scale * this->unscaled(frequency);
}

double FrequencySpectrum::integrate(int order, double to) const
{
  // Panels grow with the frequency and meet at the kinks: the peak of the form, where sigma jumps, and `to`.
  double highest = this->FormPeak;
  double lowest = this->FormPeak;
  if (this->Shape == SpectrumShape::OchiHubble)
  {
    lowest = 1.0 / std::max(this->Seas[0].period, this->Seas[1].period);
    highest = 1.0 / std::min(this->Seas[0].period, this->Seas[1].period);
  }
  const auto integrand = [&](double f) { return std::pow(f, order) * this->unscaled(f); };
  constexpr double Growth = 1.04;
  double sum = 0.0;
  const auto march = [&](double from, double end)
  {
    for (double a = from; a < end;)
    {
      const double b = a * Growth * Growth > end ? end : a * Growth;
      sum += gaussPanel(a, b, integrand);
      a = b;
    }
  };
  const double start = 0.3 * lowest; // exp(-5/4 0.3^-4) = 1e-67
  const double kink = std::min(this->FormPeak, to);
  march(start, kink);
  constexpr double TailBegins = 50.0;
  const double tail = std::min(TailBegins * highest, to);
  march(std::max(start, kink), tail);
  if (to > tail)
  {
    // From here on a power law, but for 2e-7 of it in the exponential.
    double power = 5.0;
    if (this->Shape == SpectrumShape::OchiHubble)
    {
      power = 4.0 * std::min(this->Seas[0].shape, this->Seas[1].shape) + 1.0;
    }
    const double n = power - order - 1.0;
    const double rest = integrand(tail) * tail / n;
    sum += std::isinf(to) ? rest : rest * (1.0 - std::pow(tail / to, n));
  }
  return sum;
}

double FrequencySpectrum::moment(int order) const
{
  require(order >= -2 && order <= 3, "the order of a moment must be within -2 to 3", order);
  return this->Scale * this->integrate(order, std::numeric_limits<double>::infinity());
}

double FrequencySpectrum::shareBelow(double frequency) const
{
  const double whole = this->integrate(0, std::numeric_limits<double>::infinity());
  return std::clamp(this->integrate(0, frequency) / whole, 0.0, 1.0);
}

void FrequencySpectrum::scaleTo(double height)
{
  this->Scale = 1.0;
  this->Scale = height * height / (16.0 * this->moment(0));
}

void FrequencySpectrum::findPeak(double from, double to)
{
  constexpr int Samples = 400;
  double best = from;
  for (int i = 0; i <= Samples; ++i)
  {
    const double f = from * std::pow(to / from, static_cast<double>(i) / Samples);
    best = this->unscaled(f) > this->unscaled(best) ? f : best;
  }
  // Golden section between the neighbours of the best sample; a maximum is flat, so 1e-8 is what it gives.
  const double ratio = std::pow(to / from, 1.0 / Samples);
  double a = best / ratio;
  double b = best * ratio;
  constexpr double Golden = 0.6180339887498949;
  while (b - a > 1e-9 * best)
  {
    const double c = b - Golden * (b - a);
    const double d = a + Golden * (b - a);
    (this->unscaled(c) < this->unscaled(d) ? a : b) = this->unscaled(c) < this->unscaled(d) ? c : d;
  }
  this->Peak = 0.5 * (a + b);
}

FrequencySpectrum FrequencySpectrum::piersonMoskowitz(double height, double peakPeriod)
{
  FrequencySpectrum spectrum = jonswap(height, peakPeriod, 1.0);
  spectrum.Shape = SpectrumShape::PiersonMoskowitz;
  return spectrum;
}

FrequencySpectrum FrequencySpectrum::jonswap(double height, double peakPeriod, double peakedness)
{
  requirePositive("the significant height", height);
  requirePositive("the peak period", peakPeriod);
  requirePeakedness(peakedness);
  FrequencySpectrum spectrum(SpectrumShape::Jonswap);
  spectrum.Peak = spectrum.FormPeak = 1.0 / peakPeriod;
  spectrum.Peakedness = peakedness;
  spectrum.scaleTo(height);
  return spectrum;
}

FrequencySpectrum FrequencySpectrum::tma(
  double height, double peakPeriod, double depth, double peakedness, double gravity)
{
  requirePositive("the significant height", height);
  requirePositive("the peak period", peakPeriod);
  requirePositive("the depth", depth);
  requirePositive("gravity", gravity);
  requirePeakedness(peakedness);
  FrequencySpectrum spectrum(SpectrumShape::Tma);
  spectrum.Peakedness = peakedness;
  spectrum.Depth = depth;
  spectrum.Gravity = gravity;
  // phi grows with the frequency and moves the peak upwards: the form's peak is brought down until it is where asked.
  const double wanted = 1.0 / peakPeriod;
  spectrum.FormPeak = wanted;
  for (int i = 0; i < 60; ++i)
  {
    spectrum.findPeak(0.8 * spectrum.FormPeak, 2.0 * spectrum.FormPeak);
    const double correction = wanted / spectrum.Peak;
    spectrum.FormPeak *= correction;
    if (std::abs(correction - 1.0) < 1e-8)
    {
      break;
    }
  }
  spectrum.Peak = wanted;
  spectrum.scaleTo(height);
  return spectrum;
}

FrequencySpectrum FrequencySpectrum::ochiHubble(const std::array<OchiHubbleSea, 2>& seas)
{
  FrequencySpectrum spectrum(SpectrumShape::OchiHubble);
  for (const OchiHubbleSea& sea : seas)
  {
    require(sea.height >= 0.0 && std::isfinite(sea.height), "the height of a sea must not be below 0", sea.height);
    requirePositive("the peak period", sea.period);
    require(sea.shape > 0.75 && sea.shape <= 20.0,
      "the shape of a sea must be above 0.75 and at most 20, or its moments do not exist", sea.shape);
  }
  require(seas[0].height + seas[1].height > 0.0, "the significant height must be above 0", 0.0);
  spectrum.Seas = seas;
  const double f0 = 1.0 / seas[0].period;
  const double f1 = 1.0 / seas[1].period;
  spectrum.FormPeak = std::min(f0, f1);
  spectrum.findPeak(0.8 * std::min(f0, f1), 1.2 * std::max(f0, f1));
  return spectrum;
}

FrequencySpectrum FrequencySpectrum::piersonMoskowitzOfWind(double wind, double gravity)
{
  requirePositive("the wind speed", wind);
  requirePositive("gravity", gravity);
  FrequencySpectrum spectrum(SpectrumShape::PiersonMoskowitz);
  spectrum.Gravity = gravity;
  spectrum.Peak = spectrum.FormPeak = 0.13 * gravity / wind;
  spectrum.Scale = 0.0081 * gravity * gravity / std::pow(2.0 * Pi, 4.0);
  return spectrum;
}

FrequencySpectrum FrequencySpectrum::jonswapOfWind(double wind, double fetch, double peakedness, double gravity)
{
  requirePositive("the wind speed", wind);
  requirePositive("the fetch", fetch);
  requirePositive("gravity", gravity);
  requirePeakedness(peakedness);
  FrequencySpectrum spectrum(SpectrumShape::Jonswap);
  const double x = gravity * fetch / (wind * wind);
  spectrum.Gravity = gravity;
  spectrum.Peakedness = peakedness;
  spectrum.Peak = spectrum.FormPeak = 3.5 * gravity / wind * std::pow(x, -0.33);
  spectrum.Scale = 0.076 * std::pow(x, -0.22) * gravity * gravity / std::pow(2.0 * Pi, 4.0);
  return spectrum;
}

double FrequencySpectrum::significantHeight() const
{
  return 4.0 * std::sqrt(this->moment(0));
}

double FrequencySpectrum::meanPeriod01() const
{
  return this->moment(0) / this->moment(1);
}

double FrequencySpectrum::meanPeriod02() const
{
  return std::sqrt(this->moment(0) / this->moment(2));
}

double FrequencySpectrum::energyPeriod() const
{
  return this->moment(-1) / this->moment(0);
}

}
