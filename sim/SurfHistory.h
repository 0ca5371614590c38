#pragma once

#include "sim/Angles.h"
#include "sim/sections/WaveSection.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace swellray
{

/** One ray as plain arrays, an entry a point. */
struct HistoryRay
{
  std::size_t count = 0;
  const double* phase = nullptr;            ///< S, rad, increasing
  const double* height = nullptr;           ///< m
  const double* wavenumber = nullptr;       ///< rad/m
  const double* depth = nullptr;            ///< m
  const double* slope = nullptr;            ///< of the bed along the ray, positive where it rises
  const double* breakingDistance = nullptr; ///< m since breaking began
  const std::uint8_t* breaking = nullptr;   ///< 1 where the wave is broken
};

/** One stretch of a ray on which waves are broken. */
struct BreakingStretch
{
  double begin = 0.0;       ///< phase S where the trace says that breaking begins
  double end = 0.0;         ///< phase where the wave is whole again, or where the ray ends
  double index = 0.78;      ///< H/h where it begins
  double plungePhase = 0.0; ///< rad from there until a plunging crest has come down
};

/** How far a wave has broken at some phase of its ray. */
struct BreakingProgress
{
  double plunge = 0.0;       ///< as CrestState::plunge
  double plungeHeight = 0.0; ///< as CrestState::plungeHeight, m
  double reforming = 0.0;    ///< way since breaking ended over ReformingPhase, 0 to 1
};

/** What foam owes to the breaking at or before a phase of a ray. */
struct FoamOrigin
{
  double begin = 0.0;  ///< phase S where breaking began; NaN where it is over
  double share = 0.0;  ///< of foam that is left of it, 0 to 1
  double plunge = 0.0; ///< phase from there until the crest has come down, rad
};

/** Phase over which a wave that has stopped breaking takes the shape of a whole one: a wavelength, rad. */
constexpr double ReformingPhase = 2.0 * Pi;

/** Phase over which foam sets in: a sixteenth of a wave, rad. */
constexpr double FoamOnsetPhase = 2.0 * Pi / 16.0;

/** Share of a broken wave that is left when so much of ReformingPhase is behind it: smoothly from 1 to 0. */
double rollerShare(double reforming);

/** Way that a plunging crest travels from where it begins to break to where it comes down, over its height there:
 *  4.0 - 9.25 m on a bed of slope m, at least 1 (Galvin 1969, Breaker travel and choice of design wave height, J. Waterw.
 *  Harbors Div. 95). */
double plungeDistance(double slope);

/**
 * What becomes of waves along one ray: the stretches on which they are broken, and the state of a crest anywhere.
 *
 * Where the trace says that breaking ends, behind a bar, the wave forms again over a wavelength. In the balance of roller
 * energy (Svendsen 1984, Coast. Eng. 8; Nairn, Roelvink and Southgate 1990, Proc. 22nd ICCE) a roller that gets nothing
 * more from the wave falls as exp(-g beta x/C^2), beta about 0.1: at kh = 0.3 a ninth is left a wavelength on. Here it is
 * gone then, smoothly (rollerShare). A lip that was falling falls on, for as long again as it had. Where the wave breaks
 * anew before it is whole, it goes on from the state that it is in; all is a continuous function of the phase.
 */
class SurfHistory
{
public:
  SurfHistory() = default;

  /**
   * The arrays must outlive this, and so must a ray that it goes on from.
   * @param breakerIndex H/h at which waves would break that do not do so on this ray
   */
  SurfHistory(const HistoryRay& ray, double breakerIndex);

  /**
   * Go on from the ray beside which this one was inserted: what happened to its waves before this one begins.
   */
  void continueFrom(const SurfHistory& parent);

  /** In the order of their phase. */
  const std::vector<BreakingStretch>& stretches() const { return this->Stretches; }

  /** Stretch that contains a phase; null where waves do not break there. */
  const BreakingStretch* stretchAt(double phase) const;

  /** H/h over that at which the wave breaks next, at most 1; where it forms again, between this and the last. */
  double ripeness(double height, double depth, double phase) const;

  double firstPhase() const { return this->Ray.count > 0 ? this->Ray.phase[0] : 0.0; }

  /**
   * State of a crest at a phase of the ray, at its ends beyond them.
   * @param delay phase by which this wave breaks later than the trace says, rad, >= 0
   */
  CrestState crest(double phase, double delay) const;

  /**
   * How far such a wave has broken.
   * @param beginOf where it begins to break in a stretch, taken to be within that: BreakingStretch to phase, rad
   */
  template <class BeginOf>
  BreakingProgress progress(double phase, double delay, const BeginOf& beginOf) const;

  /** Put this into the state of a crest whose ripeness is that of a whole wave. */
  void setProgress(CrestState& crest, double phase, const BreakingProgress& progress) const;

  /** What is left of the breaking at a phase for foam. */
  FoamOrigin foam(double phase) const;

private:
  struct Place
  {
    std::size_t before = 0;
    std::size_t after = 0;
    double weight = 0.0; // of the later one
  };
  Place place(double phase) const;
  static double between(const double* values, const Place& place);
  double heightAt(double phase) const;
  bool staysBroken(const BreakingStretch& stretch) const;
  void breakOn(BreakingProgress& progress, const BreakingStretch& stretch, double begin, double delay, double to) const;
  static void reform(BreakingProgress& progress, const BreakingStretch& stretch, double to);

  template <class Visit>
  void forStretches(const Visit& visit) const;

  HistoryRay Ray;
  double BreakerIndex = 0.78;
  const SurfHistory* Parent = nullptr;
  std::vector<BreakingStretch> Past; // of rays that it goes on from, before it begins
  std::vector<BreakingStretch> Stretches;
};

template <class Visit>
void SurfHistory::forStretches(const Visit& visit) const
{
  for (const std::vector<BreakingStretch>* stretches : { &this->Past, &this->Stretches })
  {
    for (const BreakingStretch& stretch : *stretches)
    {
      if (!visit(stretch))
      {
        return;
      }
    }
  }
}

template <class BeginOf>
BreakingProgress SurfHistory::progress(double phase, double delay, const BeginOf& beginOf) const
{
  BreakingProgress progress;
  const BreakingStretch* last = nullptr;
  this->forStretches(
    [&](const BreakingStretch& stretch)
    {
      if (phase < stretch.begin)
      {
        return false;
      }
      const double begin = std::clamp(beginOf(stretch), stretch.begin, stretch.end);
      if (phase < begin)
      {
        return false;
      }
      if (last)
      {
        reform(progress, *last, begin);
      }
      this->breakOn(progress, stretch, begin, delay, phase);
      last = &stretch;
      return true;
    });
  if (last && phase > last->end && !this->staysBroken(*last))
  {
    reform(progress, *last, phase);
  }
  return progress;
}

/**
 * Delay of the breaking of wave n at a place of its crest, as a share of the largest, 0 to 1: three sines along the crest
 * whose places are drawn for each wave anew (Jeschke et al. 2003, section 3: slightly varying values for every wave).
 * @param launchParameter m along the incident crest
 * @param wavelength of the incident wave, m: the sines are about 1, 2.3 and 5.1 of it long
 */
double breakingDelay(std::uint64_t seed, std::int64_t wave, double launchParameter, double wavelength);

}
