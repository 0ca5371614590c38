#include "bathymetry/UgridMesh.h"

#include "bathymetry/CrsChoice.h"
#include "bathymetry/FileGrid.h"
#include "bathymetry/MeshSpacing.h"
#include "bathymetry/QuietGdal.h"
#include "bathymetry/RasterSource.h"
#include "bathymetry/Text.h"
#include "bathymetry/Wkt.h"

#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <sstream>
#include <stdexcept>

namespace swellray
{

namespace
{

using Array = std::shared_ptr<GDALMDArray>;

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

std::string attribute(const GDALMDArray& array, const char* name)
{
  const auto found = array.GetAttribute(name);
  const char* value = found ? found->ReadAsString() : nullptr;
  return value ? value : "";
}

// All values of an array as they are stored.
std::vector<double> stored(const GDALMDArray& array)
{
  std::size_t size = 1;
  std::vector<GUInt64> start;
  std::vector<std::size_t> count;
  for (const auto& dimension : array.GetDimensions())
  {
    // A size that is only claimed takes no memory.
    const GUInt64 length = dimension->GetSize();
    if (length == 0 || length > MostNodes / size)
    {
      throw std::runtime_error("variable '" + array.GetName() + "' has no values, or more than " +
        std::to_string(MostNodes / 1000000) + " million");
    }
    start.push_back(0);
    count.push_back(static_cast<std::size_t>(length));
    size *= static_cast<std::size_t>(length);
  }
  std::vector<double> values(size);
  if (!array.Read(
        start.data(), count.data(), nullptr, nullptr, GDALExtendedDataType::Create(GDT_Float64), values.data()) ||
    QuietGdal::failed())
  {
    throw std::runtime_error(
      "variable '" + array.GetName() + "' cannot be read: " + QuietGdal::lastError("no reason given"));
  }
  return values;
}

// Values in the variable's unit, those marked as missing as NaN.
std::vector<double> valuesOf(const GDALMDArray& array)
{
  std::vector<double> values = stored(array);
  NoDataMark missing;
  bool has = false;
  const double mark = array.GetNoDataValueAsDouble(&has);
  missing.add(has ? mark : NotANumber, array.GetDataType().GetNumericDataType() == GDT_Float32);
  for (double& value : values)
  {
    value = missing(value) ? NotANumber : value * array.GetScale() + array.GetOffset();
  }
  return values;
}

bool isOn(const GDALMDArray& array, const GDALDimension& dimension)
{
  return array.GetDimensionCount() == 1 && array.GetDataType().GetClass() == GEDTC_NUMERIC &&
    array.GetDimensions()[0]->GetFullName() == dimension.GetFullName();
}

class Mesh
{
public:
  Mesh(std::shared_ptr<GDALGroup> group, const GDALMDArray& topology)
    : Group(std::move(group))
    , Topology(topology)
  {
  }

  Soundings read(const std::string& variable)
  {
    std::istringstream names(attribute(this->Topology, "node_coordinates"));
    std::string first;
    std::string second;
    names >> first >> second;
    this->X = this->open(first);
    this->Y = this->open(second);
    if (isNorthward(*this->X))
    {
      std::swap(this->X, this->Y);
    }
    if (this->X->GetDimensionCount() != 1 || !isOn(*this->Y, *this->X->GetDimensions()[0]))
    {
      throw std::runtime_error("its mesh has no two coordinates on its nodes");
    }
    const Array values = this->choose(variable);
    Soundings soundings;
    soundings.driver = "UGRID mesh";
    soundings.variable = values->GetName();
    soundings.x = valuesOf(*this->X);
    soundings.y = valuesOf(*this->Y);
    soundings.z = valuesOf(*values);
    for (std::size_t i = 0; i < soundings.size(); ++i)
    {
      if (!std::isfinite(soundings.x[i] + soundings.y[i]))
      {
        throw std::runtime_error("node " + std::to_string(i + 1) + " of its mesh has no place");
      }
    }
    soundings.vertical.positive = attribute(*values, "positive");
    soundings.vertical.standardName = attribute(*values, "standard_name");
    soundings.vertical.units = values->GetUnit();
    this->readCells(soundings);
    this->readCrs(*values, soundings);
    const double spacing = fineSpacing(soundings, !soundings.crs.empty() && isLongitudes("", soundings.crs));
    if (spacing > 0.0)
    {
      soundings.spacing = spacing;
    }
    return soundings;
  }

private:
  static bool isNorthward(const GDALMDArray& array)
  {
    const std::string name = plain(attribute(array, "standard_name"));
    return name == "latitude" || name == "projection_y_coordinate" ||
      plain(array.GetUnit()).compare(0, 13, "degrees_north") == 0;
  }

