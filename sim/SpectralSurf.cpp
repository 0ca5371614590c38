#include "sim/SpectralSurf.h"

#include "sim/Angles.h"
#include "sim/Dispersion.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace swellray
{

namespace
{

constexpr double PointsPerWave = 8.0;
constexpr std::size_t MostKnots = 6;

// Directions with less energy than this share of the main one's are not followed.
constexpr double LeastPart = 0.05;

// Waves of Hrms/Hm below 0.3 lose nothing (Qb = 1.5e-5): of Hs below a quarter of the depth, with some room for refraction.
constexpr double SurfReach = 4.0 * 1.5;

SurfSample sampleOf(double depth, double wavenumber, double groupSpeed, double height)
{
  SurfSample sample;
  sample.depth = depth;
  sample.wavenumber = wavenumber;
  sample.groupSpeed = groupSpeed;
  sample.lossless = height;
  return sample;
}

}

SpectralSurf::SpectralSurf(const BackwardTracer& tracer, const SpectralRays& rays, const DirectionalSpectrum& offshore,
  BreakingRule rule, std::optional<double> gamma)
  : Tracer(tracer)
  , Rays(rays)
  , Offshore(offshore)
{
  if (!ofRandomWaves(rule))
  {
    throw std::invalid_argument(std::string("random waves have no breaking rule ") + breakingRuleName(rule) +
      "; they have battjes-janssen and baldock");
  }
  if (gamma && !(*gamma > 0.0 && std::isfinite(*gamma)))
  {
    throw std::invalid_argument("gamma, the breaker index, must be above 0");
  }
  const SeaParameters sea = seaParameters(offshore);
  this->Rule.breaking = rule;
  this->Rule.localGamma = rule == BreakingRule::Baldock && !gamma;
  this->Rule.deepHeight = sea.significantHeight;
  this->Rule.period = sea.peakPeriod;
  this->Rule.gravity = tracer.options().gravity;
  const double omega = 2.0 * Pi / sea.peakPeriod;
  const double gravity = this->Rule.gravity;
  const double depth = tracer.options().offshoreDepth;
  const double k = solveWavenumber(omega, depth, gravity);
  const double inDeepWater = std::sqrt(waveSpeeds(k, depth, gravity).groupSpeed * 2.0 * omega / gravity);
  const double length = 2.0 * Pi * gravity / (omega * omega);
  this->Rule.gamma = gamma.value_or(battjesStiveGamma(this->Rule.deepHeight / std::sqrt(2.0) * inDeepWater / length));
}

double SpectralSurf::rootMeanSquareHeight(const glm::dvec2& place, Outcome& outcome) const
{
  const std::vector<SpectralOrigins> origins = traceOrigins(this->Tracer, this->Rays, { place });
  outcome.rays += origins.front().headings.size();
  outcome.steps += origins.front().steps;
  if (origins.front().headings.empty())
  {
    return std::nan("");
  }
  DirectionalSpectrum spectrum;
  SpectralTransfer(this->Rays, this->Offshore.grid, origins.front()).apply(this->Offshore.density, spectrum);
  return seaParameters(spectrum).significantHeight / std::sqrt(2.0);
}

double SpectralSurf::shareAlong(const std::vector<RayPoint>& way, double height, Outcome& outcome) const
{
  const double highest = std::max(this->Rule.deepHeight, height * std::sqrt(2.0));
  const auto first =
    std::find_if(way.begin(), way.end() - 1, [&](const RayPoint& p) { return p.depth < SurfReach * highest; });
  const auto begin = static_cast<std::size_t>(first - way.begin());

  // Height over shoaling coefficient, up to a factor, at knots: the last is the place itself.
  const auto groupSpeed = [&](const RayPoint& p)
  {
    Frequency f;
    evaluateFrequency(glm::length(p.wavenumber), p.depth, this->Rule.gravity, f);
    return f.k;
  };
  const std::size_t last = way.size() - 1;
  const auto waves = static_cast<std::size_t>(std::ceil(static_cast<double>(last - begin) / PointsPerWave));
  const std::size_t knots = std::min(waves + 1, MostKnots);
  std::vector<double> at;
  std::vector<double> flux;
  for (std::size_t i = 0; i < knots; ++i)
  {
    const std::size_t j = knots > 1 ? begin + i * (last - begin) / (knots - 1) : last;
    const double there = j == last ? height : this->rootMeanSquareHeight(way[j].position, outcome);
    if (there > 0.0)
    {
      at.push_back(static_cast<double>(j));
      flux.push_back(there * std::sqrt(groupSpeed(way[j])));
    }
  }
  std::size_t next = 0;
  const auto sample = [&](std::size_t j)
  {
    const auto x = static_cast<double>(j);
    while (next + 1 < at.size() && at[next] < x)
    {
      ++next;
    }
    double here = flux[next];
    if (next > 0 && x < at[next])
    {
      const double w = (x - at[next - 1]) / (at[next] - at[next - 1]);
      here = (1.0 - w) * flux[next - 1] + w * flux[next];
    }
    const double speed = groupSpeed(way[j]);
    return sampleOf(way[j].depth, glm::length(way[j].wavenumber), speed, here / std::sqrt(speed));
  };
  const MapScale* map = this->Tracer.options().map;
  BreakingMarch march(this->Rule, sample(begin));
  for (std::size_t j = begin + 1; j <= last; ++j)
  {
    const double scale = map ? map->scale(0.5 * (way[j].position + way[j - 1].position)) : 1.0;
    march.advance(
      sample(j), way[j].travelTime - way[j - 1].travelTime, glm::length(way[j].position - way[j - 1].position) / scale);
  }
  return march.share();
}

SpectralSurf::Outcome SpectralSurf::at(const glm::dvec2& place, double depth, const DirectionalSpectrum& unbroken) const
{
  const double height = seaParameters(unbroken).significantHeight / std::sqrt(2.0);
  const double period = this->Rule.period;
  if (!(height > 0.0) || !std::isfinite(period))
  {
    return {};
  }

  // The sea's directions at the frequency nearest to its peak, by the energy in each.
  const std::vector<double>& headings = unbroken.grid.headings;
  std::size_t peak = 0;
  for (std::size_t f = 1; f < unbroken.grid.frequencies.size(); ++f)
  {
    const auto distance = [&](std::size_t i) { return std::abs(unbroken.grid.frequencies[i] - 1.0 / period); };
    peak = distance(f) < distance(peak) ? f : peak;
  }
  double most = 0.0;
  for (std::size_t j = 0; j < headings.size(); ++j)
  {
    most = std::max(most, unbroken.at(peak, j));
  }
  Outcome outcome;
  double energy = 0.0;
  double left = 0.0;
  std::vector<RayPoint> way;
  for (std::size_t j = 0; j < headings.size(); ++j)
  {
    const double part = unbroken.at(peak, j);
    if (!(part > LeastPart * most))
    {
      continue;
    }
    const double frequency = unbroken.grid.frequencies[peak];
    const WaveOrigin origin = this->Tracer.trace(place, frequency, headings[j], PointsPerWave, way);
    ++outcome.rays;
    outcome.steps += origin.steps;
    if (std::isfinite(origin.heading) && way.size() > 1)
    {
      energy += part;
      left += part * this->shareAlong(way, height, outcome);
    }
  }
  const double share = energy > 0.0 ? left / energy : 1.0;
  const double k = solveWavenumber(2.0 * Pi / period, depth, this->Rule.gravity);
  const double groupSpeed = waveSpeeds(k, depth, this->Rule.gravity).groupSpeed;
  const BreakingMarch here(this->Rule, sampleOf(depth, k, groupSpeed, height * std::sqrt(share)));
  outcome.share = share * here.share();
  outcome.breaking = here.broken();
  return outcome;
}

}
