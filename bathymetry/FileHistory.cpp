#include "bathymetry/FileHistory.h"

#include "bathymetry/QuietGdal.h"

#include <gdal_priv.h>

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
  return {};
}

}
