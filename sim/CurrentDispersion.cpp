#include "sim/CurrentDispersion.h"

#include "sim/Dispersion.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace swellray
{

namespace
{

constexpr double Converged = 1e-14;
constexpr int NewtonSteps = 30;

// Where Newton's method leaves its way the root is looked for at so many places, and halved in so often.
constexpr int Places = 256;
constexpr int Halvings = 60;

/** The dispersion relation along the line of wavenumbers k = n along + across left(along). */
class Line
{
public:
  Line(double omega, double depth, double gravity, const glm::dvec2& along, double across, const glm::dvec2& current)
    : Omega(omega)
    , Depth(depth)
    , Gravity(gravity)
    , Across(across)
    , Along(glm::dot(current, along))
    , Left(current.y * along.x - current.x * along.y)
  {
  }

  /** sigma + k.U - omega. */
  double miss(double n) { return this->at(n).sigma + n * this->Along + this->Across * this->Left - this->Omega; }

  /** Speed of the energy along the line, m/s; for the n of the last miss(). */
  double slope(double n) const { return this->F.k * n / this->K + this->Along; }

  bool stopped(double n)
  {
    this->at(n);
    const double doppler = n * this->Along + this->Across * this->Left;
    return !(this->K * this->F.k + doppler >= BlockedShare * this->K * this->F.k);
  }

  /** A wavenumber beyond which every wave of this frequency is stopped: sigma - k sigma_k = omega - k.dx/dt. */
  double largest(double still)
  {
    double k = still;
    do
    {
      k *= 1.5;
      evaluateFrequency(k, this->Depth, this->Gravity, this->F);
    } while (this->F.sigma - k * this->F.k < this->Omega);
    return k;
  }

private:
  const Frequency& at(double n)
  {
    this->K = std::hypot(n, this->Across);
    evaluateFrequency(this->K, this->Depth, this->Gravity, this->F);
    return this->F;
  }

  double Omega;
  double Depth;
  double Gravity;
  double Across;
  double Along;
  double Left;
  double K = 0.0;
  Frequency F{};
};

std::optional<double> newton(Line& line, double n)
{
  for (int i = 0; i < NewtonSteps && n > 0.0; ++i)
  {
    const double miss = line.miss(n);
    const double slope = line.slope(n);
    if (!(slope > 0.0))
    {
      break;
    }
    const double step = miss / slope;
    n -= step;
    if (std::abs(step) <= Converged * n)
    {
      return n;
    }
  }
  return {};
}

std::optional<double> search(Line& line, double most)
{
  double low = 0.0;
  bool below = false;
  for (int i = 1; i <= Places; ++i)
  {
    double high = most * i / Places;
    const bool above = line.miss(high) >= 0.0;
    if (below && above)
    {
      for (int halving = 0; halving < Halvings; ++halving)
      {
        const double middle = 0.5 * (low + high);
        (line.miss(middle) < 0.0 ? low : high) = middle;
      }
      return high;
    }
    low = high;
    below = !above;
  }
  return {};
}

}

std::optional<double> solveOnCurrent(
  double omega, double depth, double gravity, const glm::dvec2& along, double across, const glm::dvec2& current)
{
  Line line(omega, depth, gravity, along, across, current);
  const double still = solveWavenumber(omega, depth, gravity);
  const double square = still * still - across * across;
  std::optional<double> n;
  if (square > 0.0)
  {
    n = newton(line, std::sqrt(square));
  }
  if (!n)
  {
    const double most = line.largest(still);
    if (most > std::abs(across))
    {
      n = search(line, std::sqrt(most * most - across * across));
    }
  }
  if (n && line.stopped(*n))
  {
    n.reset();
  }
  return n;
}

}
