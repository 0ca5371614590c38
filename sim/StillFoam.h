#pragma once

#include "sim/SurfaceFunction.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace swellray
{

/**
 * Foam on still water, at places of one's own: nodes of a grid, as Jeschke et al. 2003 (section 3.1) keep it. What does not
 * change in time is found once, so that a frame only asks when waves have passed.
 *
 * A place has the foam that the undisturbed surface has there (SurfaceFunction::foam), but for that on the fronts of waves,
 * which stand over it: the largest of all waves and of all sheets that cross.
 */
class StillFoam
{
public:
  /**
   * The waves need not outlive this.
   * @param waves of the sea, each traced on its own
   * @param places m
   * @throws std::invalid_argument without a wave
   */
  StillFoam(const std::vector<const SurfaceFunction*>& waves, const std::vector<glm::dvec2>& places,
    const Execution& execution = {});

  /**
   * @param time s
   * @param life as FoamOptions::life
   * @param variation as WaveSection::variation
   * @param foam one entry a place, 0 to 1; NaN where no wave comes
   * @throws std::invalid_argument on a bad life
   */
  void at(double time, double life, double variation, float* foam, const Execution& execution = {}) const;

  /** Places at which a wave may leave foam. */
  std::size_t foamingCount() const { return this->Foaming; }

private:
  // A sheet with broken waves over a place: corners as SheetPlace, their weight times their share of foam.
  struct Sheet
  {
    std::uint32_t wave = 0;
    double phase = 0.0;
    double groupTime = 0.0;
    double brokenShare = 1.0;
    std::array<double, 3> weight{};
    std::array<double, 3> breakingPhase{};
    std::array<double, 3> launchParameter{};
  };

  std::vector<FoamOptions> Waves;
  std::vector<std::uint8_t> Covered; // one a place
  std::vector<std::size_t> Offsets;  // one a place, and one more
  std::vector<Sheet> Sheets;
  std::size_t Foaming = 0;
};

}
