#include "MeshSource.h"

#include "GeoreferenceField.h"
#include "XmlFile.h"
#include "bathymetry/ModelGrid.h"
#include "bathymetry/Text.h"

#include <vtkCell.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkStructuredGrid.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLStructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <limits>
#include <stdexcept>

namespace swellray
{

namespace
{

// Elevations of the points, and where these lie in the coordinates of their georeference.
struct Points
{
  std::vector<glm::dvec2> places;
  std::vector<double> elevations;
  std::string crs;
};

Points pointsOf(vtkPointSet* set)
{
  vtkDataArray* elevation = set->GetPointData()->GetArray("Elevation");
  if (elevation && elevation->GetNumberOfComponents() != 1)
  {
    throw std::runtime_error("its point array Elevation has " + std::to_string(elevation->GetNumberOfComponents()) +
      " components; it must have one");
  }
  const Georeference georeference = georeferenceOf(set);
  Points points;
  points.crs = georeference.crs();
  for (vtkIdType i = 0; i < set->GetNumberOfPoints(); ++i)
  {
    double p[3];
    set->GetPoint(i, p);
    points.places.push_back(georeference.toFile({ p[0], p[1] }));
    points.elevations.push_back(elevation ? elevation->GetTuple1(i) : p[2]);
  }
  return points;
}

VerticalMetadata elevations()
{
  VerticalMetadata vertical;
  vertical.units = "m";
  vertical.rule = "up";
  vertical.ruleSource = "the format";
  return vertical;
}

Bathymetry loadStructured(const std::string& path, const SeafloorOptions& options, const Execution& execution)
{
  vtkNew<vtkXMLStructuredGridReader> reader;
  readXmlFile(reader, path, "a VTK structured grid (.vts)");
  vtkStructuredGrid* set = reader->GetOutput();
  int size[3];
  set->GetDimensions(size);
  if (size[0] < 1 || size[1] < 1 || size[2] != 1)
  {
    throw std::runtime_error("it has " + std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " +
      std::to_string(size[2]) + " nodes; a seafloor is one layer of at least 4 x 4");
  }
  Points points = pointsOf(set);
  ModelGrid grid;
  grid.format = "VTK structured grid";
  grid.columns = static_cast<std::size_t>(size[0]);
  grid.rows = static_cast<std::size_t>(size[1]);
  grid.places = std::move(points.places);
  grid.values = std::move(points.elevations);
  grid.crs = points.crs;
  grid.vertical = elevations();
  grid.makeRegular();
  return readSeafloor(path, std::move(grid), options, execution);
}

Bathymetry loadUnstructured(const std::string& path, const SeafloorOptions& options, const Execution& execution)
{
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  readXmlFile(reader, path, "a VTK unstructured grid (.vtu)");
  vtkUnstructuredGrid* set = reader->GetOutput();
  const Points points = pointsOf(set);
  Soundings soundings;
  soundings.driver = "VTK unstructured grid";
  soundings.crs = points.crs;
  soundings.vertical = elevations();
  for (std::size_t i = 0; i < points.places.size(); ++i)
  {
    soundings.add(points.places[i].x, points.places[i].y, points.elevations[i]);
  }
  for (vtkIdType i = 0; i < set->GetNumberOfCells(); ++i)
  {
    vtkCell* cell = set->GetCell(i);
    if (cell->GetCellDimension() != 2 || !cell->IsLinear())
    {
      continue;
    }
    if (soundings.cellOffsets.empty())
    {
      soundings.cellOffsets.push_back(0);
    }
    // Its edges in turn, so that a pixel's corners come in order too.
    const int corners = cell->GetNumberOfPoints();
    const bool pixel = cell->GetCellType() == VTK_PIXEL;
    for (int k = 0; k < corners; ++k)
    {
      const int corner = pixel && k >= 2 ? 5 - k : k;
      soundings.cellNodes.push_back(static_cast<std::uint32_t>(cell->GetPointId(corner)));
    }
    soundings.cellOffsets.push_back(soundings.cellNodes.size());
  }
  return readSeafloor(path, soundings, options, execution);
}

}

Bathymetry loadMesh(const std::string& path, const SeafloorOptions& options, const Execution& execution)
{
  const bool structured = plain(path.substr(path.size() - 4)) == ".vts";
  try
  {
    return structured ? loadStructured(path, options, execution) : loadUnstructured(path, options, execution);
  }
  catch (const std::runtime_error& error)
  {
    const std::string words = error.what();
    throw std::runtime_error(words.compare(0, 10, "seafloor '") == 0 ? words : "seafloor '" + path + "': " + words);
  }
}

}
