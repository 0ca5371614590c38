// Records of random phases: their energy, their spectrum, and that they can be made again.
#include "sim/Angles.h"
#include "sim/ElevationSeries.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <stdexcept>

using namespace swellray;

namespace
{

// The lines of a record are exact but for rounding.
constexpr double Rounding = 1e-10;

DirectionalSpectrum sea()
{
  return DirectionalSpectrum::sample(SpectralGrid::logarithmic(0.05, 0.45, 20, 36),
    FrequencySpectrum::jonswap(2.0, 9.0), DirectionalSpreading::cosinePower(radians(25.0)), 0.0);
}

// Energy of a record between two frequencies, by its Fourier sums.
double energyBetween(const std::vector<double>& record, double interval, double low, double high)
{
  const double length = interval * static_cast<double>(record.size());
  double sum = 0.0;
  for (std::size_t n = 1; n < record.size() / 2; ++n)
  {
    const double f = static_cast<double>(n) / length;
    if (f < low || f >= high)
    {
      continue;
    }
    const std::complex<double> turn = std::polar(1.0, -2.0 * Pi * f * interval);
    std::complex<double> phase = 1.0;
    std::complex<double> line = 0.0;
    for (const double value : record)
    {
      line += value * phase;
      phase *= turn;
    }
    sum += 2.0 * std::norm(line / static_cast<double>(record.size()));
  }
  return sum;
}

}

TEST(ElevationSeries, hasTheHeightAndTheSpectrumOfTheSea)
{
  const DirectionalSpectrum spectrum = sea();
  ElevationTimes times;
  times.interval = 0.5;
  times.count = 2400;
  const std::vector<double> record = elevationSeries(spectrum, times);
  ASSERT_EQ(record.size(), 2400u);
  double mean = 0.0;
  double square = 0.0;
  for (const double value : record)
  {
    mean += value / 2400.0;
    square += value * value / 2400.0;
  }
  EXPECT_NEAR(mean, 0.0, Rounding);
  EXPECT_NEAR(4.0 * std::sqrt(square), seaParameters(spectrum).significantHeight, Rounding);

  // Between nodes of the spectrum, half a line from which a band may end.
  const std::vector<double> s = spectrum.overFrequency();
  const auto& f = spectrum.grid.frequencies;
  double worst = 0.0;
  for (std::size_t i = 4; i + 4 < f.size(); i += 2)
  {
    const double wanted =
      0.5 * (s[i] + s[i + 1]) * (f[i + 1] - f[i]) + 0.5 * (s[i + 1] + s[i + 2]) * (f[i + 2] - f[i + 1]);
    const double line = 1.0 / 1200.0 * std::max(s[i], s[i + 2]);
    EXPECT_NEAR(energyBetween(record, 0.5, f[i], f[i + 2]), wanted, line) << f[i];
    worst = std::max(worst, line / wanted);
  }
  EXPECT_LT(worst, 0.1); // so that the tolerance says something
}

TEST(ElevationSeries, isMadeAgainByItsSeed)
{
  const DirectionalSpectrum spectrum = sea();
  ElevationTimes times;
  times.count = 1200;
  const std::vector<double> first = elevationSeries(spectrum, times);
  EXPECT_EQ(elevationSeries(spectrum, times), first);
  times.index = 1;
  const std::vector<double> other = elevationSeries(spectrum, times);
  double product = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    product += first[i] * other[i];
    square += first[i] * first[i];
  }
  // Some 60 waves of random phases: less than a third of the whole is left.
  EXPECT_LT(std::abs(product), 0.35 * square);
  times.index = 0;
  times.seed = 2;
  EXPECT_NE(elevationSeries(spectrum, times), first);
}

TEST(ElevationSeries, refusesWhatCannotHoldTheSea)
{
  const DirectionalSpectrum spectrum = sea();
  ElevationTimes times;
  times.interval = 4.0; // up to 0.125 Hz
  EXPECT_THROW(elevationSeries(spectrum, times), std::invalid_argument);
  times.interval = 0.5;
  times.count = 40; // 20 s
  EXPECT_THROW(elevationSeries(spectrum, times), std::invalid_argument);
  times.interval = 0.0;
  EXPECT_THROW(elevationSeries(spectrum, times), std::invalid_argument);
  DirectionalSpectrum calm = spectrum;
  calm.density.assign(calm.density.size(), 0.0);
  times = {};
  for (const double value : elevationSeries(calm, times))
  {
    EXPECT_EQ(value, 0.0);
  }
}
