#include "bathymetry/VerticalMeaning.h"

#include "bathymetry/Text.h"

#include <stdexcept>

namespace swellray
{

namespace
{

// CF standard names: the table's names for the bed and for heights all contain one of these words.
std::string directionOfName(const std::string& standardName)
{
  const std::string name = plain(standardName);
  const auto has = [&name](const char* word) { return name.find(word) != std::string::npos; };
  if (name == "depth" || has("depth_below") || has("sea_floor_depth"))
  {
    return "down";
  }
  if (has("altitude") || name == "height" || has("height_above"))
  {
    return "up";
  }
  return {};
}

}

bool isElevationName(const std::string& standardName)
{
  return !directionOfName(standardName).empty();
}

double metresPerUnit(const std::string& unit)
{
  struct Unit
  {
    const char* name;
    double metres;
  };
  static constexpr Unit units[] = { { "m", 1.0 }, { "metre", 1.0 }, { "metres", 1.0 }, { "meter", 1.0 },
    { "meters", 1.0 }, { "mm", 0.001 }, { "millimetre", 0.001 }, { "millimeter", 0.001 }, { "millimetres", 0.001 },
    { "millimeters", 0.001 }, { "cm", 0.01 }, { "centimetre", 0.01 }, { "centimeter", 0.01 }, { "centimetres", 0.01 },
    { "centimeters", 0.01 }, { "dm", 0.1 }, { "decimetre", 0.1 }, { "decimeter", 0.1 }, { "decimetres", 0.1 },
    { "decimeters", 0.1 }, { "km", 1000.0 }, { "kilometre", 1000.0 }, { "kilometer", 1000.0 }, { "kilometres", 1000.0 },
    { "kilometers", 1000.0 }, { "ft", 0.3048 }, { "foot", 0.3048 }, { "feet", 0.3048 }, { "us-ft", 1200.0 / 3937.0 },
    { "ftus", 1200.0 / 3937.0 }, { "us survey foot", 1200.0 / 3937.0 }, { "us survey feet", 1200.0 / 3937.0 },
    { "us_survey_foot", 1200.0 / 3937.0 }, { "fathom", 1.8288 }, { "fathoms", 1.8288 }, { "fm", 1.8288 },
    { "yard", 0.9144 }, { "yards", 0.9144 }, { "yd", 0.9144 } };
  // "meters above MSL" and "m (NAVD88)" begin with the unit; the longest name that fits wins.
  const std::string words = plain(unit);
  double metres = 0.0;
  std::size_t longest = 0;
  for (const Unit& candidate : units)
  {
    const std::string name = candidate.name;
    const bool fits = words.compare(0, name.size(), name) == 0 &&
      (words.size() == name.size() || std::string(" ,(;").find(words[name.size()]) != std::string::npos);
    if (fits && name.size() > longest)
    {
      longest = name.size();
      metres = candidate.metres;
    }
  }
  return metres;
}

VerticalMeaning understandVertical(const VerticalMetadata& metadata, Positive positive)
{
  VerticalMeaning meaning;

  const std::string attribute = plain(metadata.positive);
  const std::string named = directionOfName(metadata.standardName);
  std::string direction;
  if (positive != Positive::Auto)
  {
    direction = positive == Positive::Down ? "down" : "up";
    meaning.signSource = "as asked";
  }
  else if (attribute == "up" || attribute == "down")
  {
    if (!named.empty() && named != attribute)
    {
      throw std::runtime_error("its metadata contradict each other: attribute positive is '" + attribute +
        "', but standard name '" + metadata.standardName + "' counts " + named + "; say --positive up or down");
    }
    direction = attribute;
    meaning.signSource = "positive attribute";
  }
  else if (!named.empty())
  {
    direction = named;
    meaning.signSource = "standard name " + metadata.standardName;
  }
  else if (!metadata.rule.empty())
  {
    direction = metadata.rule;
    meaning.signSource = metadata.ruleSource;
  }
  else
  {
    direction = "up";
    meaning.signSource = "assumed";
  }
  if (!attribute.empty() && attribute != "up" && attribute != "down")
  {
    meaning.notes.push_back("attribute positive is '" + metadata.positive + "', neither up nor down: not used");
  }
  meaning.sign = direction == "up" ? "elevation, positive up" : "depth, positive down";

  double metres = 1.0;
  if (metadata.units.empty())
  {
    meaning.units = "metres";
    meaning.unitsSource = "assumed";
  }
  else if (const double known = metresPerUnit(metadata.units); known > 0.0)
  {
    metres = known;
    meaning.units = known == 1.0 ? "metres" : metadata.units + " (" + text(known, 10) + " m)";
    meaning.unitsSource = metadata.unitsSource.empty() ? "units '" + metadata.units + "'" : metadata.unitsSource;
  }
  else
  {
    meaning.units = "metres";
    meaning.unitsSource = "assumed";
    meaning.notes.push_back("unit '" + metadata.units + "' is no length that is known: values taken as metres");
  }
  meaning.factor = direction == "up" ? metres : -metres;
  return meaning;
}

}
