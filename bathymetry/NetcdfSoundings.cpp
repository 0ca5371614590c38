#include "bathymetry/NetcdfSoundings.h"

#include "bathymetry/NetcdfArrays.h"
#include "bathymetry/QuietGdal.h"
#include "bathymetry/Text.h"
#include "bathymetry/TextColumns.h"
#include "bathymetry/Wkt.h"

#include <gdal_priv.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace swellray
{

namespace
{

using Arrays = std::vector<const NetcdfArray*>;

// Variables along one dimension and the two of them that say where.
struct Survey
{
  Arrays others;
  const NetcdfArray* x = nullptr;
  const NetcdfArray* y = nullptr;
  bool degrees = false;
};

bool isLong(const GDALMDArray& array)
{
  const auto& dimensions = array.GetDimensions();
  return std::count_if(dimensions.begin(), dimensions.end(), [](const auto& d) { return d->GetSize() > 1; }) > 1;
}

Survey surveyAlong(const Arrays& arrays)
{
  Survey survey;
  const NetcdfArray* named[2][2] = {};
  for (const NetcdfArray* array : arrays)
  {
    const char letter = axisLetter(*array->array);
    const bool degrees = isDegrees(unitOf(*array->array));
    if (letter == 0)
    {
      survey.others.push_back(array);
      continue;
    }
    const NetcdfArray*& place = named[degrees ? 0 : 1][letter == 'x' ? 0 : 1];
    place = place ? place : array;
  }
  for (const bool degrees : { true, false })
  {
    const auto& pair = named[degrees ? 0 : 1];
    if (pair[0] && pair[1] && !survey.x)
    {
      survey.x = pair[0];
      survey.y = pair[1];
      survey.degrees = degrees;
    }
  }
  return survey;
}

std::string listOf(const Arrays& arrays)
{
  std::string names;
  for (const NetcdfArray* array : arrays)
  {
    names += (names.empty() ? "" : ", ") + array->name;
  }
  return names.empty() ? "none" : names;
}

const NetcdfArray& choose(const Survey& survey, const std::string& variable)
{
  const auto standardName = [](const NetcdfArray* array) { return attribute(*array->array, "standard_name"); };
  for (const NetcdfArray* array : survey.others)
  {
    if (!variable.empty() && (array->name == variable || standardName(array) == variable))
    {
      return *array;
    }
  }
  if (!variable.empty())
  {
    throw std::runtime_error(
      "it has no variable '" + variable + "' along its coordinates; there are: " + listOf(survey.others));
  }
  std::vector<std::string> names;
  for (const NetcdfArray* array : survey.others)
  {
    if (isElevationName(standardName(array)))
    {
      return *array;
    }
    names.push_back(array->name);
  }
  if (const std::optional<std::size_t> found = findValueName(names))
  {
    return *survey.others[*found];
  }
  if (survey.others.size() == 1)
  {
    return *survey.others.front();
  }
  throw std::runtime_error(
    "which of its variables holds the elevations or depths? Choose with --variable: " + listOf(survey.others));
}

// Coordinates in another unit than metres become metres where no CRS has a unit of its own.
void convert(std::vector<double>& values, const NetcdfArray& array, Soundings& soundings)
{
  const std::string unit = unitOf(*array.array);
  const double metres = metresPerUnit(unit);
  if (soundings.crs.empty() && metres > 0.0 && metres != 1.0)
  {
    for (double& value : values)
    {
      value *= metres;
    }
    soundings.notes.push_back("coordinate '" + array.name + "' converted from " + unit + " to metres");
  }
}

std::optional<Soundings> read(const std::vector<NetcdfArray>& all, GDALGroup& root, const std::string& variable)
{
  std::vector<std::pair<std::string, Arrays>> byDimension;
  for (const NetcdfArray& array : all)
  {
    if (!isNumeric(*array.array))
    {
      continue;
    }
    if (isLong(*array.array))
    {
      return {};
    }
    for (const auto& dimension : array.array->GetDimensions())
    {
      if (dimension->GetSize() < 2)
      {
        continue;
      }
      const std::string name = dimension->GetFullName();
      auto place = std::find_if(
        byDimension.begin(), byDimension.end(), [&name](const auto& entry) { return entry.first == name; });
      if (place == byDimension.end())
      {
        place = byDimension.insert(place, { name, {} });
      }
      place->second.push_back(&array);
    }
  }
  for (const auto& entry : byDimension)
  {
    const Survey survey = surveyAlong(entry.second);
    if (!survey.x || survey.others.empty())
    {
      continue;
    }
    const NetcdfArray& values = choose(survey, variable);
    Soundings soundings;
    soundings.driver = "netCDF, soundings";
    soundings.variable = values.name;
    if (const auto crs = values.array->GetSpatialRef())
    {
      soundings.crs = wktOf(*crs);
    }
    if (soundings.crs.empty() && survey.degrees)
    {
      soundings.crs = "EPSG:4326";
      soundings.crsSource = "coordinates in degrees";
    }
    soundings.x = readAll(*survey.x->array);
    soundings.y = readAll(*survey.y->array);
    soundings.z = readAll(*values.array);
    convert(soundings.x, *survey.x, soundings);
    convert(soundings.y, *survey.y, soundings);
    soundings.vertical.positive = attribute(*values.array, "positive");
    soundings.vertical.standardName = attribute(*values.array, "standard_name");
    soundings.vertical.units = unitOf(*values.array);
    const auto rule = root.GetAttribute("geospatial_vertical_positive");
    const char* const word = rule ? rule->ReadAsString() : nullptr;
    const std::string direction = plain(word ? word : "");
    if (direction == "up" || direction == "down")
    {
      soundings.vertical.rule = direction;
      soundings.vertical.ruleSource = "attribute geospatial_vertical_positive";
    }
    return soundings;
  }
  return {};
}

}

std::optional<Soundings> readNetcdfSoundings(const std::string& path, const std::string& variable)
{
  const QuietGdal quiet;
  const std::unique_ptr<GDALDataset> dataset(
    GDALDataset::Open(path.c_str(), GDAL_OF_MULTIDIM_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR));
  const std::shared_ptr<GDALGroup> root = dataset ? dataset->GetRootGroup() : nullptr;
  if (!root)
  {
    return {};
  }
  const std::vector<NetcdfArray> arrays = listArrays(*root);
  return read(arrays, *root, variable);
}

}
