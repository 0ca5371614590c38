#include "sim/TrochoidTable.h"

#include "sim/Angles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace swellray
{

namespace
{

constexpr std::size_t Steps = 32;   // of the steepness
constexpr std::size_t Phases = 256; // a period
constexpr double Steepest = 0.99;   // a cusp has no slope

// k x0 of a phase k x, by Newton's method kept within its bracket.
double parameterAt(double phase, double steepness)
{
  double low = phase - steepness;
  double high = phase + steepness;
  double u = phase;
  for (int i = 0; i < 60; ++i)
  {
    const double off = u - steepness * std::sin(u) - phase;
    (off > 0.0 ? high : low) = u;
    const double next = u - off / (1.0 - steepness * std::cos(u));
    const double kept = next > low && next < high ? next : 0.5 * (low + high);
    if (std::abs(kept - u) < 1e-15)
    {
      break;
    }
    u = kept;
  }
  return u;
}

}

TrochoidTable::TrochoidTable()
{
  this->Nodes.resize((Steps + 1) * (Phases + 1));
  for (std::size_t s = 0; s <= Steps; ++s)
  {
    const double steepness = Steepest * static_cast<double>(s) / Steps;
    // Over k x, with dx/dx0 = 1 - kr cos: the mean of cos is -kr/2, that of cos^2 is 1/2.
    const double mean = -0.5 * steepness;
    const double scale = std::sqrt(0.5 / (0.5 - mean * mean));
    for (std::size_t i = 0; i <= Phases; ++i)
    {
      const double u = parameterAt(2.0 * Pi * static_cast<double>(i) / Phases, steepness);
      this->Nodes[s * (Phases + 1) + i] = { scale * (std::cos(u) - mean),
        -scale * std::sin(u) / (1.0 - steepness * std::cos(u)) };
    }
  }
}

double TrochoidTable::value(double phase, double steepness) const
{
  const double turns = phase / (2.0 * Pi);
  const double place = (turns - std::floor(turns)) * Phases;
  const std::size_t i = std::min(static_cast<std::size_t>(place), Phases - 1);
  const double u = place - static_cast<double>(i);
  const double step = 2.0 * Pi / Phases;
  const double level = std::clamp(steepness / Steepest, 0.0, 1.0) * Steps;
  const std::size_t s = std::min(static_cast<std::size_t>(level), Steps - 1);
  const double v = level - static_cast<double>(s);
  // Cubic between the phases, linear between the steepnesses.
  const double a = (1.0 + 2.0 * u) * (1.0 - u) * (1.0 - u);
  const double b = u * (1.0 - u) * (1.0 - u) * step;
  const double c = u * u * (3.0 - 2.0 * u);
  const double d = u * u * (u - 1.0) * step;
  double sum = 0.0;
  for (std::size_t side = 0; side < 2; ++side)
  {
    const Node* node = this->Nodes.data() + (s + side) * (Phases + 1) + i;
    sum += (side == 0 ? 1.0 - v : v) * (a * node[0].value + b * node[0].slope + c * node[1].value + d * node[1].slope);
  }
  return sum;
}

}
