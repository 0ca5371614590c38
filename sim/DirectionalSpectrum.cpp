#include "sim/DirectionalSpectrum.h"

#include "sim/Angles.h"
#include "sim/GaussRule.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace swellray
{

namespace
{

void requireIncreasing(const std::vector<double>& values, const char* name)
{
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (!std::isfinite(values[i]) || (i > 0 && !(values[i] > values[i - 1])))
    {
      throw std::invalid_argument(std::string("the ") + name + " of a spectrum must increase; number " +
        std::to_string(i + 1) + " is " + std::to_string(values[i]));
    }
  }
}

// Period of the largest value of a spectrum over frequency, the first of three sums each, by a parabola through it and
// its neighbours.
double peakPeriod(const std::vector<double>& f, const double* sums)
{
  std::size_t i = 0;
  for (std::size_t other = 1; other < f.size(); ++other)
  {
    i = sums[3 * other] > sums[3 * i] ? other : i;
  }
  if (i == 0 || i + 1 == f.size())
  {
    return 1.0 / f[i];
  }
  const double a = f[i - 1] - f[i];
  const double b = f[i + 1] - f[i];
  const double u = sums[3 * (i - 1)] - sums[3 * i];
  const double v = sums[3 * (i + 1)] - sums[3 * i];
  // s = c1 x + c2 x^2 through (a, u), (b, v).
  const double c2 = (u / a - v / b) / (a - b);
  const double c1 = u / a - c2 * a;
  return c2 < 0.0 ? 1.0 / (f[i] - 0.5 * c1 / c2) : 1.0 / f[i];
}

}

bool SpectralGrid::isCircle() const
{
  if (headings.size() < 3)
  {
    return false;
  }
  const double last = 2.0 * Pi - (headings.back() - headings.front());
  const double mean = (headings.back() - headings.front()) / static_cast<double>(headings.size() - 1);
  return last < 2.0 * mean;
}

std::vector<double> SpectralGrid::frequencyWeights() const
{
  const std::size_t n = frequencies.size();
  std::vector<double> weights(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    weights[i] = 0.5 * (frequencies[std::min(i + 1, n - 1)] - frequencies[i > 0 ? i - 1 : 0]);
  }
  return weights;
}

std::vector<double> SpectralGrid::headingWeights() const
{
  const std::size_t n = headings.size();
  std::vector<double> weights(n);
  const bool circle = this->isCircle();
  for (std::size_t j = 0; j < n; ++j)
  {
    const double before = j > 0 ? headings[j - 1] : (circle ? headings.back() - 2.0 * Pi : headings[0]);
    const double after = j + 1 < n ? headings[j + 1] : (circle ? headings.front() + 2.0 * Pi : headings[j]);
    weights[j] = 0.5 * (after - before);
  }
  return weights;
}

void SpectralGrid::validate() const
{
  if (frequencies.size() < 2 || headings.size() < 2)
  {
    throw std::invalid_argument("a directional spectrum needs at least two frequencies and two directions");
  }
  requireIncreasing(frequencies, "frequencies");
  requireIncreasing(headings, "directions");
  if (!(frequencies.front() > 0.0))
  {
    throw std::invalid_argument(
      "the frequencies of a spectrum must be above 0; the first is " + std::to_string(frequencies.front()));
  }
  if (headings.back() - headings.front() >= 2.0 * Pi)
  {
    throw std::invalid_argument("the directions of a spectrum must lie within less than a circle");
  }
}

SpectralGrid SpectralGrid::logarithmic(
  double lowest, double highest, std::size_t frequencyCount, std::size_t headingCount)
{
  if (!(lowest > 0.0 && highest > lowest && frequencyCount >= 2 && headingCount >= 3))
  {
    throw std::invalid_argument("a spectral grid needs frequencies from above 0 to higher, at least 2 of them, and at "
                                "least 3 directions");
  }
  SpectralGrid grid;
  const double ratio = std::log(highest / lowest) / static_cast<double>(frequencyCount - 1);
  for (std::size_t i = 0; i < frequencyCount; ++i)
  {
    grid.frequencies.push_back(lowest * std::exp(ratio * static_cast<double>(i)));
  }
  for (std::size_t j = 0; j < headingCount; ++j)
  {
    grid.headings.push_back(2.0 * Pi * static_cast<double>(j) / static_cast<double>(headingCount));
  }
  return grid;
}

