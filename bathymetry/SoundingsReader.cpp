#include "bathymetry/SoundingsReader.h"

#include "bathymetry/NetcdfSoundings.h"
#include "bathymetry/QuietGdal.h"
#include "bathymetry/TextSoundings.h"

#include <cpl_vsi.h>
#include <gdal_priv.h>

#include <memory>
#include <stdexcept>

namespace swellray
{

std::optional<Soundings> readSoundings(const std::string& path, const std::string& variable)
{
  const QuietGdal quiet;
  VSIStatBufL status;
  if (VSIStatL(path.c_str(), &status) != 0 || VSI_ISDIR(status.st_mode))
  {
    return {};
  }
  GDALDriverH driver = GDALIdentifyDriverEx(path.c_str(), GDAL_OF_RASTER, nullptr, nullptr);
  const std::string name = driver ? GDALGetDriverShortName(driver) : "";
  if (name == "netCDF")
  {
    return readNetcdfSoundings(path, variable);
  }
  if (name == "XYZ")
  {
    const char* const only[] = { "XYZ", nullptr };
    const std::unique_ptr<GDALDataset> grid(
      GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, only, nullptr, nullptr));
    return grid ? std::nullopt : std::optional<Soundings>(readTextSoundings(path, variable));
  }
  if (name.empty() && isText(path))
  {
    try
    {
      return readTextSoundings(path, variable);
    }
    catch (const std::runtime_error& error)
    {
      throw std::runtime_error(std::string("not a raster that GDAL can read, nor soundings: ") + error.what());
    }
  }
  return {};
}

}
