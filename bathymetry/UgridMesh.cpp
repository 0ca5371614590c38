#include "bathymetry/UgridMesh.h"

#include "bathymetry/CrsChoice.h"
#include "bathymetry/MeshSpacing.h"
#include "bathymetry/NetcdfArrays.h"
#include "bathymetry/QuietGdal.h"
#include "bathymetry/Text.h"
#include "bathymetry/Wkt.h"

#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>
#include <stdexcept>

namespace swellray
{

namespace
{

using Array = std::shared_ptr<GDALMDArray>;

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
    this->findNodes();
    const Array faces = this->open(attribute(this->Topology, "face_node_connectivity"));
    if (faces->GetDimensionCount() != 2)
    {
      throw std::runtime_error("the faces of its mesh are no table of faces and corners");
    }
    this->Turned = attribute(this->Topology, "face_dimension") == faces->GetDimensions()[1]->GetName();
    const auto nodeDimension = this->X->GetDimensions()[0];
    const auto faceDimension = faces->GetDimensions()[this->Turned ? 1 : 0];
    const Array values = this->choose(variable, *nodeDimension, *faceDimension);
    const bool onFaces = !isOn(*values, *nodeDimension);
    Soundings soundings;
    soundings.driver = "UGRID mesh";
    soundings.variable = values->GetName();
    soundings.x = readAll(*this->X);
    soundings.y = readAll(*this->Y);
    for (std::size_t i = 0; i < soundings.x.size(); ++i)
    {
      if (!std::isfinite(soundings.x[i] + soundings.y[i]))
      {
        throw std::runtime_error("node " + std::to_string(i + 1) + " of its mesh has no place");
      }
    }
    std::vector<double> z = readAll(*values);
    const std::vector<std::size_t> kept = this->readCells(*faces, soundings);
    if (onFaces)
    {
      this->moveToFaces(soundings, std::move(z), kept);
    }
    else
    {
      soundings.z = std::move(z);
    }
    soundings.vertical.positive = attribute(*values, "positive");
    soundings.vertical.standardName = attribute(*values, "standard_name");
    soundings.vertical.units = values->GetUnit();
    this->readCrs(*values, soundings);
    const double spacing = fineSpacing(soundings, !soundings.crs.empty() && isLongitudes("", soundings.crs));
    if (spacing > 0.0)
    {
      soundings.spacing = spacing;
    }
    return soundings;
  }

private:
  void findNodes()
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
  }

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

  // Variables that say where nodes and faces lie, which are none that could be meant.
  bool isCoordinate(const std::string& name) const
  {
    std::istringstream names(attribute(this->Topology, "face_coordinates"));
    std::string other;
    while (names >> other)
    {
      if (other == name)
      {
        return true;
      }
    }
    return name == this->X->GetName() || name == this->Y->GetName();
  }

  Array choose(
    const std::string& variable, const GDALDimension& nodeDimension, const GDALDimension& faceDimension) const
  {
    std::vector<Array> candidates;
    std::string names;
    for (const std::string& name : this->Group->GetMDArrayNames())
    {
      const Array array = this->Group->OpenMDArray(name);
      if (array && (isOn(*array, nodeDimension) || isOn(*array, faceDimension)) && !this->isCoordinate(name))
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
    Array chosen;
    if (variable.empty())
    {
      chosen = only(isSeafloor);
      chosen = chosen ? chosen : only([&](const Array& a) { return isOn(*a, nodeDimension); });
      chosen = chosen || candidates.size() > 1 ? chosen : only([](const Array&) { return true; });
    }
    else
    {
      chosen = only([&](const Array& a) { return a->GetName() == variable; });
      chosen = chosen ? chosen : only([&](const Array& a) { return attribute(*a, "standard_name") == variable; });
    }
    if (!chosen)
    {
      throw std::runtime_error(
        (variable.empty() ? "which variable on the nodes or faces of its mesh is meant? Choose with --variable: "
                          : "no variable '" + variable + "' lies on the nodes or faces of its mesh; there are: ") +
        (names.empty() ? "none" : names));
    }
    return chosen;
  }

  // The cells; returns which of the faces they are.
  std::vector<std::size_t> readCells(const GDALMDArray& faces, Soundings& soundings) const
  {
    const std::vector<double> table = readStored(faces);
    const std::size_t corners = faces.GetDimensions()[this->Turned ? 0 : 1]->GetSize();
    const std::size_t count = table.size() / corners;
    std::vector<std::size_t> kept;
    const auto start = faces.GetAttribute("start_index");
    const double first = start ? start->ReadAsDouble() : 0.0;
    const auto nodes = static_cast<double>(soundings.x.size());
    soundings.cellOffsets.push_back(0);
    for (std::size_t face = 0; face < count; ++face)
    {
      const std::size_t begin = soundings.cellNodes.size();
      for (std::size_t corner = 0; corner < corners; ++corner)
      {
        // Faces with fewer corners are filled up with a mark that is no node.
        const double node = table[this->Turned ? corner * count + face : face * corners + corner] - first;
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
      kept.push_back(face);
    }
    if (kept.empty())
    {
      throw std::runtime_error("its mesh has no face with three nodes or more");
    }
    return kept;
  }

  // Values of the faces lie where face_coordinates says, otherwise at their centroids; nodes are then only corners.
  void moveToFaces(Soundings& soundings, std::vector<double>&& z, const std::vector<std::size_t>& kept) const
  {
    soundings.cornerX = std::move(soundings.x);
    soundings.cornerY = std::move(soundings.y);
    soundings.x.clear();
    soundings.y.clear();
    std::istringstream names(attribute(this->Topology, "face_coordinates"));
    std::string first;
    std::string second;
    std::vector<double> x;
    std::vector<double> y;
    if (names >> first >> second)
    {
      const Array one = this->open(first);
      const Array other = this->open(second);
      x = readAll(isNorthward(*one) ? *other : *one);
      y = readAll(isNorthward(*one) ? *one : *other);
      if (x.size() != z.size() || y.size() != z.size())
      {
        throw std::runtime_error("its face_coordinates '" + first + " " + second + "' are not as many as its faces");
      }
    }
    for (std::size_t cell = 0; cell < kept.size(); ++cell)
    {
      const std::size_t face = kept[cell];
      const glm::dvec2 centre = x.empty() ? centroid(soundings, cell) : glm::dvec2(x[face], y[face]);
      soundings.add(centre.x, centre.y, z[face]);
    }
    soundings.notes.emplace_back("its values are those of faces: they lie in the middle of each");
  }

  // Centroid of the area of a cell; the mean of its corners where it has none.
  static glm::dvec2 centroid(const Soundings& mesh, std::size_t cell)
  {
    const std::size_t begin = mesh.cellOffsets[cell];
    const std::size_t end = mesh.cellOffsets[cell + 1];
    const glm::dvec2 origin(mesh.cornerX[mesh.cellNodes[begin]], mesh.cornerY[mesh.cellNodes[begin]]);
    const auto corner = [&](std::size_t i)
    { return glm::dvec2(mesh.cornerX[mesh.cellNodes[i]], mesh.cornerY[mesh.cellNodes[i]]) - origin; };
    glm::dvec2 mean(0.0);
    glm::dvec2 moment(0.0);
    double twice = 0.0;
    for (std::size_t i = begin; i < end; ++i)
    {
      const glm::dvec2 a = corner(i);
      const glm::dvec2 b = corner(i + 1 < end ? i + 1 : begin);
      const double cross = a.x * b.y - b.x * a.y;
      mean += a / static_cast<double>(end - begin);
      moment += cross * (a + b) / 3.0;
      twice += cross;
    }
    return origin + (twice != 0.0 ? moment / twice : mean);
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
  bool Turned = false; // corners vary slowest
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
