#include "sim/RayFolds.h"

#include "sim/Caustic.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swellray
{

namespace
{

// Half phases between which the width of the tube gives way to that from the spacing of rays, rad.
constexpr double AllTube = 0.5;
constexpr double NoTube = 3.0;

// Below this half phase a point is on the caustic: the rest of the way is worth 1e-6 of the height.
constexpr double Touching = 1e-9;

// Where the peak would be higher than this many rays meet in a focus, not two in a fold or three in a cusp.
constexpr double FocusPeak = 10.0;

double square(double x)
{
  return x * x;
}

}

RayFolds::RayFolds(const RayCaustic* caustics, std::size_t count, const double* phase, const double* wavenumber,
  std::size_t points, const double* beside)
{
  // Integral of dS/k^2 over a stretch, by trapezia.
  const auto stretch = [](double fromPhase, double fromK, double toPhase, double toK)
  { return 0.5 * (toPhase - fromPhase) * (1.0 / square(fromK) + 1.0 / square(toK)); };
  for (const RayCaustic* caustic = caustics; points > 0 && caustic != caustics + count; ++caustic)
  {
    const double curvature = roundedCurvature(*caustic);
    Fold fold;
    fold.peak = foldPeak(*caustic, curvature);
    if (!(fold.peak > 0.0 && fold.peak < FocusPeak))
    {
      continue;
    }
    fold.half.resize(points);
    const double trueK = caustic->scale * std::hypot(caustic->wavenumber.x, caustic->wavenumber.y);
    const double scale = caustic->fanWavenumber * square(curvature) / 3.0;
    const auto after = static_cast<std::size_t>(std::lower_bound(phase, phase + points, caustic->phase) - phase);
    const auto put = [&](std::size_t i, double sum)
    {
      const double sigma = square(trueK) / caustic->phaseRate * std::abs(sum);
      fold.half[i] = scale * sigma * square(sigma);
    };
    double sum = 0.0;
    for (std::size_t i = after; i < points; ++i)
    {
      sum += i == after ? stretch(caustic->phase, trueK, phase[i], wavenumber[i])
                        : stretch(phase[i - 1], wavenumber[i - 1], phase[i], wavenumber[i]);
      put(i, sum);
    }
    sum = 0.0;
    for (std::size_t i = after; i-- > 0;)
    {
      sum += i + 1 == after ? stretch(phase[i], wavenumber[i], caustic->phase, trueK)
                            : stretch(phase[i], wavenumber[i], phase[i + 1], wavenumber[i + 1]);
      put(i, sum);
    }
    this->HighestPeak = std::max(this->HighestPeak, fold.peak);
    this->Folds.push_back(std::move(fold));
  }
  if (beside && std::any_of(beside, beside + points, [](double half) { return std::isfinite(half); }))
  {
    this->Beside.assign(beside, beside + points);
  }
}

double RayFolds::half(std::size_t point) const
{
  double least = std::numeric_limits<double>::infinity();
  for (const Fold& fold : this->Folds)
  {
    least = std::min(least, fold.half[point]);
  }
  return least;
}

double RayFolds::tubeShare(std::size_t point) const
{
  const double x = std::clamp((NoTube - this->half(point)) / (NoTube - AllTube), 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

double RayFolds::refraction(std::size_t point, double width) const
{
  double coefficient = 1.0 / std::sqrt(std::abs(width));
  const Fold* touched = nullptr;
  for (const Fold& fold : this->Folds)
  {
    if (fold.half[point] < Touching)
    {
      touched = &fold;
    }
  }
  coefficient = touched ? touched->peak : coefficient;
  for (const Fold& fold : this->Folds)
  {
    coefficient *= &fold == touched ? 1.0 : foldModulus(fold.half[point]);
  }
  if (this->Beside.empty())
  {
    return coefficient;
  }
  return std::max(coefficient * foldModulus(std::max(this->Beside[point], Touching)), std::min(coefficient, 1.0));
}

}
