#include "bathymetry/Wkt.h"

#include "bathymetry/QuietGdal.h"

#include <cpl_conv.h>
#include <ogr_spatialref.h>

#include <stdexcept>

namespace swellray
{

std::string wktOf(const OGRSpatialReference& crs)
{
  const char* const format[] = { "FORMAT=WKT2_2019", "MULTILINE=NO", nullptr };
  char* written = nullptr;
  const bool done = crs.exportToWkt(&written, format) == OGRERR_NONE && written;
  std::string wkt = done ? written : "";
  CPLFree(written);
  if (!done)
  {
    throw std::runtime_error("its CRS cannot be written as WKT: " + QuietGdal::lastError("no reason given"));
  }
  return wkt;
}

}
