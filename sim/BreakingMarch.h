#pragma once

#include "sim/Breaking.h"

namespace swellray
{

/** What breaking depends on at a place of a ray. */
struct SurfSample
{
  double depth = 0.0;      ///< m, > 0
  double wavenumber = 0.0; ///< rad/m
  double groupSpeed = 0.0; ///< relative to the water, m/s
  double slope = 0.0;      ///< of the bed along the ray, positive where it rises
  double lossless = 0.0;   ///< H0 Ks Kr, the height without losses, m; may be infinite
};

/** What holds for a whole ray. */
struct SurfRule
{
  BreakingRule breaking = BreakingRule::Gamma;
  double gamma = 0.78;     ///< breaker index, > 0
  bool localGamma = false; ///< with Baldock, that of each place: ruessinkGamma()
  double friction = 0.0;   ///< bottom friction factor fw, >= 0
  double viscosity = 0.0;  ///< of the water over a smooth bed, m2/s, >= 0
  double period = 10.0;    ///< s
  double gravity = 9.81;   ///< m/s2
  double deepHeight = 1.0; ///< height of the incident wave in deep water, m: breaker types
};

/** Losses up to a place of a ray. */
struct RayLosses
{
  double share = 1.0;    ///< P
  double friction = 1.0; ///< Kf
  double distance = 0.0; ///< m since breaking began
  bool broken = false;
  BreakerType type = BreakerType::None;
};

/**
 * Losses of a wave along its ray. P = (H/(H0 Ks Kr))^2 is the share of the wave action that is left; with t the travel
 * time, in which currents are contained,
 *
 *   dP/dt = -P D/E.
 *
 * Friction: frictionRate(), laminarFrictionRate(). Saturated rules: P as large as their limit allows. Dally, Dean and Dalrymple 1985, from
 * the first place with H > gamma h on, until H <= 0.4 h:
 *
 *   dP/dt = -(K Cg/h) (P - Ps),  Ps = (0.4 h/(H0 Ks Kr))^2,  K = 0.15.
 *
 * (Fitted to slopes up to 1:30. On a bed steeper than about 1:15 the decay would lag behind the depth: H <= gamma h
 * holds on.)
 *
 * Battjes and Janssen 1978, H the root mean square height, Hm randomWaveLimit(), at most Hm:
 *
 *   D = rho g Qb Hm^2/(4 T).
 *
 * Baldock et al. 1998: baldockLossRate(), Hb randomWaveLimit() of the index of the place; H has no limit.
 *
 * Between two points everything is linear in the way; sub-steps are midpoint steps, halved by friction (Strang), the
 * places where breaking begins and ends are found to rounding. All in all of second order in the distance of the points.
 */
class BreakingMarch
{
public:
  /** @param before what the wave had lost before the ray began */
  BreakingMarch(const SurfRule& rule, const SurfSample& start, const RayLosses& before = {});

  /** Go on to the next point, which is reached after so many seconds and metres. */
  void advance(const SurfSample& next, double seconds, double metres);

  /** Keep the height below gamma h here, whatever the rule. @return true where it was higher */
  bool limitToDepth();

  double height() const;
  /** P: what is left of the wave action. */
  double share() const { return this->Share; }
  /** True where the wave breaks; of random waves, where the share of broken waves is above 5 %. */
  bool broken() const { return this->Broken; }
  /** Way since breaking began, m; 0 where it is not broken. */
  double distance() const { return this->Broken ? this->Distance : 0.0; }
  BreakerType type() const { return this->Broken ? this->Type : BreakerType::None; }
  /** Kf: what friction alone has left of the height. */
  double friction() const { return this->Kf; }
  /** Share of the waves that are broken: Qb of random waves, otherwise 0 or 1. */
  double brokenShare() const;

private:
  struct Step
  {
    SurfSample from;
    SurfSample to;
    double seconds;
    double metres;

    SurfSample at(double w) const;
  };

  /** Breaker index here. */
  double indexAt(const SurfSample& sample) const;
  /** Height of random waves at which they are told to break, m: Hm or Hb. */
  double randomLimit(const SurfSample& sample) const;
  double randomLossRate(const SurfSample& sample, double share) const;
  /** The height at which breaking begins here, m. */
  double onset(const SurfSample& sample) const;
  /** The largest height here, m. */
  double limit(const SurfSample& sample) const;
  double stableShare(const SurfSample& sample) const;
  /** Share left at w1 of `share` at w0. */
  double shareAfter(const Step& step, double share, double w0, double w1, double& kf) const;
  double breakingLoss(const SurfSample& middle, double share, double seconds) const;
  bool changes(const Step& step, double share, double w) const;
  /** Advance from w0 towards w1, to the first place where the state changes; returns the place. */
  double advanceTo(const Step& step, double w0, double w1);
  void begin(const SurfSample& sample);

  SurfRule Rule;
  SurfSample Here;
  double Share = 1.0;
  double Kf = 1.0;
  double Distance = 0.0;
  bool Broken = false;
  BreakerType Type = BreakerType::None;
};

}
