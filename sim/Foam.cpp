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

// Foam sets in over this phase.
constexpr double OnsetPhase = 2.0 * Pi / 16.0;

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
}

void computeFoam(
  const FoamPlaces& places, double time, const FoamOptions& options, float* foam, const Execution& execution)
{
  options.validate();
  const double omega = 2.0 * Pi / options.period;
  const double passed = omega * time;
  const double life = omega * options.life; // rad
  const double largestDelay = places.launchParameter ? 2.0 * Pi * options.variation : 0.0;
  execution.forRange(places.count,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        foam[i] = 0.0f;
        const double broken = places.phase[i] - places.breakingPhase[i];
        if (!(broken >= 0.0))
        {
          continue;
        }
        // Later waves leave more; earlier ones count where they broke sooner.
        double most = 0.0;
        double wave = std::ceil((places.phase[i] - passed) / (2.0 * Pi));
        double age = passed + 2.0 * Pi * wave - places.phase[i];
        while (age < life)
        {
          const double delay = broken >= largestDelay + OnsetPhase ? 0.0
            : largestDelay > 0.0                                   ? largestDelay *
              breakingDelay(
                options.seed, static_cast<std::int64_t>(wave), places.launchParameter[i], options.wavelength)
                                 : 0.0;
          const double share = std::clamp((broken - delay) / OnsetPhase, 0.0, 1.0);
          most = std::max(most, share * (1.0 - age / life));
          if (share == 1.0)
          {
            break;
          }
          age += 2.0 * Pi;
          wave += 1.0;
        }
        foam[i] = static_cast<float>(most);
      }
    });
}

}