double DirectionalSpectrum::interpolate(double frequency, double heading) const
{
  const auto& f = grid.frequencies;
  const auto& h = grid.headings;
  if (!(frequency >= f.front() && frequency <= f.back()))
  {
    return 0.0;
  }
  const std::size_t i =
    std::clamp<std::size_t>(
      static_cast<std::size_t>(std::upper_bound(f.begin(), f.end(), frequency) - f.begin()), 1, f.size() - 1) -
    1;
  const double u = (frequency - f[i]) / (f[i + 1] - f[i]);
  const double turned = h.front() + std::fmod(std::fmod(heading - h.front(), 2.0 * Pi) + 2.0 * Pi, 2.0 * Pi);
  std::size_t a = static_cast<std::size_t>(std::upper_bound(h.begin(), h.end(), turned) - h.begin()) - 1;
  std::size_t b = a + 1;
  double next = 0.0;
  if (b == h.size())
  {
    if (!grid.isCircle())
    {
      return a + 1 == h.size() && turned == h.back() ? (1.0 - u) * this->at(i, a) + u * this->at(i + 1, a) : 0.0;
    }
    b = 0;
    next = h.front() + 2.0 * Pi;
  }
  else
  {
    next = h[b];
  }
  const double v = (turned - h[a]) / (next - h[a]);
  return (1.0 - u) * ((1.0 - v) * this->at(i, a) + v * this->at(i, b)) +
    u * ((1.0 - v) * this->at(i + 1, a) + v * this->at(i + 1, b));
}

std::vector<double> DirectionalSpectrum::overFrequency() const
{
  const std::vector<double> weights = grid.headingWeights();
  std::vector<double> result(grid.frequencies.size(), 0.0);
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    for (std::size_t j = 0; j < weights.size(); ++j)
    {
      result[i] += weights[j] * this->at(i, j);
    }
  }
  return result;
}

DirectionalSpectrum DirectionalSpectrum::sample(const SpectralGrid& grid, const FrequencySpectrum& spectrum,
  const DirectionalSpreading& spreading, double meanHeading)
{
  grid.validate();
  constexpr double LeastShare = 0.9;
  const auto& f = grid.frequencies;
  const double within = spectrum.shareBelow(f.back()) - spectrum.shareBelow(f.front());
  if (!(within >= LeastShare))
  {
    throw std::invalid_argument("the frequencies " + std::to_string(f.front()) + " to " + std::to_string(f.back()) +
      " Hz hold only " + std::to_string(100.0 * std::max(within, 0.0)) +
      " % of the energy of the sea; widen them so that they hold 90 %");
  }
  DirectionalSpectrum result;
  result.grid = grid;
  result.density.assign(grid.size(), 0.0);
  const std::vector<double> df = grid.frequencyWeights();
  const std::vector<double> dh = grid.headingWeights();

  // Hat-weighted means: panels no wider than a fiftieth of the peak frequency see the peak as it is.
  std::vector<double> means(f.size(), 0.0);
  for (std::size_t i = 0; i + 1 < f.size(); ++i)
  {
    const double width = f[i + 1] - f[i];
    const int panels = std::max(1, static_cast<int>(std::ceil(50.0 * width / spectrum.peakFrequency())));
    for (int p = 0; p < panels; ++p)
    {
      const double a = f[i] + width * p / panels;
      const double b = f[i] + width * (p + 1) / panels;
      const double whole = gaussPanel(a, b, [&](double x) { return spectrum.density(x); });
      const double upper = gaussPanel(a, b, [&](double x) { return spectrum.density(x) * (x - f[i]) / width; });
      means[i] += whole - upper;
      means[i + 1] += upper;
    }
  }
  double sum = 0.0;
  std::vector<double> shares(dh.size());
  for (std::size_t i = 0; i < f.size(); ++i)
  {
    const bool asBefore = i > 0 && spreading.shape() != SpreadingShape::Hasselmann;
    double circle = 0.0;
    for (std::size_t j = 0; j < dh.size(); ++j)
    {
      const double middle = grid.headings[j] - meanHeading;
      shares[j] = asBefore ? shares[j] : spreading.share(f[i], middle - 0.5 * dh[j], middle + 0.5 * dh[j]);
      result.density[i * dh.size() + j] = means[i] / df[i] * shares[j] / dh[j];
      circle += shares[j];
    }
    sum += means[i] * circle;
  }
  const double wanted = spectrum.moment(0);
  for (double& value : result.density)
  {
    value *= wanted / sum;
  }
  return result;
}

