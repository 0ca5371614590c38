#pragma once

namespace swellray
{

/**
 * What engineers and surfers take from a breaker: its height Hb (m), depth hb (m), wavenumber k (rad/m), group speed Cg
 * (m/s), and angle theta (rad) between crest and bed contour. Nothing here throws.
 */

/** Density of sea water, kg/m3. */
constexpr double SeaWaterDensity = 1025.0;

/**
 * Set-down of the mean water level at breaking, m, negative: -H^2 k/(8 sinh 2kh).
 * Longuet-Higgins and Stewart 1964, Radiation stresses in water waves, Deep-Sea Res. 11: waves along their ray
 * towards the shore, without loss before they break.
 */
double setDown(double height, double depth, double wavenumber);

/** Mean water level above still water where the surf zone meets the beach, m. */
struct WaveSetUp
{
  double stillWaterLine; ///< where the depth of still water is 0
  double maximum;        ///< where the mean water meets a plane beach
};

/**
 * Set-up of a surf zone in which H is gamma times the mean depth, gamma = Hb/hb, on a plane beach, waves straight on:
 * the mean level rises by K a metre of still depth, K = 1/(1 + 8/(3 gamma^2)), from the set-down eta_b at breaking on.
 *
 *   eta(h = 0) = eta_b + K hb,   eta_max = (eta_b + K hb)/(1 - K)
 *
 * Bowen, Inman and Simmons 1968, Wave set-down and set-up, J. Geophys. Res. 73.
 */
WaveSetUp waveSetUp(double height, double depth, double wavenumber);

/**
 * Longshore energy flux factor P_ls = rho g Hs^2 Cg sin(2 theta)/16, W/m of beach, signed as theta.
 * Shore Protection Manual 1984, chapter 4, linear theory at breaking. It is C times the radiation stress S_xy of the wave in
 * the water (Longuet-Higgins and Stewart 1964), so that C and Cg are relative to the water where there is a current.
 * @param significantHeight Hs, m
 */
double longshoreEnergyFlux(double significantHeight, double groupSpeed, double angle, double gravity);

/**
 * Longshore transport of sand, m3/s of bed with its pores, signed as the flux: K P_ls/((rho_s - rho) g (1 - n)) with
 * K = 0.39, rho_s = 2650 kg/m3, n = 0.4. CERC formula, Shore Protection Manual 1984, chapter 4; K belongs to
 * the significant height. For long sandy beaches, to a factor of two at best.
 */
double longshoreTransport(double longshoreFlux, double gravity);

/**
 * Vortex ratio of a plunging surfing wave, length over width of the hollow under its lip: 0.065 X + 0.821, X = 1/slope of
 * the bed along the orthogonal of the wave. Mead and Black 2001, Predicting the breaking intensity of surfing waves, J.
 * Coastal Res. Special Issue 29. NaN outside of slopes from 1:8 to 1:40, where surfing reefs were measured.
 * @param slope positive where the bed rises in the direction of the wave
 */
double vortexRatio(double slope);

/** The same line beyond the slopes that were measured; slope > 0. */
double vortexRatioLine(double slope);

}
