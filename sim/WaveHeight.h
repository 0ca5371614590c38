#pragma once

#include "sim/BreakingMarch.h"
#include "sim/IncidentWave.h"
#include "sim/RayField.h"
#include "sim/SurfZone.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace swellray
{

enum class AmplitudeRule
{
  Spacing, ///< from the distance of neighbouring rays
  Tube,    ///< from dynamic ray tracing along each ray
};

/** What becomes of the height next to a caustic, where the tube has no width. */
enum class CausticRule
{
  Uniform,   ///< finite at folds by the modulus of the Airy function (RayFolds); else as Cap
  Geometric, ///< infinite
  Cap,       ///< limited by HeightOptions::maxRefraction
};

/** As the command line names it. */
const char* causticRuleName(CausticRule rule);

/** Breaker index H/h unless set. */
constexpr double StandardGamma = 0.78;

struct HeightOptions
{
  AmplitudeRule amplitude = AmplitudeRule::Spacing;
  BreakingRule breaking = BreakingRule::Gamma;
  std::optional<double> gamma; ///< breaker index H/h, > 0; none: breakerIndex()
  double friction = 0.0;       ///< bottom friction factor fw (Jonsson 1966), >= 0
  double viscosity =
    0.0; ///< in place of fw: of the water over a smooth bed whose boundary layer is laminar, m2/s, >= 0
  CausticRule caustics = CausticRule::Uniform;

  /**
   * Cap of the refraction coefficient, > 0. With CausticRule::Uniform it gives way to the fold's own peak along rays on
   * which that is higher.
   */
  double maxRefraction = 3.0;

  bool rubs() const { return this->friction > 0.0 || this->viscosity > 0.0; }

  /** @throws std::invalid_argument naming the option that is out of range */
  void validate() const;
};

/** Wave quantities at the points of one ray; all vectors have one entry a point. */
struct RayHeights
{
  std::vector<double> refraction; ///< Kr in use, -
  std::vector<double> height;     ///< H, m
  /**
   * W across a metre of the tube: rho g H^2 Cg/8; on a current rho g H^2/8 (omega/sigma) |Cg k/|k| + U|, omega times the
   * flux of wave action, which is what a tube without losses keeps (Bretherton and Garrett 1968).
   */
  std::vector<double> energyFlux;
  std::vector<double> orbitalVelocity;   ///< H sigma/(2 sinh kh), amplitude near the bed, m/s
  std::vector<std::uint8_t> breaking;    ///< 1 where the wave breaks; of random waves where more than 5 % do
  std::vector<std::uint8_t> breakerType; ///< BreakerType of the wave where it breaks, by xi_0 where breaking began
  std::vector<double> breakingDistance;  ///< way along the ray since breaking began, m; 0 where it does not break
  std::vector<double> friction;          ///< Kf: what bottom friction alone has left of the height
  std::vector<double> share;             ///< P: what breaking and friction have left of the wave action
  std::vector<double> brokenShare;       ///< of random waves the share that is broken, otherwise 0 or 1
};

/** Input of the heights along one ray: plain arrays, one entry a point, as they lie in a ray file. */
struct RayProfile
{
  std::size_t count = 0;
  const double* position = nullptr;     ///< x, y, z a point, m; null: ways and slopes are 0, breaker types not known
  const double* scale = nullptr;        ///< length on the map of the Earth over true length; null: 1
  const double* travelTime = nullptr;   ///< s; null allowed where nothing is lost by the way
  const double* depth = nullptr;        ///< m
  const double* wavenumber = nullptr;   ///< rad/m
  const double* groupSpeed = nullptr;   ///< relative to the water, m/s
  const double* shoaling = nullptr;     ///< Ks, -
  const double* krSpacing = nullptr;    ///< -, NaN or infinite allowed
  const double* krTube = nullptr;       ///< -
  const std::uint8_t* state = nullptr;  ///< RayState
  RayLosses before;                     ///< what the wave had lost before the ray began: inserted rays
  double reflection = 1.0;              ///< product of the coefficients of the obstacles that reflected it
  const double* phase = nullptr;        ///< S, rad, increasing; null allowed without caustics
  const RayCaustic* caustics = nullptr; ///< touched by the ray
  std::size_t causticCount = 0;
  const double* foldBeside =
    nullptr; ///< as foldsBeside(), used with CausticRule::Uniform; null: no fold goes beside it
};

/** What is known of the losses of one ray: plain arrays, one entry a point. */
struct RayLossArrays
{
  std::size_t count = 0;
  const double* phase = nullptr; ///< rad, increasing
  const double* share = nullptr; ///< RayHeights::share, and so on
  const double* friction = nullptr;
  const double* breakingDistance = nullptr;
  const std::uint8_t* breaking = nullptr;
  const std::uint8_t* breakerType = nullptr;
  const std::uint8_t* state = nullptr; ///< RayState
};

/**
 * Losses of a ray at the point whose phase is nearest to that wanted; none where it is aground there or has no point.
 * With them a ray that was inserted beside it on that front begins.
 */
RayLosses lossesAt(const RayLossArrays& ray, double phase);

/**
 * Breaker index in use: that of the options; for Battjes-Janssen otherwise that of Battjes and Stive 1985 for the wave's
 * steepness in deep water, else 0.78. (Baldock's waves have one of each place unless it is given; this one holds for rays aground.)
 */
double breakerIndex(const HeightOptions& options, const IncidentWave& wave);

/** What holds along each ray of the wave. */
SurfRule surfRule(const HeightOptions& options, const IncidentWave& wave);

/** Height of the wave in deep water, unrefracted, m: H0 sqrt(Cg/Cg_deep) of its offshore depth. */
double deepWaterHeight(const IncidentWave& wave);

/**
 * H = H0 Ks Kr (times what obstacles reflected) with the losses of BreakingMarch (equations there), point by point along a ray: bottom friction, and
 * breaking by the rule. With ofRandomWaves() H0 and all heights are root mean square heights of a sea of narrow
 * spectrum, Hrms = Hm0/sqrt 2, and the period is that of its peak; otherwise heights of a regular wave.
 *
 * Ks is taken as the tracer found it. Next to a fold caustic the width of the tube is that of the tube equation. Where the rule's coefficient is not known (NaN) the other one is taken; an
 * aground ray is no higher than gamma h. Slopes are those of the bed along the ray, from the depths at the points.
 * @param result resized to profile.count
 * @throws std::invalid_argument on a bad wave or option, or where the profile lacks what these need
 */
void computeHeights(
  const RayProfile& profile, const IncidentWave& wave, const HeightOptions& options, RayHeights& result);

}