SpectrumResampler::AxisWeights SpectrumResampler::frequencyAxis(const SpectralGrid& from, const SpectralGrid& to)
{
  const auto& nodes = from.frequencies;
  const std::vector<double> widths = to.frequencyWeights();
  AxisWeights axis;
  axis.weights.assign(widths.size() * nodes.size(), 0.0);
  axis.whole.assign(nodes.size(), 0.0);
  axis.inside.assign(nodes.size(), 0.0);
  // Pieces finer than both grids; densities are linear in them, so that their middles hold their energy exactly.
  const double fine = 0.25 * *std::min_element(widths.begin(), widths.end());
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
  {
    const double width = nodes[i + 1] - nodes[i];
    const int parts = std::clamp(static_cast<int>(std::ceil(width / fine)), 1, 1000);
    for (int p = 0; p < parts; ++p)
    {
      const double upper = (p + 0.5) / parts; // share of the upper node of the old grid
      const double f = nodes[i] + width * upper;
      const double held = std::clamp(f, to.frequencies.front(), to.frequencies.back());
      const auto above = std::upper_bound(to.frequencies.begin() + 1, to.frequencies.end() - 1, held);
      const auto a = static_cast<std::size_t>(above - to.frequencies.begin()) - 1;
      const double u = (held - to.frequencies[a]) / (to.frequencies[a + 1] - to.frequencies[a]);
      for (const auto& [node, share] : { std::make_pair(i, 1.0 - upper), std::make_pair(i + 1, upper) })
      {
        const double energy = share * width / parts;
        axis.whole[node] += energy;
        axis.inside[node] += held == f ? energy : 0.0;
        axis.weights[a * nodes.size() + node] += energy * (1.0 - u) / widths[a];
        axis.weights[(a + 1) * nodes.size() + node] += energy * u / widths[a + 1];
      }
    }
  }
  return axis;
}

SpectrumResampler::AxisWeights SpectrumResampler::headingAxis(const SpectralGrid& from, const SpectralGrid& to)
{
  const auto& nodes = from.headings;
  const auto& heads = to.headings;
  const std::vector<double> widths = to.headingWeights();
  const bool circle = to.isCircle();
  const std::size_t pieces = nodes.size() - (from.isCircle() ? 0 : 1);
  AxisWeights axis;
  axis.weights.assign(heads.size() * nodes.size(), 0.0);
  axis.whole.assign(nodes.size(), 0.0);
  const double fine = 0.25 * *std::min_element(widths.begin(), widths.end());
  const double first = heads.front();
  for (std::size_t j = 0; j < pieces; ++j)
  {
    const double next = j + 1 < nodes.size() ? nodes[j + 1] : nodes[0] + 2.0 * Pi;
    const double turn = next - nodes[j];
    const int steps = std::clamp(static_cast<int>(std::ceil(turn / fine)), 1, 1000);
    for (int q = 0; q < steps; ++q)
    {
      const double upper = (q + 0.5) / steps;
      const double h = nodes[j] + turn * upper;
      const double turned = h - 2.0 * Pi * std::floor((h - first) / (2.0 * Pi));
      const auto above = std::upper_bound(heads.begin(), heads.end(), turned);
      const std::size_t c = above == heads.begin() ? 0 : static_cast<std::size_t>(above - heads.begin()) - 1;
      const bool lastOne = c + 1 == heads.size();
      const std::size_t d = lastOne ? 0 : c + 1;
      const double end = lastOne ? first + 2.0 * Pi : heads[d];
      const double v = std::clamp((turned - heads[c]) / (end - heads[c]), 0.0, 1.0);
      for (const auto& [node, share] :
        { std::make_pair(j, 1.0 - upper), std::make_pair((j + 1) % nodes.size(), upper) })
      {
        const double energy = share * turn / steps;
        axis.whole[node] += energy;
        if (!lastOne || circle)
        {
          axis.weights[c * nodes.size() + node] += energy * (1.0 - v) / widths[c];
          axis.weights[d * nodes.size() + node] += energy * v / widths[d];
        }
      }
    }
  }
  return axis;
}

SpectrumResampler::SpectrumResampler(const SpectralGrid& from, const SpectralGrid& to)
  : To(to)
{
  from.validate();
  to.validate();
  this->Frequencies = frequencyAxis(from, to);
  this->Headings = headingAxis(from, to);
}

