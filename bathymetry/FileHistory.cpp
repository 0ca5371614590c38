#include "bathymetry/FileHistory.h"

#include "bathymetry/QuietGdal.h"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <memory>
#include <stdexcept>

namespace swellray
{

std::string readHistory(const std::string& path)
{
  const QuietGdal quiet;
  const std::unique_ptr<GDALDataset> dataset(
    GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_VECTOR | GDAL_OF_READONLY));
  if (!dataset)
  {
    throw std::runtime_error("GDAL cannot read it: " + QuietGdal::lastError("no reason given"));
  }
  // Where MapWriter and LineWriter put it.
  for (const char* name : { "TIFFTAG_IMAGEDESCRIPTION", "NC_GLOBAL#history", "History" })
  {
    if (const char* history = dataset->GetMetadataItem(name))
    {
      return history;
    }
  }
  // Of GeoJSON the description of its layer: who made it, and how.
  OGRLayer* layer = dataset->GetLayerCount() > 0 ? dataset->GetLayer(0) : nullptr;
  if (const char* described = layer ? layer->GetMetadataItem("DESCRIPTION") : nullptr)
  {
    const std::string text = described;
    const auto at = text.find(": ");
    return at == std::string::npos ? text : text.substr(at + 2);
  }
  return {};
}

}
