#pragma once

#include "bathymetry/SeafloorOptions.h"

#include <string>
#include <vector>

namespace swellray
{

/** What a file says about its values; empty where it says nothing. */
struct VerticalMetadata
{
  std::string positive;     ///< attribute `positive`
  std::string standardName; ///< CF standard name
  std::string units;        ///< e.g. "m", "feet", "fathoms"
  std::string rule;         ///< "up" or "down" where the format or a vertical CRS fixes it
  std::string ruleSource;   ///< what fixes it
  std::string unitsSource;  ///< what fixes the unit where the format does, e.g. "SWAN's unit"
};

/** No place on Earth is further from the sea's level, m. */
constexpr double FarthestElevation = 12000.0;

/** How to make elevations in metres, positive up, of a file's values: elevation = factor * value. */
struct VerticalMeaning
{
  double factor = 1.0;    ///< metres a unit, negative where the values are depths
  std::string sign;       ///< "elevation, positive up" or "depth, positive down"
  std::string signSource; ///< what it was taken from, e.g. "positive attribute", "assumed"
  std::string units;      ///< as understood, e.g. "feet (0.3048 m)"
  std::string unitsSource;
  std::vector<std::string> notes;
};

/**
 * Sign and unit of a file's values. A variable's name never decides.
 * @throws std::runtime_error where the `positive` attribute and the standard name contradict each other and the
 *   caller does not decide
 */
VerticalMeaning understandVertical(const VerticalMetadata& metadata, Positive positive);

/** True for a CF standard name of the bed's elevation or depth. */
bool isElevationName(const std::string& standardName);

/** Metres a unit of length, 0 where the name is not known. */
double metresPerUnit(const std::string& unit);

}
