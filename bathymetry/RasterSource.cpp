#include "bathymetry/RasterSource.h"

#include "bathymetry/GdalRaster.h"
#include "bathymetry/NetcdfRaster.h"
#include "bathymetry/QuietGdal.h"

#include <cpl_vsi.h>
#include <gdal_priv.h>

#include <cmath>
#include <stdexcept>

namespace swellray
{

void NoDataMark::add(double value, bool singlePrecision)
{
  if (std::isnan(value))
  {
    return;
  }
  // A mark written with few digits, or stored in single precision, is met within that precision.
  const double margin = singlePrecision ? 1e-6 * std::abs(value) : 1e-12 * std::abs(value);
  this->Low.push_back(value - margin);
  this->High.push_back(value + margin);
}

bool NoDataMark::operator()(double value) const
{
  if (!std::isfinite(value))
  {
    return true;
  }
  for (std::size_t i = 0; i < this->Low.size(); ++i)
  {
    if (value >= this->Low[i] && value <= this->High[i])
    {
      return true;
    }
  }
  return false;
}

std::unique_ptr<RasterSource> openRaster(const std::string& path, const std::string& variable)
{
  const QuietGdal quiet;
  VSIStatBufL status;
  const bool exists = VSIStatL(path.c_str(), &status) == 0;
  if (exists && VSI_ISDIR(status.st_mode))
  {
    throw std::runtime_error("it is a folder, not a file");
  }
  // Names such as NETCDF:"file":variable are no files but can be opened.
  if (!exists && path.find(':') == std::string::npos)
  {
    throw std::runtime_error("no such file");
  }
  GDALDriverH driver = GDALIdentifyDriverEx(path.c_str(), GDAL_OF_RASTER, nullptr, nullptr);
  const std::string name = driver ? GDALGetDriverShortName(driver) : "";
  if (exists && name == "netCDF")
  {
    return std::make_unique<NetcdfRaster>(path, variable);
  }
  return std::make_unique<GdalRaster>(path, variable);
}

}
