#pragma once

#include "bathymetry/Georeference.h"

#include <glm/vec2.hpp>

#include <memory>
#include <string>
#include <vector>

class GDALDataset;
class OGRCoordinateTransformation;
class OGRLayer;
class OGRLineString;

namespace swellray
{

struct CloseVectors
{
  void operator()(GDALDataset* dataset) const;
};

using VectorDataset = std::unique_ptr<GDALDataset, CloseVectors>;

/** A vector file (GeoJSON, GeoPackage, Shapefile and whatever else OGR reads). @throws std::runtime_error where it is none */
VectorDataset openVectors(const std::string& path);

/**
 * Brings the coordinates of vector layers from the CRS of each to that of a scene, and to its metres. Where either has none, they
 * are taken as those of the scene's file.
 */
class VectorPlaces
{
public:
  /** The scene must outlive this. */
  explicit VectorPlaces(const Georeference& scene);
  ~VectorPlaces();

  /** Take the coordinates of this layer from now on. @throws std::runtime_error where no way leads from its CRS to the scene's */
  void enter(OGRLayer& layer);

  /** @throws std::runtime_error naming a point that lies nowhere in the scene's CRS */
  std::vector<glm::dvec2> metresOf(const OGRLineString& line) const;

  /** A layer had no CRS, or the scene has none. */
  bool unplaced() const { return this->Unplaced; }

private:
  const Georeference& Scene;
  std::unique_ptr<OGRCoordinateTransformation> Transformation;
  bool Unplaced = false;
};

}