  Array open(const std::string& name) const
  {
    Array found = name.empty() ? nullptr : this->Group->OpenMDArray(name);
    if (!found || found->GetDataType().GetClass() != GEDTC_NUMERIC)
    {
      throw std::runtime_error("its mesh names a variable '" + name + "' that is not there");
    }
    return found;
  }

  Array choose(const std::string& variable) const
  {
    std::vector<Array> candidates;
    std::string names;
    for (const std::string& name : this->Group->GetMDArrayNames())
    {
      const Array array = this->Group->OpenMDArray(name);
      if (array && isOn(*array, *this->X->GetDimensions()[0]) && name != this->X->GetName() &&
        name != this->Y->GetName())
      {
        candidates.push_back(array);
        names += (names.empty() ? "" : ", ") + name;
      }
    }
    const auto only = [&candidates](const auto& accepts)
    {
      const auto found = std::find_if(candidates.begin(), candidates.end(), accepts);
      const bool single = found != candidates.end() && std::none_of(found + 1, candidates.end(), accepts);
      return single ? *found : Array();
    };
    const auto isSeafloor = [](const Array& a) { return isElevationName(attribute(*a, "standard_name")); };
    Array chosen = variable.empty() ? only([](const Array&) { return true; })
                                    : only([&](const Array& a) { return a->GetName() == variable; });
    if (!chosen)
    {
      chosen = variable.empty() ? only(isSeafloor)
                                : only([&](const Array& a) { return attribute(*a, "standard_name") == variable; });
    }
    if (!chosen)
    {
      throw std::runtime_error(
        (variable.empty() ? "which variable on the nodes of its mesh is meant? Choose with --variable: "
                          : "no variable '" + variable + "' lies on the nodes of its mesh; there are: ") +
        (names.empty() ? "none" : names));
    }
    return chosen;
  }

  void readCells(Soundings& soundings) const
  {
    const Array faces = this->open(attribute(this->Topology, "face_node_connectivity"));
    if (faces->GetDimensionCount() != 2)
    {
      throw std::runtime_error("the faces of its mesh are no table of faces and corners");
    }
    const bool turned = attribute(this->Topology, "face_dimension") == faces->GetDimensions()[1]->GetName();
    const std::vector<double> table = stored(*faces);
    const std::size_t corners = faces->GetDimensions()[turned ? 0 : 1]->GetSize();
    const std::size_t count = table.size() / corners;
    const auto start = faces->GetAttribute("start_index");
    const double first = start ? start->ReadAsDouble() : 0.0;
    const auto nodes = static_cast<double>(soundings.size());
    soundings.cellOffsets.push_back(0);
    for (std::size_t face = 0; face < count; ++face)
    {
      const std::size_t begin = soundings.cellNodes.size();
      for (std::size_t corner = 0; corner < corners; ++corner)
      {
        // Faces with fewer corners are filled up with a mark that is no node.
        const double node = table[turned ? corner * count + face : face * corners + corner] - first;
        if (node >= 0.0 && node < nodes)
        {
          soundings.cellNodes.push_back(static_cast<std::uint32_t>(node));
        }
      }
      if (soundings.cellNodes.size() < begin + 3)
      {
        soundings.cellNodes.resize(begin);
        continue;
      }
      soundings.cellOffsets.push_back(soundings.cellNodes.size());
    }
    if (soundings.cellOffsets.size() == 1)
    {
      throw std::runtime_error("its mesh has no face with three nodes or more");
    }
  }

  void readCrs(const GDALMDArray& values, Soundings& soundings) const
  {
    if (const auto crs = values.GetSpatialRef())
    {
      soundings.crs = wktOf(*crs);
    }
    else if (plain(attribute(*this->X, "standard_name")) == "longitude" ||
      plain(this->X->GetUnit()).compare(0, 12, "degrees_east") == 0)
    {
      soundings.crs = "EPSG:4326";
      soundings.crsSource = "nodes in degrees";
    }
  }

  std::shared_ptr<GDALGroup> Group;
  const GDALMDArray& Topology;
  Array X;
  Array Y;
};

}

std::optional<Soundings> readUgridMesh(const std::string& path, const std::string& variable)
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
  const char* const all[] = { "SHOW_ZERO_DIM=YES", nullptr };
  for (const std::string& name : root->GetMDArrayNames(const_cast<CSLConstList>(all)))
  {
    const Array array = root->OpenMDArray(name);
    if (array && attribute(*array, "cf_role") == "mesh_topology")
    {
      const auto dimension = array->GetAttribute("topology_dimension");
      if (!dimension || dimension->ReadAsInt() == 2)
      {
        QuietGdal::forget();
        return Mesh(root, *array).read(variable);
      }
    }
  }
  return {};
}

}