std::vector<double> SpectrumResampler::apply(const std::vector<double>& density) const
{
  const std::size_t fromF = this->Frequencies.whole.size();
  const std::size_t fromH = this->Headings.whole.size();
  const std::size_t toF = this->To.frequencies.size();
  const std::size_t toH = this->To.headings.size();
  if (density.size() != fromF * fromH)
  {
    throw std::invalid_argument("a spectrum to resample does not have the size of its grid");
  }
  std::vector<double> turned(fromF * toH, 0.0);
  double whole = 0.0;
  double inside = 0.0;
  for (std::size_t i = 0; i < fromF; ++i)
  {
    double line = 0.0;
    for (std::size_t j = 0; j < fromH; ++j)
    {
      line += this->Headings.whole[j] * density[i * fromH + j];
    }
    whole += line * this->Frequencies.whole[i];
    inside += line * this->Frequencies.inside[i];
    for (std::size_t k = 0; k < toH && line > 0.0; ++k)
    {
      const double* weights = this->Headings.weights.data() + k * fromH;
      for (std::size_t j = 0; j < fromH; ++j)
      {
        turned[i * toH + k] += weights[j] * density[i * fromH + j];
      }
    }
  }
  constexpr double LeastShare = 0.9;
  if (whole > 0.0 && !(inside >= LeastShare * whole))
  {
    throw std::invalid_argument("the frequencies " + std::to_string(this->To.frequencies.front()) + " to " +
      std::to_string(this->To.frequencies.back()) + " Hz hold only " + std::to_string(100.0 * inside / whole) +
      " % of the energy of the sea; widen them so that they hold 90 %");
  }
  std::vector<double> result(toF * toH, 0.0);
  for (std::size_t a = 0; a < toF; ++a)
  {
    for (std::size_t i = 0; i < fromF; ++i)
    {
      const double weight = this->Frequencies.weights[a * fromF + i];
      for (std::size_t k = 0; k < toH && weight > 0.0; ++k)
      {
        result[a * toH + k] += weight * turned[i * toH + k];
      }
    }
  }
  return result;
}

DirectionalSpectrum resample(const DirectionalSpectrum& spectrum, const SpectralGrid& grid)
{
  return { grid, SpectrumResampler(spectrum.grid, grid).apply(spectrum.density) };
}

std::array<double, 2> energyBand(const DirectionalSpectrum& spectrum, double share)
{
  const auto& f = spectrum.grid.frequencies;
  const std::vector<double> s = spectrum.overFrequency();
  std::vector<double> below(f.size(), 0.0);
  for (std::size_t i = 1; i < f.size(); ++i)
  {
    below[i] = below[i - 1] + 0.5 * (s[i] + s[i - 1]) * (f[i] - f[i - 1]);
  }
  if (!(below.back() > 0.0))
  {
    return { f.front(), f.back() };
  }
  const double cut = 0.5 * (1.0 - share) * below.back();
  std::array<double, 2> band{ f.front(), f.back() };
  for (std::size_t i = 1; i < f.size(); ++i)
  {
    band[0] = below[i] <= cut ? f[i] : band[0];
    band[1] = below[i - 1] < below.back() - cut ? f[i] : band[1];
  }
  return band;
}

SeaParameters seaParameters(
  const std::vector<double>& frequencies, const std::vector<double>& weights, const double* sums)
{
  double before = 0.0; // m-1
  double m0 = 0.0;
  double m1 = 0.0;
  double m2 = 0.0;
  double east = 0.0;
  double north = 0.0;
  for (std::size_t i = 0; i < frequencies.size(); ++i)
  {
    const double f = frequencies[i];
    const double energy = sums[3 * i] * weights[i];
    before += energy / f;
    m0 += energy;
    m1 += energy * f;
    m2 += energy * f * f;
    east += sums[3 * i + 1] * weights[i];
    north += sums[3 * i + 2] * weights[i];
  }
  SeaParameters parameters;
  parameters.significantHeight = 4.0 * std::sqrt(std::max(m0, 0.0));
  if (m0 > 0.0)
  {
    parameters.peakPeriod = peakPeriod(frequencies, sums);
    parameters.meanPeriod01 = m0 / m1;
    parameters.meanPeriod02 = std::sqrt(m0 / m2);
    parameters.energyPeriod = before / m0;
    const double r = std::hypot(east, north) / m0;
    parameters.meanDirectionFrom = nauticalFromVector({ east, north });
    parameters.spread = degrees(std::sqrt(std::max(0.0, 2.0 * (1.0 - r))));
  }
  else
  {
    const double none = std::numeric_limits<double>::quiet_NaN();
    parameters.peakPeriod = parameters.meanPeriod01 = parameters.meanPeriod02 = parameters.energyPeriod = none;
    parameters.meanDirectionFrom = parameters.spread = none;
  }
  return parameters;
}

SeaParameters seaParameters(const DirectionalSpectrum& spectrum)
{
  const std::vector<double> dh = spectrum.grid.headingWeights();
  std::vector<double> sums(3 * spectrum.grid.frequencies.size(), 0.0);
  for (std::size_t j = 0; j < dh.size(); ++j)
  {
    const double east = std::cos(spectrum.grid.headings[j]);
    const double north = std::sin(spectrum.grid.headings[j]);
    for (std::size_t i = 0; i < spectrum.grid.frequencies.size(); ++i)
    {
      const double energy = dh[j] * spectrum.at(i, j);
      sums[3 * i] += energy;
      sums[3 * i + 1] += energy * east;
      sums[3 * i + 2] += energy * north;
    }
  }
  return seaParameters(spectrum.grid.frequencies, spectrum.grid.frequencyWeights(), sums.data());
}

}
