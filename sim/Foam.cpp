#include "sim/Foam.h"

#include "sim/Angles.h"
#include "sim/SurfHistory.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace swellray
{

namespace
{

// Waves of a group that are lower by this share than those that break begin to leave foam.
constexpr double OnsetShare = 0.02;

// Share of the front of a wave over which its foam ends.
constexpr double FrontEdge = 0.2;

}

void FoamOptions::validate() const
{
  const auto require = [](const char* name, double value)
  {
    if (!(value > 0.0) || std::isinf(value))
    {
      std::ostringstream message;
      message << "foam: " << name << " must be above 0 and finite, not " << value;
      throw std::invalid_argument(message.str());
    }
  };
  require("the period", this->period);
  require("its life", this->life);
  require("the wavelength", this->wavelength);
  if (!(this->front >= 0.0) || this->front > 2.0 * Pi)
  {
    std::ostringstream message;
    message << "foam: the front of waves must be 0 to 2 pi, not " << this->front;
    throw std::invalid_argument(message.str());
  }
  this->groups.validate();
}

double foamAt(double phase, double breakingPhase, double launchParameter, double time, const FoamOptions& options,
  double groupTime, double brokenShare, double plungePhase)
{
  const double broken = phase - breakingPhase;
  if (!(broken >= 0.0))
  {
    return 0.0;
  }
  const double omega = 2.0 * Pi / options.period;
  const double passed = omega * time;
  const double life = omega * options.life; // rad
  const double largestDelay = 2.0 * Pi * options.variation;
  // Of a wave that has come so far since it began to break, its crest so old here.
  const auto shareOf = [&](double wave, double way, double age)
  {
    const double delay = way >= largestDelay + FoamOnsetPhase || !(largestDelay > 0.0) ? 0.0
                                                                                       : largestDelay *
        breakingDelay(options.seed, static_cast<std::int64_t>(wave), launchParameter, options.wavelength);
    double share = std::clamp((way - delay) / FoamOnsetPhase, 0.0, 1.0);
    if (options.groups.any())
    {
      const double high = options.groups.share(time - age / omega - groupTime, options.period);
      share *= std::clamp(1.0 + (high - brokenShare) / OnsetShare, 0.0, 1.0);
    }
    return share;
  };
  double most = 0.0;
  double wave = std::ceil((phase - passed) / (2.0 * Pi));
  double age = passed + 2.0 * Pi * wave - phase;
  const double ahead = 2.0 * Pi - age; // of the crest that comes next
  if (ahead < options.front)
  {
    most = shareOf(wave - 1.0, broken - ahead - plungePhase, -ahead) *
      std::min(1.0, (options.front - ahead) / (FrontEdge * options.front));
  }
  // Later waves leave more; earlier ones count where they broke sooner.
  while (age < life)
  {
    const double share = shareOf(wave, broken, age);
    most = std::max(most, share * (1.0 - age / life));
    if (share == 1.0)
    {
      break;
    }
    age += 2.0 * Pi;
    wave += 1.0;
  }
  return most;
}

void computeFoam(
  const FoamPlaces& places, double time, const FoamOptions& options, float* foam, const Execution& execution)
{
  options.validate();
  FoamOptions used = options;
  used.variation = places.launchParameter ? options.variation : 0.0;
  used.front = places.plungePhase ? options.front : 0.0;
  used.groups = places.groupTime && places.brokenShare ? options.groups : WaveGroups{};
  execution.forRange(places.count,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const double left = places.foamShare ? places.foamShare[i] : 1.0;
        foam[i] = static_cast<float>(left *
          foamAt(places.phase[i], places.breakingPhase[i], places.launchParameter ? places.launchParameter[i] : 0.0,
            time, used, used.groups.any() ? places.groupTime[i] : 0.0, used.groups.any() ? places.brokenShare[i] : 1.0,
            places.plungePhase ? places.plungePhase[i] : 0.0));
      }
    });
}

}
