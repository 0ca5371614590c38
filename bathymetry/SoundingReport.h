#pragma once

#include <glm/vec2.hpp>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace swellray
{

/** How soundings were brought to a grid, and how good it is. */
struct SoundingReport
{
  /** Elevations foretold at soundings that were left out, against theirs. */
  struct LeftOut
  {
    std::size_t count = 0;   ///< soundings; 0: not measured
    double rms = 0.0;        ///< m
    double largest = 0.0;    ///< m
    glm::dvec2 place{ 0.0 }; ///< of the largest, file coordinates
  };

  std::size_t count = 0;   ///< soundings of the file with a value
  std::size_t missing = 0; ///< places of the file without a value
  std::size_t used = 0;    ///< places that the grid was made of
  std::size_t cells = 0;   ///< cells of the mesh, 0: none

  std::size_t duplicates = 0;   ///< soundings at the very place of another; each place got their mean
  double duplicateSpread = 0.0; ///< largest difference of values at one place, m

  std::size_t outliers = 0;            ///< soundings far off what their natural neighbours say
  bool outliersDropped = false;        ///< they took no part
  double worstOutlier = 0.0;           ///< largest difference from the neighbours, m
  glm::dvec2 worstOutlierPlace{ 0.0 }; ///< file coordinates

  double meanDistance = 0.0;  ///< root of the area covered over the number of places, m
  double spacing = 0.0;       ///< of the nodes, m
  bool spacingChosen = false; ///< not asked for
  double maxGap = 0.0;        ///< m; infinite: no limit
  bool maxGapChosen = false;  ///< not asked for
  std::size_t holes = 0;      ///< nodes without an elevation

  LeftOut single;     ///< one sounding left out at a time, all in turn
  LeftOut tenth;      ///< a tenth of them left out at a time, ten times, in patches
  double patch = 0.0; ///< side of these, m: the usual gap between soundings

  /** One line: how many soundings, the grid, its holes and error. */
  std::string summary() const;

  /** The report as label and text, in the order in which it is to be printed. */
  std::vector<std::pair<std::string, std::string>> lines() const;
};

}
