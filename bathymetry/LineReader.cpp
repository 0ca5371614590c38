#include "bathymetry/LineReader.h"

#include "bathymetry/QuietGdal.h"
#include "bathymetry/VectorPlaces.h"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <memory>
#include <stdexcept>

namespace swellray
{

namespace
{

void addLines(const OGRGeometry& geometry, const VectorPlaces& places, std::vector<std::vector<glm::dvec2>>& lines)
{
  switch (wkbFlatten(geometry.getGeometryType()))
  {
  case wkbLineString:
    lines.push_back(places.metresOf(*geometry.toLineString()));
    break;
  case wkbMultiLineString:
  case wkbGeometryCollection:
    for (const OGRGeometry* part : *geometry.toGeometryCollection())
    {
      addLines(*part, places, lines);
    }
    break;
  default:
    throw std::runtime_error(
      std::string("it has a geometry of the kind '") + geometry.getGeometryName() + "': only lines are wanted");
  }
}

}

std::vector<std::vector<glm::dvec2>> readPolyLines(const std::string& path, const Georeference& scene)
{
  const QuietGdal quiet;
  try
  {
    const VectorDataset dataset = openVectors(path);
    VectorPlaces places(scene);
    std::vector<std::vector<glm::dvec2>> lines;
    for (OGRLayer* layer : dataset->GetLayers())
    {
      places.enter(*layer);
      for (const auto& feature : *layer)
      {
        if (const OGRGeometry* geometry = feature->GetGeometryRef())
        {
          const std::unique_ptr<OGRGeometry> straight(geometry->getLinearGeometry());
          addLines(*straight, places, lines);
        }
      }
    }
    if (QuietGdal::failed())
    {
      throw std::runtime_error(QuietGdal::lastError("it is damaged"));
    }
    std::vector<std::vector<glm::dvec2>> kept;
    for (std::vector<glm::dvec2>& line : lines)
    {
      bool extends = false;
      for (const glm::dvec2& point : line)
      {
        extends = extends || point != line.front();
      }
      if (extends)
      {
        kept.push_back(std::move(line));
      }
    }
    if (kept.empty())
    {
      throw std::runtime_error("it has no lines");
    }
    return kept;
  }
  catch (const std::runtime_error& error)
  {
    throw std::runtime_error("lines '" + path + "': " + error.what());
  }
}

}
