#include "bathymetry/QuietGdal.h"

#include "bathymetry/Text.h"

#include <cpl_error.h>
#include <gdal.h>

#include <mutex>

namespace swellray
{

QuietGdal::QuietGdal()
{
  static std::once_flag registered;
  CPLPushErrorHandler(CPLQuietErrorHandler);
  std::call_once(registered, GDALAllRegister);
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
