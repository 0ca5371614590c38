#include "FuzzInput.h"

#include "bathymetry/ObstacleReader.h"
#include "sim/Obstacles.h"

using namespace swellray;

// GeoJSON only: what is inside of GeoPackage and Shapefile is read by their libraries.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string path = fuzz::writeFile("a.geojson", std::string(reinterpret_cast<const char*>(data), size));
  const Rectangle scene{ { 0.0, 0.0 }, { 1000.0, 1000.0 } };
  static const Georeference local;
  static const Georeference geographic("EPSG:4326", { 0.005, 0.005 }, { 0.0, 0.0 });
  for (const Georeference* place : { &local, &geographic })
  {
    fuzz::expectOneLine(
      [&]
      {
        const ObstacleFile read = readObstacles(path, *place, scene, 0.5);
        fuzz::require(!read.obstacles.empty());
        const Obstacles obstacles(read.obstacles);
        obstacles.inside({ 500.0, 500.0 });
        obstacles.crosses({ -10.0, -10.0 }, { 1010.0, 900.0 });
      });
  }
  return 0;
}
