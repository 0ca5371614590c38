#include "sim/ElevationSeries.h"

#include "sim/Angles.h"

#include <unsupported/Eigen/FFT>

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>
#include <stdexcept>
#include <string>

namespace swellray
{

namespace
{

// The next number that is 4 times factors of 2, 3 and 5 only.
std::size_t smoothCount(std::size_t least)
{
  for (std::size_t count = (least + 3) / 4 * 4;; count += 4)
  {
    std::size_t rest = count;
    for (const std::size_t factor : { std::size_t(2), std::size_t(3), std::size_t(5) })
    {
      while (rest % factor == 0)
      {
        rest /= factor;
      }
    }
    if (rest == 1)
    {
      return count;
    }
  }
}

// Integral of a function that is linear between nodes from the first node on.
class LinearIntegral
{
public:
  LinearIntegral(const std::vector<double>& nodes, const std::vector<double>& values)
    : X(nodes)
    , Y(values)
    , Sums(nodes.size(), 0.0)
  {
    for (std::size_t i = 1; i < nodes.size(); ++i)
    {
      this->Sums[i] = this->Sums[i - 1] + 0.5 * (values[i] + values[i - 1]) * (nodes[i] - nodes[i - 1]);
    }
  }

  double upTo(double x) const
  {
    if (x <= this->X.front())
    {
      return 0.0;
    }
    if (x >= this->X.back())
    {
      return this->Sums.back();
    }
    const auto i = static_cast<std::size_t>(std::upper_bound(this->X.begin(), this->X.end(), x) - this->X.begin()) - 1;
    const double u = (x - this->X[i]) / (this->X[i + 1] - this->X[i]);
    const double here = this->Y[i] + u * (this->Y[i + 1] - this->Y[i]);
    return this->Sums[i] + 0.5 * (this->Y[i] + here) * (x - this->X[i]);
  }

private:
  const std::vector<double>& X;
  const std::vector<double>& Y;
  std::vector<double> Sums;
};

}

void ElevationTimes::cover(double duration)
{
  constexpr double MostSamples = 1e6;
  const double samples = std::ceil(duration / interval);
  if (!(samples >= 2.0 && samples <= MostSamples))
  {
    throw std::invalid_argument("a record needs 2 to a million samples: its length over the interval");
  }
  count = smoothCount(static_cast<std::size_t>(samples));
}

void ElevationTimes::validate() const
{
  if (!(interval > 0.0 && std::isfinite(interval)) || count < 2)
  {
    throw std::invalid_argument("a record needs an interval above 0 s and 2 or more samples");
  }
}

std::vector<double> elevationSeries(const DirectionalSpectrum& spectrum, const ElevationTimes& times)
{
  times.validate();
  spectrum.grid.validate();
  const std::vector<double> density = spectrum.overFrequency();
  const LinearIntegral energy(spectrum.grid.frequencies, density);
  const double whole = energy.upTo(spectrum.grid.frequencies.back());
  std::vector<double> record(times.count, 0.0);
  if (!(whole > 0.0))
  {
    return record;
  }
  const double length = times.interval * static_cast<double>(times.count);
  const double highest = 0.5 / times.interval;
  constexpr double LeastShare = 0.9;
  if (!(energy.upTo(highest) >= LeastShare * whole))
  {
    throw std::invalid_argument("samples " + std::to_string(times.interval) +
      " s apart hold less than 90 % of the energy of the sea; take a shorter interval");
  }
  constexpr double LeastPeriods = 4.0;
  const double period = seaParameters(spectrum).peakPeriod;
  if (length < LeastPeriods * period)
  {
    throw std::invalid_argument("a record of " + std::to_string(length) + " s is too short for waves of " +
      std::to_string(period) + " s; it must hold four of them");
  }
  std::seed_seq seeds{ times.seed, static_cast<unsigned>(times.index) };
  std::mt19937_64 random(seeds);
  const std::size_t lines = times.count / 2;
  std::vector<std::complex<double>> half(lines + 1, 0.0);
  for (std::size_t n = 1; n <= lines; ++n)
  {
    // Each line has the energy around it; the last one, of which only the cosine can be told, none.
    const double phase = 2.0 * Pi * static_cast<double>(random() >> 11) * 0x1p-53;
    if (2 * n < times.count)
    {
      const double f = static_cast<double>(n) / length;
      const double share = energy.upTo(f + 0.5 / length) - energy.upTo(n == 1 ? 0.0 : f - 0.5 / length);
      half[n] = std::polar(0.5 * std::sqrt(2.0 * share) * static_cast<double>(times.count), -phase);
    }
  }
  Eigen::FFT<double> transform;
  transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  transform.inv(record, half, static_cast<Eigen::Index>(times.count));
  return record;
}

}
