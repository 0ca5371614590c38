#include "sim/Spray.h"

#include <sstream>
#include <stdexcept>

namespace swellray
{

void SprayOptions::validate() const
{
  const auto require = [](const char* name, double value, double low, double high, const char* range)
  {
    if (!(value >= low && value <= high))
    {
      std::ostringstream message;
      message << "spray: " << name << " must be " << range << ", not " << value;
      throw std::invalid_argument(message.str());
    }
  };
  constexpr double most = 1e6;
  require("the largest steepness", this->steepest, 0.0, 10.0, "0 (as traced) to 10");
  require("the rate", this->rate, 0.0, most, "0 to a million");
  require("the scatter", this->scatter, 0.0, 1.0, "0 to 1");
  require("the rebound", this->rebound, 0.0, 1.0, "0 to 1");
  require("gravity", this->gravity, 1e-3, most, "above 0");
  require("the slope of a steep shore", this->steepShore, 1e-3, most, "above 0");
}

}
