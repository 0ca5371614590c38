#include "bathymetry/NetcdfCurvilinear.h"

#include "bathymetry/NetcdfArrays.h"
#include "bathymetry/QuietGdal.h"
#include "bathymetry/Text.h"
#include "bathymetry/Wkt.h"

#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace swellray
{

namespace
{

using Dimension = std::shared_ptr<GDALDimension>;

// Names of the two dimensions along which a variable has more than one value, in its order; others have one.
std::vector<std::string> planeOf(const GDALMDArray& array)
{
  std::vector<std::string> wide;
  for (const Dimension& dimension : array.GetDimensions())
  {
    if (dimension->GetSize() > 1)
    {
      wide.push_back(dimension->GetFullName());
    }
  }
  return wide.size() == 2 ? wide : std::vector<std::string>();
}

bool isSamePlane(const std::vector<std::string>& a, const std::vector<std::string>& b)
{
  return a == b || (a[0] == b[1] && a[1] == b[0]);
}

// As axisLetter(), and by the names that models give: nav_lon, lat_rho, globalx.
char letterOf(const GDALMDArray& array)
{
  if (const char letter = axisLetter(array))
  {
    return letter;
  }
  const std::string name = plain(array.GetName());
  const auto has = [&name](const char* word) { return name.find(word) != std::string::npos; };
  const auto ends = [&name](char c) { return name.front() == c || name.back() == c; };
  return name.empty() ? 0 : has("lon") || ends('x') ? 'x' : has("lat") || ends('y') ? 'y' : 0;
}

struct Candidate
{
  const NetcdfArray* values = nullptr;
  const NetcdfArray* x = nullptr;
  const NetcdfArray* y = nullptr;
};

class Reader
{
public:
  explicit Reader(const std::vector<NetcdfArray>& all)
    : All(all)
  {
  }

  std::optional<ModelGrid> read(const std::string& variable)
  {
    std::vector<Candidate> candidates;
    for (const NetcdfArray& one : this->All)
    {
      Candidate candidate;
      if (isNumeric(*one.array) && !planeOf(*one.array).empty() && this->findPlaces(one, candidate))
      {
        candidates.push_back(candidate);
      }
    }
    // What says where the others lie is none of them.
    const auto isPlace = [&candidates](const Candidate& c)
    {
      return std::any_of(candidates.begin(), candidates.end(),
        [&c](const Candidate& other) { return c.values == other.x || c.values == other.y; });
    };
    std::vector<Candidate> values;
    std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(values),
      [&isPlace](const Candidate& c) { return !isPlace(c); });
    if (values.empty())
    {
      return {};
    }
    const bool isElsewhere = std::any_of(this->All.begin(), this->All.end(),
      [&](const NetcdfArray& a) { return a.name == variable && this->isRegular(*a.array); });
    return isElsewhere ? std::optional<ModelGrid>() : makeGrid(choose(values, variable));
  }

private:
  // True where each of its dimensions has a coordinate variable that says which axis it is: a regular grid.
  bool isRegular(const GDALMDArray& array) const
  {
    std::string letters;
    for (const std::string& dimension : planeOf(array))
    {
      for (const NetcdfArray& other : this->All)
      {
        const auto& own = other.array->GetDimensions();
        const char letter = own.size() == 1 && own[0]->GetFullName() == dimension ? axisLetter(*other.array) : 0;
        letters += letter ? std::string(1, letter) : "";
      }
    }
    return letters.find('x') != std::string::npos && letters.find('y') != std::string::npos;
  }

  // True where each dimension has a variable of its own, if only a count.
  bool isCounted(const std::vector<std::string>& plane) const
  {
    return std::all_of(plane.begin(), plane.end(),
      [this](const std::string& dimension)
      {
        return std::any_of(this->All.begin(), this->All.end(),
          [&dimension](const NetcdfArray& a)
          {
            const auto& own = a.array->GetDimensions();
            return own.size() == 1 && own[0]->GetFullName() == dimension && own[0]->GetName() == a.array->GetName();
          });
      });
  }

  bool findPlaces(const NetcdfArray& values, Candidate& candidate) const
  {
    const std::vector<std::string> plane = planeOf(*values.array);
    if (this->isRegular(*values.array))
    {
      return false;
    }
    std::vector<const NetcdfArray*> named;
    std::istringstream words(attribute(*values.array, "coordinates"));
    for (std::string word; words >> word;)
    {
      const auto found = std::find_if(
        this->All.begin(), this->All.end(), [&word](const NetcdfArray& a) { return a.array->GetName() == word; });
      if (found != this->All.end())
      {
        named.push_back(&*found);
      }
    }
    // Names alone tell coordinates only where nothing else could be meant.
    const bool byName = !named.empty() || !this->isCounted(plane);
    if (named.empty())
    {
      for (const NetcdfArray& other : this->All)
      {
        named.push_back(&other);
      }
    }
    candidate.values = &values;
    for (const NetcdfArray* other : named)
    {
      const std::vector<std::string> own = planeOf(*other->array);
      if (other == &values || !isNumeric(*other->array) || own.empty() || !isSamePlane(own, plane))
      {
        continue;
      }
      const char letter = byName ? letterOf(*other->array) : axisLetter(*other->array);
      const NetcdfArray*& place = letter == 'x' ? candidate.x : candidate.y;
      if (letter != 0 && (!place || this->isBetter(*other, *place)))
      {
        place = other;
      }
    }
    return candidate.x && candidate.y;
  }

  // Longitude and latitude before coordinates of a plane beside them, attributes before names.
  static bool isBetter(const NetcdfArray& one, const NetcdfArray& other)
  {
    const auto rank = [](const NetcdfArray& a)
    { return (axisLetter(*a.array) ? 1 : 0) + (isDegrees(unitOf(*a.array)) ? 2 : 0); };
    return rank(one) > rank(other);
  }

  static Candidate choose(const std::vector<Candidate>& all, const std::string& variable)
  {
    std::string names;
    for (const Candidate& candidate : all)
    {
      names += (names.empty() ? "" : ", ") + candidate.values->name;
    }
    const auto only = [&all](const auto& accepts) -> std::optional<Candidate>
    {
      const auto found = std::find_if(all.begin(), all.end(), accepts);
      const bool single = found != all.end() && std::none_of(found + 1, all.end(), accepts);
      return single ? std::optional<Candidate>(*found) : std::nullopt;
    };
    const auto standardName = [](const Candidate& c) { return attribute(*c.values->array, "standard_name"); };
    std::optional<Candidate> chosen = variable.empty()
      ? only([](const Candidate&) { return true; })
      : only([&](const Candidate& c) { return c.values->name == variable; });
    if (!chosen)
    {
      chosen = only([&](const Candidate& c)
        { return variable.empty() ? isElevationName(standardName(c)) : standardName(c) == variable; });
    }
    if (!chosen)
    {
      throw std::runtime_error(
        (variable.empty() ? "it has several variables on its curvilinear grid; choose one with --variable: "
                          : "it has no variable '" + variable + "' on its curvilinear grid; there are: ") +
        names);
    }
    return *chosen;
  }

  // Values of a coordinate in the order of the values' rows and columns.
  static std::vector<double> inOrder(
    const GDALMDArray& coordinate, const std::vector<std::string>& plane, std::size_t columns, std::size_t rows)
  {
    std::vector<double> read = readAll(coordinate);
    if (planeOf(coordinate) == plane)
    {
      return read;
    }
    std::vector<double> turned(read.size());
    for (std::size_t row = 0; row < rows; ++row)
    {
      for (std::size_t column = 0; column < columns; ++column)
      {
        turned[row * columns + column] = read[column * rows + row];
      }
    }
    return turned;
  }

  static ModelGrid makeGrid(const Candidate& chosen)
  {
    const GDALMDArray& array = *chosen.values->array;
    const std::vector<std::string> plane = planeOf(array);
    ModelGrid grid;
    grid.format = "netCDF, curvilinear";
    grid.variable = chosen.values->name;
    std::vector<std::size_t> sizes;
    for (const Dimension& dimension : array.GetDimensions())
    {
      if (dimension->GetSize() > 1)
      {
        sizes.push_back(static_cast<std::size_t>(dimension->GetSize()));
      }
    }
    grid.values = readAll(array);
    grid.rows = sizes[0];
    grid.columns = sizes[1];
    std::vector<double> x = inOrder(*chosen.x->array, plane, grid.columns, grid.rows);
    std::vector<double> y = inOrder(*chosen.y->array, plane, grid.columns, grid.rows);
    const bool degrees = isDegrees(unitOf(*chosen.x->array)) && isDegrees(unitOf(*chosen.y->array));
    readCrs(array, degrees, grid);
    if (degrees)
    {
      countOn(x);
    }
    convert(x, *chosen.x, grid);
    convert(y, *chosen.y, grid);
    grid.places.reserve(x.size());
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      grid.places.emplace_back(x[i], y[i]);
    }
    grid.vertical.positive = attribute(array, "positive");
    grid.vertical.standardName = attribute(array, "standard_name");
    grid.vertical.units = unitOf(array);
    grid.notes.push_back("places from '" + chosen.x->name + "' and '" + chosen.y->name + "'");
    grid.makeRegular();
    return grid;
  }

  // A mapping of the grid's own plane, of a turned pole too, is none of longitude and latitude.
  static void readCrs(const GDALMDArray& array, bool degrees, ModelGrid& grid)
  {
    const auto crs = array.GetSpatialRef();
    if (crs && (!degrees || (crs->IsGeographic() && !crs->IsDerivedGeographic())))
    {
      grid.crs = wktOf(*crs);
    }
    if (grid.crs.empty() && degrees)
    {
      grid.crs = "EPSG:4326";
      grid.crsSource = "coordinates in degrees";
    }
  }

  // Coordinates in another unit than metres become metres where no CRS has a unit of its own.
  static void convert(std::vector<double>& values, const NetcdfArray& coordinate, ModelGrid& grid)
  {
    const double metres = metresPerUnit(unitOf(*coordinate.array));
    if (grid.crs.empty() && metres > 0.0 && metres != 1.0)
    {
      for (double& value : values)
      {
        value *= metres;
      }
      grid.notes.push_back(
        "coordinate '" + coordinate.name + "' converted from " + unitOf(*coordinate.array) + " to metres");
    }
  }

  // No node lies more than half a turn from the first.
  static void countOn(std::vector<double>& longitudes)
  {
    const auto first =
      std::find_if(longitudes.begin(), longitudes.end(), [](double value) { return std::isfinite(value); });
    if (first == longitudes.end())
    {
      return;
    }
    const double reference = *first;
    for (double& longitude : longitudes)
    {
      longitude = reference + std::remainder(longitude - reference, 360.0);
    }
  }

  const std::vector<NetcdfArray>& All;
};

}

std::optional<ModelGrid> readNetcdfCurvilinear(const std::string& path, const std::string& variable)
{
  const QuietGdal quiet;
  GDALDriverH driver = GDALIdentifyDriverEx(path.c_str(), GDAL_OF_MULTIDIM_RASTER, nullptr, nullptr);
  if (!driver || std::string(GDALGetDriverShortName(driver)) != "netCDF")
  {
    return {};
  }
  const std::unique_ptr<GDALDataset> dataset(
    GDALDataset::Open(path.c_str(), GDAL_OF_MULTIDIM_RASTER | GDAL_OF_READONLY));
  const std::shared_ptr<GDALGroup> root = dataset ? dataset->GetRootGroup() : nullptr;
  if (!root)
  {
    return {};
  }
  QuietGdal::forget();
  const std::vector<NetcdfArray> arrays = listArrays(*root);
  return Reader(arrays).read(variable);
}

}
