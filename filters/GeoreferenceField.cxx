#include "GeoreferenceField.h"

#include "AlgorithmExecution.h"
#include "FieldData.h"
#include "RayArrays.h"
#include "bathymetry/MapWriter.h"

#include <vtkPointData.h>
#include <vtkPointSet.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace swellray
{

namespace
{

// Points mapped by one call: large enough to hide its cost, small enough for the cache.
constexpr std::size_t PointsAtOnce = 2048;

constexpr const char* EllipsoidName = "ellipsoid";

}

void setGeoreference(vtkDataObject* data, const Georeference& georeference)
{
  setFieldValue(data, "OriginX", georeference.originX());
  setFieldValue(data, "OriginY", georeference.originY());
  if (georeference.mercator())
  {
    setFieldString(data, "CRS", mapCrs(georeference));
    setFieldString(data, "EarthModel", EllipsoidName);
  }
  else if (!georeference.crs().empty())
  {
    setFieldString(data, "CRS", georeference.crs());
  }
  if (!std::isnan(georeference.originLongitude()))
  {
    setFieldValue(data, "OriginLongitude", georeference.originLongitude());
    setFieldValue(data, "OriginLatitude", georeference.originLatitude());
  }
}

Georeference georeferenceOf(vtkDataObject* data)
{
  if (fieldString(data, "EarthModel").value_or("") == EllipsoidName)
  {
    return Georeference::fromMercator(fieldString(data, "CRS").value_or(""));
  }
  const glm::dvec2 lonLat(
    fieldValue(data, "OriginLongitude").value_or(0.0), fieldValue(data, "OriginLatitude").value_or(0.0));
  const glm::dvec2 xy(fieldValue(data, "OriginX").value_or(0.0), fieldValue(data, "OriginY").value_or(0.0));
  return Georeference(fieldString(data, "CRS").value_or(""), lonLat, xy);
}

void addLongitudeLatitude(vtkPointSet* points)
{
  const Georeference georeference = georeferenceOf(points);
  if (georeference.kind() == GeoreferenceKind::Local)
  {
    return;
  }
  const vtkIdType n = points->GetNumberOfPoints();
  double* longitude = addArray<vtkDoubleArray>(points->GetPointData(), "Longitude", n);
  double* latitude = addArray<vtkDoubleArray>(points->GetPointData(), "Latitude", n);
  const double* positions =
    n > 0 ? vtkDoubleArray::SafeDownCast(points->GetPoints()->GetData())->GetPointer(0) : nullptr;
  parallelFor(static_cast<std::size_t>(n),
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<glm::dvec2> buffer;
      for (std::size_t first = begin; first < end; first += PointsAtOnce)
      {
        buffer.resize(std::min(PointsAtOnce, end - first));
        for (std::size_t i = 0; i < buffer.size(); ++i)
        {
          buffer[i] = { positions[3 * (first + i)], positions[3 * (first + i) + 1] };
        }
        georeference.toLonLat(buffer.size(), buffer.data(), buffer.data());
        for (std::size_t i = 0; i < buffer.size(); ++i)
        {
          longitude[first + i] = buffer[i].x;
          latitude[first + i] = buffer[i].y;
        }
      }
    });
}

}
