#include "bathymetry/QuietGdal.h"

#include "bathymetry/Text.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal.h>

#include <mutex>

namespace swellray
{

namespace
{

constexpr GIntBig CacheSize = 134217728; // bytes

}

QuietGdal::QuietGdal()
{
  static std::once_flag registered;
  CPLPushErrorHandler(CPLQuietErrorHandler);
  std::call_once(registered,
    []
    {
      GDALAllRegister();
      // Each block is read once, so a share of the machine's memory, which is GDAL's own choice, buys nothing.
      if (!CPLGetConfigOption("GDAL_CACHEMAX", nullptr))
      {
        GDALSetCacheMax64(CacheSize);
      }
    });
  CPLErrorReset();
}

QuietGdal::~QuietGdal()
{
  CPLPopErrorHandler();
}

std::string QuietGdal::lastError(const std::string& otherwise)
{
  const std::string message = oneLine(CPLGetLastErrorMsg());
  return message.empty() ? otherwise : message;
}

bool QuietGdal::failed()
{
  return CPLGetLastErrorType() >= CE_Failure;
}

void QuietGdal::forget()
{
  CPLErrorReset();
}

}
