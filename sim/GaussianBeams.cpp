#include "sim/GaussianBeams.h"

#include "sim/Angles.h"
#include "sim/BeamBuilder.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace swellray
{

namespace
{

// Distance from a focus, in its length, from which on beams give way to the sheets; and ways ahead of it between which
// they come in.
constexpr double AllBeams = 5.0;
constexpr double FirstBeams = -1.2;
constexpr double AllAhead = -0.6;

// What is left of the nearest beam where beams are no more the wave of the rays; and what is left of those at an end,
// or the error, between which they give way.
constexpr double NoRay = 0.01;
constexpr double NearRay = 0.1;
constexpr double LeastDoubt = 0.02;
constexpr double MostDoubt = 0.2;

glm::dvec2 leftOf(const glm::dvec2& v)
{
  return { -v.y, v.x };
}

// Smooth step from 0 at `low` to 1 at `high`.
double step(double low, double high, double x)
{
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// Cubic of Hermite.
template <typename T>
T cubic(const T& a, const T& b, const T& slopeA, const T& slopeB, double u)
{
  const double v = 1.0 - u;
  return v * v * ((1.0 + 2.0 * u) * a + u * slopeA) + u * u * ((3.0 - 2.0 * u) * b - v * slopeB);
}

// The part of a row, in x, in which a linear function of x is not negative.
void cut(double atZero, double slope, double& low, double& high)
{
  if (slope > 0.0)
  {
    low = std::max(low, -atZero / slope);
  }
  else if (slope < 0.0)
  {
    high = std::min(high, -atZero / slope);
  }
  else if (atZero < 0.0)
  {
    high = low - 1.0;
  }
}

}

struct GaussianBeams::Sum
{
  std::complex<double> wave = 0.0;
  glm::dvec2 wavenumber{ 0.0 };
  double nearest = 0.0; // what is left of the nearest beam
  double end = 0.0;     // and of those at the end of a family
  double size = 0.0;    // sum of moduli
  double error = 0.0;   // of the sum
};

GaussianBeams::GaussianBeams(const RaySheets& sheets, const Execution& execution)
  : Sheets(sheets)
{
  BeamBuilder(*this).build(execution);
}

double GaussianBeams::reach(const glm::dvec2& place) const
{
  double rest = 1.0;
  for (const BeamFocus& focus : this->Foci)
  {
    const glm::dvec2 way = (place - focus.position) / focus.length;
    rest *=
      1.0 - step(FirstBeams, AllAhead, glm::dot(way, focus.along)) * (1.0 - step(AllBeams, Farthest, glm::length(way)));
  }
  return 1.0 - rest;
}

void GaussianBeams::addRow(const glm::dvec2& first, double spacing, std::size_t count, BeamShare* shares) const
{
  const double last = first.x + spacing * static_cast<double>(count - 1);
  std::vector<Sum> sums(count);
  for (const Segment& segment : this->Segments)
  {
    if (first.y < segment.box.low.y || first.y > segment.box.high.y || last < segment.box.low.x ||
      first.x > segment.box.high.x)
    {
      continue;
    }
    std::size_t begin = 0;
    std::size_t end = count;
    if (count > 1)
    {
      const Point& a = this->Points[segment.first];
      const Point& b = this->Points[segment.first + 1];
      double low = segment.box.low.x;
      double high = segment.box.high.x;
      cut((first.y - a.position.y) * a.along.y - a.position.x * a.along.x, a.along.x, low, high);
      cut((b.position.y - first.y) * b.along.y + b.position.x * b.along.x, -b.along.x, low, high);
      if (high < low)
      {
        continue;
      }
      // One more on either side: add() decides.
      const auto columns = static_cast<double>(count);
      begin = static_cast<std::size_t>(std::clamp((low - first.x) / spacing - 1.0, 0.0, columns));
      end = static_cast<std::size_t>(std::clamp((high - first.x) / spacing + 2.0, 0.0, columns));
    }
    for (std::size_t i = begin; i < end; ++i)
    {
      if (shares[i].weight > 0.0)
      {
        this->add(segment, { first.x + spacing * static_cast<double>(i), first.y }, sums[i]);
      }
    }
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    BeamShare& share = shares[i];
    share.wave = sums[i].wave;
    share.wavenumber = sums[i].wavenumber;
    const double error = sums[i].size > 0.0 ? sums[i].error / sums[i].size : 0.0;
    share.weight *=
      step(NoRay, NearRay, sums[i].nearest) * (1.0 - step(LeastDoubt, MostDoubt, std::max(sums[i].end, error)));
  }
}

void GaussianBeams::add(const Segment& segment, const glm::dvec2& place, Sum& sum) const
{
  const Point& a = this->Points[segment.first];
  const Point& b = this->Points[segment.first + 1];
  // Between the normals of both ends.
  const double past = glm::dot(place - a.position, a.along);
  const double ahead = glm::dot(b.position - place, b.along);
  if (!(past >= 0.0) || !(ahead > 0.0))
  {
    return;
  }
  const double u = past / (past + ahead);
  const glm::dvec2 along = glm::normalize(glm::mix(a.along, b.along, u));
  const double scale = glm::mix(a.scale, b.scale, u);
  const glm::dvec2 foot = cubic(a.position, b.position, segment.length * a.along, segment.length * b.along, u);
  const double off = glm::dot(leftOf(along), place - foot) / scale;
  const std::complex<double> spread = a.spread + u * (b.spread - a.spread);
  const double exponent = 0.5 * spread.imag() * off * off;
  if (exponent > BeamBuilder::LargestExponent)
  {
    return;
  }
  const Obstacles* walls = this->Sheets.rays().obstacles;
  if (walls && walls->crosses(foot, place))
  {
    sum.end = 1.0;
    return;
  }
  const double left = std::exp(-exponent);
  const std::complex<double> amplitude = a.amplitude + u * (b.amplitude - a.amplitude);
  const double length = segment.length / scale;
  const double phase = cubic(a.phase, b.phase, length * a.wavenumber, length * b.wavenumber, u) +
    glm::mix(a.wavenumber, b.wavenumber, u) * glm::dot(along, place - foot) / scale + 0.5 * spread.real() * off * off;
  const double size = std::abs(amplitude) * left;
  sum.wave += amplitude * std::polar(left, phase);
  sum.wavenumber += size * glm::mix(a.wavenumber, b.wavenumber, u) * along;
  sum.nearest = std::max(sum.nearest, left);
  sum.end = std::max(sum.end, left * glm::mix(a.end, b.end, u));
  sum.size += size;
  sum.error += size * glm::mix(a.coarse, b.coarse, u);
}

}
