#pragma once

#include "sim/RayEquations.h"
#include "sim/RayPath.h"

namespace swellray
{

/**
 * A ray integrated with Dormand and Prince's 5(4) pair (1980) in time, steps adapted to a relative tolerance,
 * read anywhere from the dense output of order 4 (Hairer, Norsett and Wanner 1993, II.6). Along with
 * the ray go its tube and the caustics it touches, found to rounding on the dense output.
 *
 * A step ends exactly on a kink curve of the seafloor, where the gradient of the bed and with it the rate of the
 * tube jumps: with f the rates and nu the gradient of the kink's level,
 *   dk+ = dk- + (f+ - f-) (nu.dx) / (nu.dx/dt).
 *
 * At a vertical wall with unit normal n the ray is mirrored. With f the rates of position and wavenumber before (-) and
 * after (+), and tau = (n.dx)/(n.dx/dt-), the tube goes over as
 *   dx+ = dx- + (f_x+ - f_x-) tau,  dk+ = M (dk- - f_k- tau) + f_k+ tau,
 * M: the derivative of k+ by k- on the wall, in still water the mirror.
 *
 * A ray ends, blocked by the current, where the energy moves along the wavenumber at less than 1 % of the group speed:
 * k.dx/dt < 0.01 k Cg. (In deep water it comes to that where k is four times that of still water, Peregrine 1976,
 * Adv. Appl. Mech. 16: at U = -C0/4 against the wave.) Past that point its phase would run back.
 *
 * Errors of a step are measured in wavelengths (position), relative to |k| (wavenumber), in 2 pi
 * (phase) and relative to the largest value so far (tube).
 */
class HamiltonianRay final : public RayPath
{
public:
  /**
   * @param tolerance relative, per step, > 0
   * @param maxSteps accepted steps after which the ray ends with EndReason::StepCap
   */
  HamiltonianRay(const RayMedium& medium, const RayStart& start, double tolerance, std::size_t maxSteps = 1000000);

  bool advance(FrontMeasure measure, double target, RayPoint& point) override;

  std::vector<RayCaustic> caustics() override;

private:
  using State = rayequations::State;

  static constexpr int BisectionSteps = 60;

  struct Trial
  {
    State end;
    State lastRate;
    rayequations::Local local;
    double error = 0.0;
  };

  enum class Happening
  {
    None,
    Kink,
    End
  };

  /** First thing that happens within the step just made. */
  struct Event
  {
    Happening kind = Happening::None;
    double theta = 1.0;
    EndReason reason = EndReason::LeftScene;
    unsigned kink = 0;
    std::optional<WallHit> wall;
  };

  bool tryStep(double h, Trial& trial);
  double errorNorm(const State& error, const State& end) const;
  bool step();
  double longestStep() const;
  Event findEvent() const;
  void findLandOrHole(Event& event) const;
  void findStop(Event& event) const;
  void findObstacle(Event& event) const;
  void reflect(const RayPoint& wallPoint);
  void crossKink(unsigned kink);
  void prepareDense(double h, const State& end, const State& lastRate);
  State dense(double theta) const;
  double dense(double theta, std::size_t i) const;
  double denseRate(double theta, std::size_t i) const; // by theta
  glm::dvec2 densePosition(double theta) const;
  template <typename Sign>
  double locate(double low, double high, const Sign& outside) const;
  double reached(FrontMeasure measure) const;
  double locateTarget(FrontMeasure measure, double target) const;
  double denseWidth(double theta) const;
  void passCaustics(double to, int& caustics, bool& negative, std::vector<RayCaustic>* touched);
  void touchCaustic(double theta, int number, std::vector<RayCaustic>& touched);
  void describe(double theta, RayPoint& point);
  void end(EndReason reason);

  RayMedium Medium;
  double Tolerance;
  std::size_t MaxSteps;
  double DryDepth;
  unsigned Region = 0;
  std::optional<std::size_t> LeavingWall; // on which the first step starts
  double LeavingSide = 1.0;

  // Start of the current step and what is known there.
  State Begin{};
  State BeginRate{};
  double BeginTime = 0.0;
  double BeginDepth = 0.0;
  double BeginShare = 1.0; // speed of the energy along the wavenumber over the group speed
  double BeginScale = 1.0; // of the map
  int Caustics = 0;
  std::vector<RayCaustic> Touched; // in the steps before
  bool Negative = false;

  // The current step: made when StepSize > 0, valid to LastTheta.
  double StepSize = 0.0;
  double LastTheta = 0.0;
  double ReadTheta = 0.0;
  State End{};
  State EndRate{};
  double EndDepth = 0.0;
  double EndShare = 1.0;
  double EndScale = 1.0;
  bool Terminal = false;
  int KinkAhead = -1;
  std::array<State, 4> Dense{};
  State Stage[5]; // rates at the inner stages 2 to 6

  // Control of the step size.
  double NextStep = 0.0;
  double LastError = 1e-4;
  double WidthScale = 1.0;
  double RateScale = 0.0;
};

inline double HamiltonianRay::dense(double theta, std::size_t i) const
{
  const double rest = 1.0 - theta;
  return this->Begin[i] +
    theta * (this->Dense[0][i] + rest * (this->Dense[1][i] + theta * (this->Dense[2][i] + rest * this->Dense[3][i])));
}

inline double HamiltonianRay::denseRate(double theta, std::size_t i) const
{
  const double rest = 1.0 - theta;
  return this->Dense[0][i] + this->Dense[1][i] * (1.0 - 2.0 * theta) + this->Dense[2][i] * theta * (2.0 - 3.0 * theta) +
    this->Dense[3][i] * 2.0 * theta * rest * (1.0 - 2.0 * theta);
}

inline glm::dvec2 HamiltonianRay::densePosition(double theta) const
{
  return { this->dense(theta, rayequations::X), this->dense(theta, rayequations::Y) };
}

template <typename Sign>
double HamiltonianRay::locate(double low, double high, const Sign& outside) const
{
  for (int i = 0; i < BisectionSteps && high - low > 1e-15; ++i)
  {
    const double middle = 0.5 * (low + high);
    (outside(middle) ? high : low) = middle;
  }
  return high;
}

}
