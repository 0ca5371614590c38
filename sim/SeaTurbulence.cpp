#include "sim/SeaTurbulence.h"

#include "sim/Angles.h"
#include "sim/Dispersion.h"
#include "sim/GaussRule.h"

#include <glm/gtc/noise.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <stdexcept>

namespace swellray
{

namespace
{

// Table of the noise's spectrum: rad a cell. Beyond its end it holds a thousandth.
constexpr double Longest = 16.0;
constexpr std::size_t TableSize = 321;

// Mean squares of the components of the gradients of glm::perlin, measured; only their ratios count here.
constexpr double GradientX = 0.49;
constexpr double GradientY = 0.69;
constexpr double GradientZ = 1.13;

// Where kmax lies in the spectrum of the first noise unless its slope cannot be had there: beyond its peak.
constexpr double UsualPlace = 5.0;

// Range of the multiplier; beyond 3 gaps open between the noises.
constexpr double LeastMultiplier = 1.5;
constexpr double MostMultiplier = 3.0;

// Waves shorter than this are ripples under surface tension, m.
constexpr double ShortestWave = 0.02;
constexpr std::size_t MostOctaves = 16;

// glm::perlin repeats by itself after so many cells.
constexpr double NoisePeriod = 289.0;

double fade(double t)
{
  return t * t * t * (t * (6.0 * t - 15.0) + 10.0);
}

// Integral over [0, 1] by Gauss's rule in panels.
template <typename Function>
double integral(const Function& function)
{
  constexpr int Panels = 16;
  double sum = 0.0;
  for (int i = 0; i < Panels; ++i)
  {
    sum += gaussPanel(i / static_cast<double>(Panels), (i + 1) / static_cast<double>(Panels), function);
  }
  return sum;
}

}

NoiseSpectrum::NoiseSpectrum()
{
  // Fourier transforms of the fade (even) and of x times it (odd), tabulated, and their mean squares.
  constexpr std::size_t Fine = 4 * TableSize;
  constexpr double Step = Longest / (Fine - 1);
  std::array<double, Fine> even{};
  std::array<double, Fine> odd{};
  for (std::size_t i = 0; i < Fine; ++i)
  {
    const double k = Step * static_cast<double>(i);
    even[i] = 2.0 * integral([=](double x) { return fade(1.0 - x) * std::cos(k * x); });
    odd[i] = 2.0 * integral([=](double x) { return x * fade(1.0 - x) * std::sin(k * x); });
  }
  const double evenSquare = 2.0 * integral([](double x) { return fade(1.0 - x) * fade(1.0 - x); });
  const double oddSquare = 2.0 * integral([](double x) { return x * x * fade(1.0 - x) * fade(1.0 - x); });
  const auto at = [=](const std::array<double, Fine>& table, double k)
  {
    const double place = k / Step;
    const std::size_t i = std::min(static_cast<std::size_t>(place), Fine - 2);
    const double u = place - static_cast<double>(i);
    return (1.0 - u) * table[i] + u * table[i + 1];
  };
  this->Density.assign(TableSize, 0.0);
  this->Below.assign(TableSize, 0.0);
  constexpr int Directions = 32; // of a quadrant
  for (std::size_t i = 0; i < TableSize; ++i)
  {
    const double k = Longest * static_cast<double>(i) / (TableSize - 1);
    for (int d = 0; d < Directions; ++d)
    {
      const double angle = 0.5 * Pi * (d + 0.5) / Directions;
      const double x = k * std::cos(angle);
      const double y = k * std::sin(angle);
      const double ex = at(even, x) * at(even, x);
      const double ey = at(even, y) * at(even, y);
      const double ox = at(odd, x) * at(odd, x);
      const double oy = at(odd, y) * at(odd, y);
      this->Density[i] +=
        k * ((GradientZ * ox * ey + GradientY * ex * oy) * evenSquare + GradientX * ex * ey * oddSquare);
    }
  }
  for (std::size_t i = 1; i < TableSize; ++i)
  {
    this->Below[i] = this->Below[i - 1] + 0.5 * (this->Density[i - 1] + this->Density[i]) * Longest / (TableSize - 1);
  }
  const double whole = this->Below.back();
  for (std::size_t i = 0; i < TableSize; ++i)
  {
    this->Density[i] /= whole;
    this->Below[i] /= whole;
  }
}

double NoiseSpectrum::density(double wavenumber) const
{
  const double place = wavenumber / Longest * (TableSize - 1);
  if (!(place < TableSize - 1))
  {
    return 0.0;
  }
  const auto i = static_cast<std::size_t>(place);
  const double u = place - static_cast<double>(i);
  return (1.0 - u) * this->Density[i] + u * this->Density[i + 1];
}

double NoiseSpectrum::shareBelow(double wavenumber) const
{
  const double place = wavenumber / Longest * (TableSize - 1);
  if (!(place < TableSize - 1))
  {
    return 1.0;
  }
  const auto i = static_cast<std::size_t>(place);
  const double u = place - static_cast<double>(i);
  return (1.0 - u) * this->Below[i] + u * this->Below[i + 1];
}

double footprintWeight(double wavelength, double footprint)
{
  const double u = std::clamp((wavelength - 2.0 * footprint) / std::max(2.0 * footprint, 1e-300), 0.0, 1.0);
  return footprint > 0.0 ? u * u * (3.0 - 2.0 * u) : 1.0;
}

// Spectrum of the sum for A = 1 and a first lattice of one cell a metre.
double SeaTurbulence::rawDensity(double scaled) const
{
  double sum = 0.0;
  double scale = 1.0;
  for (std::size_t i = 0; i < MostOctaves; ++i)
  {
    sum += this->Noise.density(scaled / scale) / (scale * scale * scale);
    scale *= this->Multiplier;
  }
  return NoiseSpectrum::Variance * sum;
}

SeaTurbulence::SeaTurbulence(const TurbulenceTarget& target)
{
  if (!(target.wavenumber > 0.0 && std::isfinite(target.wavenumber) && target.level >= 0.0 &&
        std::isfinite(target.level) && std::isfinite(target.slope)))
  {
    throw std::invalid_argument("turbulence needs a wavenumber above 0, a level of 0 or above and a finite slope");
  }
  // By relaxation: the multiplier, and where its range ends the place of kmax in the spectrum of the first noise.
  const auto slope = [&](double multiplier, double place)
  {
    this->Multiplier = multiplier;
    constexpr double Off = 0.02;
    return std::log(this->rawDensity(place * (1.0 + Off)) / this->rawDensity(place * (1.0 - Off))) /
      std::log((1.0 + Off) / (1.0 - Off));
  };
  double multiplier = LeastMultiplier;
  double place = UsualPlace;
  const bool flatter = slope(LeastMultiplier, place) < target.slope;
  const bool steeper = slope(MostMultiplier, place) > target.slope;
  constexpr int Halvings = 50;
  if (!flatter && !steeper)
  {
    double low = LeastMultiplier;
    double high = MostMultiplier;
    for (int i = 0; i < Halvings; ++i)
    {
      multiplier = 0.5 * (low + high);
      (slope(multiplier, place) > target.slope ? low : high) = multiplier;
    }
  }
  else
  {
    multiplier = flatter ? LeastMultiplier : MostMultiplier;
    constexpr double SteepestPlace = 6.0;
    double low = flatter ? 0.0 : UsualPlace;
    double high = flatter ? UsualPlace : SteepestPlace;
    for (int i = 0; i < Halvings; ++i)
    {
      place = 0.5 * (low + high);
      (slope(multiplier, place) > target.slope ? low : high) = place;
    }
  }
  this->Multiplier = multiplier;
  this->Cell = target.wavenumber / place;
  this->Amplitude = std::sqrt(target.level * this->Cell / this->rawDensity(place));
  this->Along = { std::cos(target.heading), std::sin(target.heading) };

  std::mt19937_64 random(target.seed);
  const auto share = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  double factor = 1.0;
  for (std::size_t i = 0; i < MostOctaves; ++i)
  {
    Octave octave;
    octave.scale = this->Cell * factor;
    octave.weight = this->Amplitude / factor;
    if (2.0 * Pi / (NoiseSpectrum::Peak * octave.scale) < ShortestWave && i > 0)
    {
      break;
    }
    if (target.tile)
    {
      octave.cells = std::max(1.0, std::round(octave.scale * *target.tile));
      octave.scale = octave.cells / *target.tile;
      const bool east = std::abs(this->Along.x) >= std::abs(this->Along.y);
      octave.main = east ? glm::dvec2(1.0, 0.0) : glm::dvec2(0.0, 1.0);
    }
    else
    {
      // Lattices that are parallel would show.
      constexpr double MostTurn = radians(25.0);
      const double turn = target.heading + MostTurn * (2.0 * share() - 1.0);
      octave.main = { std::cos(turn), std::sin(turn) };
    }
    octave.offset = NoisePeriod * glm::dvec3(share(), share(), share());
    const double k = NoiseSpectrum::Peak * octave.scale;
    octave.speed = std::sqrt(target.gravity / k * std::tanh(std::min(k * target.depth, 300.0)));
    this->Octaves.push_back(octave);
    factor *= this->Multiplier;
  }
}

double SeaTurbulence::density(double wavenumber) const
{
  double sum = 0.0;
  for (const Octave& octave : this->Octaves)
  {
    sum += octave.weight * octave.weight * this->Noise.density(wavenumber / octave.scale) / octave.scale;
  }
  return NoiseSpectrum::Variance * sum;
}

double SeaTurbulence::variance() const
{
  return this->varianceAbove(0.0);
}

double SeaTurbulence::varianceAbove(double wavenumber) const
{
  double sum = 0.0;
  for (const Octave& octave : this->Octaves)
  {
    sum += octave.weight * octave.weight * (1.0 - this->Noise.shareBelow(wavenumber / octave.scale));
  }
  return NoiseSpectrum::Variance * sum;
}

double SeaTurbulence::height(const glm::dvec2& place, double time, double footprint) const
{
  double sum = 0.0;
  for (const Octave& octave : this->Octaves)
  {
    // By its shortest waves, about two thirds of a cell.
    const double weight = footprintWeight(0.7 / octave.scale, footprint);
    if (weight == 0.0)
    {
      break;
    }
    const double way = octave.speed * time;
    const glm::dvec2 p = (place - way * this->Along) * octave.scale;
    glm::dvec3 at(
      way * octave.scale, octave.main.x * p.y - octave.main.y * p.x, octave.main.x * p.x + octave.main.y * p.y);
    // Far from the origin and late the noise repeats, as it does anyway; its arithmetic stays exact.
    const double period = octave.cells > 0.0 ? octave.cells : NoisePeriod;
    at.x = std::fmod(at.x + octave.offset.x, NoisePeriod);
    at.y = std::fmod(at.y + octave.offset.y, period);
    at.z = std::fmod(at.z + octave.offset.z, period);
    sum += weight * octave.weight *
      (octave.cells > 0.0 ? glm::perlin(at, glm::dvec3(NoisePeriod, period, period)) : glm::perlin(at));
  }
  return sum;
}

}
