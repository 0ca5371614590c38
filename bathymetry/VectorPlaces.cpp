#include "bathymetry/VectorPlaces.h"

#include "bathymetry/QuietGdal.h"
#include "bathymetry/Text.h"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <cmath>
#include <stdexcept>

namespace swellray
{

void CloseVectors::operator()(GDALDataset* dataset) const
{
  GDALClose(dataset);
}

VectorDataset openVectors(const std::string& path)
{
  VectorDataset dataset(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY));
  if (!dataset)
  {
    throw std::runtime_error("no such file, or no polygons and lines in it (GeoJSON, GeoPackage, Shapefile, ...): " +
      QuietGdal::lastError("no reason given"));
  }
  QuietGdal::forget();
  return dataset;
}

VectorPlaces::VectorPlaces(const Georeference& scene)
  : Scene(scene)
{
}

VectorPlaces::~VectorPlaces() = default;

void VectorPlaces::enter(OGRLayer& layer)
{
  this->Transformation.reset();
  const OGRSpatialReference* own = layer.GetSpatialRef();
  if (!own || this->Scene.crs().empty())
  {
    this->Unplaced = true;
    return;
  }
  OGRSpatialReference from(*own);
  from.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  OGRSpatialReference to;
  to.importFromWkt(this->Scene.crs().c_str());
  to.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (from.IsSame(&to))
  {
    return;
  }
  this->Transformation.reset(OGRCreateCoordinateTransformation(&from, &to));
  if (!this->Transformation)
  {
    throw std::runtime_error(
      "no way from its CRS to '" + this->Scene.crsName() + "': " + QuietGdal::lastError("no reason given"));
  }
}

std::vector<glm::dvec2> VectorPlaces::metresOf(const OGRLineString& line) const
{
  const auto count = static_cast<std::size_t>(line.getNumPoints());
  std::vector<glm::dvec2> points(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    points[i] = { line.getX(static_cast<int>(i)), line.getY(static_cast<int>(i)) };
    double x = points[i].x;
    double y = points[i].y;
    if (this->Transformation && !this->Transformation->Transform(1, &x, &y))
    {
      throw std::runtime_error("the point " + text(points[i].x) + ", " + text(points[i].y) + " has no place in CRS '" +
        this->Scene.crsName() + "'");
    }
    if (!std::isfinite(x) || !std::isfinite(y) ||
      (this->Scene.kind() == GeoreferenceKind::Geographic && !(std::abs(y) <= 90.0)))
    {
      throw std::runtime_error("the point " + text(points[i].x) + ", " + text(points[i].y) + " lies nowhere" +
        (this->Scene.kind() == GeoreferenceKind::Geographic ? ": the scene is in degrees" : ""));
    }
    points[i] = this->Scene.fromFile({ x, y });
  }
  return points;
}

}
