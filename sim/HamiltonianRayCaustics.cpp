#include "sim/HamiltonianRay.h"

#include <cmath>

// Where a ray touches caustics, and what its tube does there.

namespace swellray
{

using namespace rayequations;

double HamiltonianRay::denseWidth(double theta) const
{
  // The ray's way: along the wavenumber, unless a current carries it.
  const double x = this->Medium.current ? this->denseRate(theta, X) : this->dense(theta, Kx);
  const double y = this->Medium.current ? this->denseRate(theta, Y) : this->dense(theta, Ky);
  return x * this->dense(theta, DY) - y * this->dense(theta, DX);
}

void HamiltonianRay::passCaustics(double to, int& caustics, bool& negative, std::vector<RayCaustic>* touched)
{
  // Twice within a third of a step would need a lens far smaller than the steps resolve.
  double before = 0.0;
  for (const double theta : { to / 3.0, to * 2.0 / 3.0, to })
  {
    const double width = this->denseWidth(theta);
    if (width != 0.0 && (width < 0.0) != negative)
    {
      negative = !negative;
      ++caustics;
      if (touched)
      {
        const auto past = [&](double t) { return (this->denseWidth(t) < 0.0) == negative; };
        this->touchCaustic(this->locate(before, theta, past), caustics, *touched);
      }
    }
    before = theta;
  }
}

void HamiltonianRay::touchCaustic(double theta, int number, std::vector<RayCaustic>& touched)
{
  const State y = this->dense(theta);
  State rate;
  Local local;
  ++this->Evaluations;
  if (!evaluate(this->Medium, this->Region, this->DryDepth, y, rate, local))
  {
    return;
  }
  const double speed = std::hypot(rate[X], rate[Y]);
  const glm::dvec2 along = glm::dvec2(rate[X], rate[Y]) / speed;
  // All that the tube has left is a shift along the ray: seen from the place itself the wavenumber alone changes.
  const double shift = (along.x * y[DX] + along.y * y[DY]) / speed;
  State fan = y;
  fan[DX] = fan[DY] = 0.0;
  fan[DKx] -= shift * rate[Kx];
  fan[DKy] -= shift * rate[Ky];
  State fanRate;
  ++this->Evaluations;
  evaluate(this->Medium, this->Region, this->DryDepth, fan, fanRate, local);

  RayCaustic caustic;
  caustic.number = number;
  caustic.position = { y[X], y[Y] };
  caustic.rayDirection = along;
  caustic.phase = y[Phase];
  caustic.travelTime = this->BeginTime + theta * this->StepSize;
  caustic.wavenumber = { y[Kx], y[Ky] };
  caustic.phaseRate = rate[Phase] / speed;
  caustic.widthRate = (along.x * fanRate[DY] - along.y * fanRate[DX]) / speed;
  caustic.fanWavenumber = (along.x * fan[DKy] - along.y * fan[DKx]) / caustic.widthRate;
  caustic.scale = this->Medium.scale(caustic.position);
  touched.push_back(caustic);
}

std::vector<RayCaustic> HamiltonianRay::caustics()
{
  std::vector<RayCaustic> touched = this->Touched;
  if (this->StepSize > 0.0)
  {
    int caustics = this->Caustics;
    bool negative = this->Negative;
    this->passCaustics(this->ReadTheta, caustics, negative, &touched);
  }
  return touched;
}

}
