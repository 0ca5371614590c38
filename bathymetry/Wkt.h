#pragma once

#include <string>

class OGRSpatialReference;

namespace swellray
{

/**
 * A CRS as WKT (2019) on one line.
 * @throws std::runtime_error where it cannot be written
 */
std::string wktOf(const OGRSpatialReference& crs);

}
