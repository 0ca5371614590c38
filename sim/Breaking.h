#pragma once

#include <cstdint>

namespace swellray
{

/**
 * Depth-limited breaking, point by point. Heights H crest to trough and depths h in m, wavenumbers k in rad/m, periods
 * T in s, slopes as tangents. Nothing here throws: arguments are to be positive unless said otherwise.
 */

/** Which limit a height has in shallow water, and what becomes of a wave beyond it. */
enum class BreakingRule : std::uint8_t
{
  None = 0,
  Gamma = 1,          ///< H <= gamma h from the first breaking on (saturated)
  Weggel = 2,         ///< saturated at weggelHeight
  Miche = 3,          ///< saturated at micheHeight
  Dally = 4,          ///< breaks at gamma h, decays towards a stable height, reforms (Dally, Dean, Dalrymple 1985)
  BattjesJanssen = 5, ///< random waves, H is the root mean square height (Battjes and Janssen 1978)
  Baldock = 6,        ///< the same, all waves above a height broken (Baldock et al. 1998, Janssen and Battjes 2007)
};

/** Number of rules. */
constexpr int BreakingRuleCount = 7;

/** Name of a rule as the command line has it: "battjes-janssen". */
const char* breakingRuleName(BreakingRule rule);

/** True where heights are root mean square heights of a sea: BattjesJanssen and Baldock. */
bool ofRandomWaves(BreakingRule rule);

/** How a wave breaks. The numbers are those of the array BreakerType. */
enum class BreakerType : std::uint8_t
{
  None = 0,
  Spilling = 1,
  Plunging = 2,
  Surging = 3,
};

/**
 * Largest height on a slope m: Hb/hb = b - a Hb/(g T^2) with a = 43.75 (1 - exp(-19 m)), b = 1.56/(1 + exp(-19.5 m)).
 *
 * Weggel 1972, Maximum breaker height, J. Waterways, Harbors and Coastal Eng. Div. 98 (WW4), fitted to
 * slopes up to 0.1; a slope outside of 0 to 0.1 is taken as the nearer of these.
 */
double weggelHeight(double depth, double slope, double period, double gravity);

/** Largest height 0.142 L tanh(k h), L = 2 pi/k. Miche 1944, Mouvements ondulatoires de la mer, Ann. Ponts Chauss. 114. */
double micheHeight(double wavenumber, double depth);

/**
 * Largest height of a random wave, Hm = (0.88/k) tanh(gamma k h/0.88); gamma h in shallow water.
 * Battjes and Janssen 1978, Energy loss and set-up due to breaking of random waves, Proc. 16th ICCE.
 */
double randomWaveLimit(double wavenumber, double depth, double gamma);

/**
 * gamma = 0.5 + 0.4 tanh(33 s) of the deep-water steepness s = Hrms/L0. Battjes and Stive 1985, Calibration and
 * verification of a dissipation model for random breaking waves, J. Geophys. Res. 90.
 */
double battjesStiveGamma(double steepness);

/**
 * Share Qb of waves that are broken: (1 - Qb)/ln Qb = -(Hrms/Hm)^2, to 1e-12. 0 where Hrms/Hm is below 0.2 (Qb < 2e-11),
 * 1 from Hrms = Hm on. Battjes and Janssen 1978.
 * @param ratio Hrms/Hm, >= 0
 */
double brokenShare(double ratio);

/**
 * Rate at which random waves lose energy by breaking, D/E = 2 Qb/(T (Hrms/Hm)^2), 1/s, of D = rho g Qb Hm^2/(4 T). Battjes and
 * Janssen 1978.
 * @param ratio Hrms/Hm, >= 0; above 1 taken as 1
 */
double randomWaveLossRate(double ratio, double period);

/**
 * Breaker index gamma = 0.76 kh + 0.29 of a place, found from measured waves over barred beaches for kh of 0.25 to 0.75. Ruessink,
 * Walstra and Southgate 2003, Calibration and verification of a parametric wave model on barred beaches, Coastal Eng. 48.
 */
double ruessinkGamma(double wavenumber, double depth);

/**
 * Share of Rayleigh distributed waves that are higher than Hb, exp(-(Hb/Hrms)^2). Baldock, Holmes, Bunker and van Weert 1998,
 * Cross-shore hydrodynamics within an unsaturated surf zone, Coastal Eng. 34.
 * @param ratio Hrms/Hb, >= 0
 */
double higherShare(double ratio);

/**
 * Rate at which random waves lose energy where all those above Hb break, each as a bore that loses rho g H^3/(4 T h):
 *
 *   D/E = (3 sqrt(pi)/2)(Hrms/h)/T (1 + 4/(3 sqrt(pi)) (R^3 + 3/2 R) exp(-R^2) - erf R),  R = Hb/Hrms
 *
 * Janssen and Battjes 2007, A note on wave energy dissipation over steep beaches, Coastal Eng. 54; Alsina and Baldock 2007, ibid.
 * @param ratio Hrms/Hb, >= 0
 * @param heightOverDepth Hrms/h
 */
double baldockLossRate(double ratio, double heightOverDepth, double period);

/** Dally, Dean and Dalrymple 1985: decay coefficient K and stable height over depth, Gamma. */
constexpr double DallyDecay = 0.15;
constexpr double DallyStableIndex = 0.4;

/**
 * Surf similarity (Iribarren number) xi = tan(beta)/sqrt(H/L0), L0 = g T^2/(2 pi). Battjes 1974, Surf similarity, Proc.
 * 14th ICCE. With the height in deep water xi_0, with that at breaking xi_b.
 * @param slope tan(beta), positive where the bed rises in the direction of the wave; 0 and below gives such a number
 */
double iribarrenNumber(double slope, double height, double period, double gravity);

/** Type of a breaker by its xi_0: spilling below 0.5, plunging to 3.3, surging above. Battjes 1974. */
BreakerType breakerType(double iribarrenOffshore);

/** Type of a breaker by its xi_b: spilling below 0.4, plunging to 2.0, surging above. Battjes 1974. */
BreakerType breakerTypeAtBreaking(double iribarrenBreaking);

/**
 * Rate at which bottom friction takes energy, D/E in 1/s:
 *
 *   D = 2/(3 pi) rho fw u^3,  u = pi H/(T sinh kh),  E = rho g H^2/8
 *
 * Jonsson 1966, Wave boundary layers and friction factors, Proc. 10th ICCE: bed stress rho fw u|u|/2 over a period of
 * a sine. It is that of Putnam and Johnson 1949 with their f = fw/2, and 4 fw is the Darcy-Weisbach f of D = rho f
 * u^3/(6 pi) in Dean and Dalrymple 1991, section 9.2.
 * @param frictionFactor fw, -, >= 0
 */
double frictionRate(
  double frictionFactor, double height, double wavenumber, double depth, double period, double gravity);

/** Kinematic viscosity of water of 20 degrees, m2/s. */
constexpr double WaterViscosity = 1e-6;

/**
 * Rate at which the laminar boundary layer over a smooth bed takes energy, D/E in 1/s, whatever the height:
 *
 *   D = rho u^2/2 sqrt(nu omega/2),  u = pi H/(T sinh kh)
 *
 * by which a wave over a flat bed falls off as exp(-ki x), ki = 2 k^2 sqrt(nu/(2 omega))/(2kh + sinh 2kh). Hunt 1952, Amortissement
 * par viscosite de la houle sur un fond incline, La Houille Blanche 7. Laminar up to u^2/(omega nu) of some 1e4 (Jonsson 1966).
 * @param viscosity nu, m2/s, >= 0
 */
double laminarFrictionRate(double viscosity, double wavenumber, double depth, double period, double gravity);

}
