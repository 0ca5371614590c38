#pragma once

#include "sim/Execution.h"
#include "sim/FoldStrips.h"
#include "sim/GaussianBeams.h"
#include "sim/RaySheets.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace swellray
{

/** How the waves of several sheets at one place make one height. */
enum class CombineRule
{
  Energy, ///< H^2 = sum H_i^2: irregular seas, whose phases are not known
  Phase,  ///< H = |sum H_i exp(i (S_i - m_i pi/2))|, m_i: caustics passed: one regular wave.
          ///< The two branches of a fold caustic are added by foldWave(), next to it by FoldStrips, which go on into
          ///< its dark side; around cusps and foci GaussianBeams have the place of both
};

/** What the sheets at one place amount to. */
struct CombinedWave
{
  double height = 0.0;        ///< m; NaN without a sheet, like the next two
  double directionFrom = 0.0; ///< nautical degrees, of the mean direction weighted by energy
  double wavelength = 0.0;    ///< m, of the mean wavenumber weighted by energy
  bool breaking = false;      ///< of the highest sheet
  bool lee = false;           ///< the highest sheet is a model of diffraction
  std::int32_t count = 0;     ///< sheets
};

/**
 * Combine sheets and, by CombineRule::Phase, strips along fold caustics, each in place of the two sheets that make it, and
 * beams around foci in place of all.
 * Where opposite waves have no mean direction that of the highest is taken.
 * (Phase shift of pi/2 a caustic: Ludwig 1966, Commun. Pure Appl. Math. 19, 215-250.)
 */
CombinedWave combineSheets(const WaveSheet* sheets, std::size_t count, CombineRule rule,
  const FoldShare* folds = nullptr, std::size_t foldCount = 0, const BeamShare* beams = nullptr);

/** Nodes of a map. */
struct MapGrid
{
  std::size_t columns = 0; ///< along x
  std::size_t rows = 0;    ///< along y
  glm::dvec2 origin{ 0.0 };
  glm::dvec2 spacing{ 1.0 }; ///< m, > 0
};

/** Combined waves at places: vectors with one entry a place; NaN, and 0 in those of whole numbers, where no ray came. */
struct RayMap
{
  std::vector<double> height;        ///< m
  std::vector<double> directionFrom; ///< nautical degrees
  std::vector<double> wavelength;    ///< m
  std::vector<std::uint8_t> breaking;
  std::vector<std::uint8_t> lee;
  std::vector<std::int32_t> count; ///< sheets of rays
};

/**
 * Waves at the nodes of a grid, x fastest.
 * @param depth one a node, m: none is given a wave where it is not above 0; null: all are
 * @throws std::invalid_argument where the grid has no nodes or a spacing not above 0
 */
RayMap mapRays(
  const RaySheets& sheets, const MapGrid& grid, const double* depth, CombineRule rule, const Execution& execution = {});

/** Waves at single places; `depth` as for mapRays. The value at a node of a map is the same. */
RayMap sampleRays(const RaySheets& sheets, const std::vector<glm::dvec2>& places, const double* depth, CombineRule rule,
  const Execution& execution = {});

}
