#include "CurrentSource.h"

#include "GeoreferenceField.h"
#include "SeafloorField.h"
#include "XmlFile.h"
#include "bathymetry/CurrentReader.h"
#include "bathymetry/Text.h"
#include "sim/BuiltinCurrent.h"
#include "sim/SplineCurrent.h"

#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLImageDataReader.h>

#include <cmath>
#include <filesystem>
#include <sstream>
#include <stdexcept>

namespace swellray
{

namespace
{

/** One component of an array, as an array of its own. */
vtkSmartPointer<vtkDoubleArray> component(vtkDataArray* array, int index)
{
  auto values = vtkSmartPointer<vtkDoubleArray>::New();
  values->SetNumberOfTuples(array->GetNumberOfTuples());
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    values->SetValue(i, array->GetComponent(i, index));
  }
  return values;
}

/** The array of vectors: by its name, or the only one. */
vtkDataArray* vectorsOf(vtkPointData* data)
{
  const auto isVector = [](vtkDataArray* array)
  { return array && (array->GetNumberOfComponents() == 2 || array->GetNumberOfComponents() == 3); };
  for (const char* name : { "Current", "Velocity" })
  {
    if (isVector(data->GetArray(name)))
    {
      return data->GetArray(name);
    }
  }
  vtkDataArray* only = nullptr;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    if (isVector(data->GetArray(i)))
    {
      if (only)
      {
        return nullptr;
      }
      only = data->GetArray(i);
    }
  }
  return only;
}

/** What to add to a position of the image to have one of the scene. */
glm::dvec2 shiftOf(const Georeference& own, const Georeference& scene)
{
  const bool geographic = own.kind() == GeoreferenceKind::Geographic;
  if (geographic != (scene.kind() == GeoreferenceKind::Geographic) && !own.crs().empty() && !scene.crs().empty())
  {
    throw std::runtime_error("its CRS is '" + own.crsName() + "', that of the seafloor '" + scene.crsName() + "'");
  }
  if (geographic)
  {
    if (own.originLongitude() != scene.originLongitude() || own.originLatitude() != scene.originLatitude())
    {
      throw std::runtime_error("its map has another centre than that of the seafloor: make it on the same one");
    }
    return glm::dvec2(0.0);
  }
  if (scene.kind() == GeoreferenceKind::Geographic)
  {
    return glm::dvec2(0.0); // no CRS: the metres of the scene
  }
  if (!own.crs().empty() && !scene.crs().empty() && own.crsName() != scene.crsName())
  {
    throw std::runtime_error("its CRS is '" + own.crsName() + "', that of the seafloor '" + scene.crsName() + "'");
  }
  return scene.fromFile(own.toFile(glm::dvec2(0.0)));
}

std::shared_ptr<const Current> loadImage(const std::string& path, const Georeference& scene)
{
  vtkNew<vtkXMLImageDataReader> reader;
  readXmlFile(reader, path, "a VTK image (.vti)");
  vtkImageData* image = reader->GetOutput();
  vtkPointData* data = image->GetPointData();
  vtkSmartPointer<vtkDataArray> u = data->GetArray("u");
  vtkSmartPointer<vtkDataArray> v = data->GetArray("v");
  if (vtkDataArray* vectors = vectorsOf(data))
  {
    u = component(vectors, 0);
    v = component(vectors, 1);
  }
  if (!u || !v || u->GetNumberOfComponents() != 1 || v->GetNumberOfComponents() != 1)
  {
    throw std::runtime_error("it has no point array Current of 2 or 3 components (m/s), nor two arrays u and v");
  }
  ElevationGrid gridU = gridOfImage(image, u);
  ElevationGrid gridV = gridOfImage(image, v);
  const glm::dvec2 shift = shiftOf(georeferenceOf(image), scene);
  gridU.origin += shift;
  gridV.origin += shift;
  return std::make_shared<SplineCurrent>(gridU, gridV);
}

std::string describeSource(const std::string& name, const Georeference& scene, const Rectangle& bounds)
{
  std::ostringstream words;
  words << std::hexfloat << name << '\n';
  std::error_code none;
  const auto date = std::filesystem::last_write_time(name, none);
  if (!none)
  {
    words << date.time_since_epoch().count();
  }
  words << '\n'
        << bounds.low.x << ' ' << bounds.low.y << ' ' << bounds.high.x << ' ' << bounds.high.y << ' '
        << scene.originLongitude() << ' ' << scene.originLatitude() << ' ' << scene.originX() << ' ' << scene.originY()
        << '\n'
        << scene.crs();
  return words.str();
}

bool looksBuiltIn(const std::string& name)
{
  std::error_code none;
  return isBuiltinCurrent(name) || (!std::filesystem::exists(name, none) && resemblesBuiltinCurrent(name));
}

}

std::shared_ptr<const Current> CurrentField::get(
  const std::string& name, const Georeference& scene, const Rectangle& bounds)
{
  const std::string source = describeSource(name, scene, bounds);
  if (this->Kept && this->Source == source)
  {
    return this->Kept;
  }
  this->Kept.reset();
  this->Notes.clear();
  if (looksBuiltIn(name))
  {
    this->Kept = makeBuiltinCurrent(name);
  }
  else if (plain(std::filesystem::path(name).extension().string()) == ".vti")
  {
    try
    {
      this->Kept = loadImage(name, scene);
    }
    catch (const std::exception& error)
    {
      throw std::runtime_error("current '" + name + "': " + error.what());
    }
  }
  else
  {
    CurrentGrids grids = readCurrent(name, scene, bounds);
    this->Notes = std::move(grids.notes);
    this->Kept = std::make_shared<SplineCurrent>(grids.u, grids.v);
  }
  this->Source = source;
  return this->Kept;
}

}
