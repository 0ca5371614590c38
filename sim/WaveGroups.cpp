#include "sim/WaveGroups.h"

#include "sim/Angles.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace swellray
{

double WaveGroups::share(double since, double period) const
{
  if (!this->any())
  {
    return 1.0;
  }
  return this->lull + (1.0 - this->lull) * 0.5 * (1.0 + std::cos(2.0 * Pi * since / (this->waves * period)));
}

void WaveGroups::validate() const
{
  const auto require = [](const char* name, double value, bool good, const char* range)
  {
    if (!good)
    {
      std::ostringstream message;
      message << "wave groups: " << name << " must be " << range << ", not " << value;
      throw std::invalid_argument(message.str());
    }
  };
  constexpr double most = 1e6;
  require("the waves of a group", this->waves, this->waves == 0.0 || (this->waves >= 2.0 && this->waves <= most),
    "2 to a million, or 0 for waves that are alike");
  require("the share of the lowest", this->lull, this->lull >= 0.0 && this->lull <= 1.0, "0 to 1");
}

}
