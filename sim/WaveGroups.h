#pragma once

namespace swellray
{

/**
 * Waves that come in groups (future work of Peachey 1986): high ones in the middle of a group, low ones between two. The
 * traced height is that of the highest; the others have a share of it, by an envelope that goes at the group speed,
 *   share = lull + (1 - lull) (1 + cos(2 pi (t - tau)/(N T)))/2,
 * tau being the time that a group takes to the place: in deep water waves run through it from its back to its front.
 */
struct WaveGroups
{
  double waves = 0.0; ///< N that pass a place in a group, >= 2; 0: all waves are alike
  double lull = 0.3;  ///< height of the lowest over that of the highest, 0 to 1

  bool any() const { return this->waves > 0.0; }

  /**
   * Share of the traced height, lull to 1.
   * @param since t - tau: s since the middle of a group was there
   * @param period T of the waves, s
   */
  double share(double since, double period) const;

  bool operator==(const WaveGroups& other) const { return this->waves == other.waves && this->lull == other.lull; }

  /** @throws std::invalid_argument naming what is out of range */
  void validate() const;
};

/**
 * Share of a traced height that such a wave has where waves break: a lower one keeps its height until the breaking waves
 * are as low, and is then one of them.
 * @param share WaveGroups::share of the wave
 * @param broken traced height over that which shoaling alone would have given, 0 to 1
 */
inline double heldShare(double share, double broken)
{
  return share < broken ? share / broken : 1.0;
}

}
