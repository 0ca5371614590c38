#pragma once

#include "sim/Seafloor.h"

#include <functional>
#include <string>
#include <vector>

namespace swellray
{

/** CRS of a seafloor: WKT, empty for a plane in metres, and where it was taken from. */
struct CrsChoice
{
  std::string crs;
  std::string source; ///< "file", "as asked", or why it was assumed
};

/**
 * The CRS that is asked for, or the file's own; without both, longitude and latitude if the coordinates fit them and
 * the slope would be absurd in metres, otherwise metres.
 *
 * @param asked anything that GDAL takes, or "local"; empty: none
 * @param own WKT or EPSG:n of the file, empty: none
 * @param ownSource where that comes from; empty: the file
 * @param extent file coordinates
 * @param rmsSlope root mean square of the slope, metres a unit of the file; called where it decides
 * @param notes where an assumption is said
 */
CrsChoice chooseCrs(const std::string& asked, const std::string& own, const std::string& ownSource,
  const Rectangle& extent, const std::function<double()>& rmsSlope, std::vector<std::string>& notes);

/** True where the CRS that is asked for, or otherwise the file's own, has longitude and latitude. */
bool isLongitudes(const std::string& asked, const std::string& own);

}
