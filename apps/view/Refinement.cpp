#include "Refinement.h"

#include <cmath>
#include <cstdlib>

namespace swellray::view
{

namespace
{

// Coarseness of the very first trace, of which nothing is known.
constexpr int Unknown = 16;

// A step of the refinement takes about this long at most, s, unless it is the least there is.
constexpr double LongestStep = 1.0;

}

Refinement::Refinement(double frame)
  : Frame(frame)
{
}

double Refinement::expected(int coarseness) const
{
  double seconds = 0.0;
  double nearest = HUGE_VAL;
  for (const auto& [known, time] : this->Seconds)
  {
    const double ratio = static_cast<double>(known) / coarseness;
    const double distance = std::fabs(std::log(ratio));
    if (distance < nearest)
    {
      nearest = distance;
      seconds = time * ratio;
    }
  }
  return seconds;
}

int Refinement::first() const
{
  if (this->Seconds.empty())
  {
    return Unknown;
  }
  int coarseness = 1;
  while (coarseness<Coarsest&& this->expected(coarseness)> this->Frame)
  {
    coarseness *= 2;
  }
  return coarseness;
}

int Refinement::next(int coarseness) const
{
  int finer = 1;
  while (2 * finer<coarseness&& this->expected(finer)> LongestStep)
  {
    finer *= 2;
  }
  return finer;
}

void Refinement::learn(int coarseness, double seconds)
{
  this->Seconds[coarseness] = seconds;
}

}
