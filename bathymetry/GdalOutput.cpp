#include "bathymetry/GdalOutput.h"

#include "bathymetry/QuietGdal.h"

#include <cpl_conv.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include <fcntl.h>
#include <unistd.h>

namespace swellray::gdaloutput
{

NoSideCars::NoSideCars()
{
  CPLSetThreadLocalConfigOption("GDAL_PAM_ENABLED", "NO");
}

NoSideCars::~NoSideCars()
{
  CPLSetThreadLocalConfigOption("GDAL_PAM_ENABLED", nullptr);
}

void require(bool done)
{
  if (!done || QuietGdal::failed())
  {
    throw std::runtime_error(QuietGdal::lastError("no reason given"));
  }
}

GDALDriver* driverNamed(const char* name)
{
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(name);
  if (!driver)
  {
    throw std::runtime_error(std::string("this GDAL has no driver ") + name);
  }
  return driver;
}

void requireRoom(const std::string& path, std::size_t values)
{
  constexpr std::size_t ForTheRest = 65536;
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
  if (file < 0)
  {
    throw std::runtime_error(std::strerror(errno));
  }
  const int error = posix_fallocate(file, 0, static_cast<off_t>(values + ForTheRest));
  ::close(file);
  if (error == ENOSPC || error == EFBIG)
  {
    throw std::runtime_error("the disk is full, or files may not get so large");
  }
}

Dataset createNetcdf(const std::string& path)
{
  const char* const format[] = { "FORMAT=NC4", nullptr };
  Dataset dataset(driverNamed("netCDF")->CreateMultiDimensional(path.c_str(), nullptr, format));
  require(dataset != nullptr);
  return dataset;
}

void close(Dataset& dataset)
{
  dataset->FlushCache(true);
  dataset.reset();
  require(true);
}

}
