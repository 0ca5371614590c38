#include "bathymetry/CrsChoice.h"

#include "bathymetry/Georeference.h"
#include "bathymetry/Text.h"

namespace swellray
{

namespace
{

// Slope, rms, above which coordinates that fit longitude and latitude are taken for degrees.
constexpr double AbsurdSlope = 100.0;

}

CrsChoice chooseCrs(const std::string& asked, const std::string& own, const std::string& ownSource,
  const Rectangle& extent, const std::function<double()>& rmsSlope, std::vector<std::string>& notes)
{
  if (!asked.empty())
  {
    return { plain(asked) == "local" ? std::string() : crsToWkt(asked), "as asked" };
  }
  if (!own.empty())
  {
    return { own, ownSource.empty() ? "file" : ownSource };
  }
  const bool fits = extent.low.x >= -180.0 && extent.high.x <= 360.0 && extent.low.y >= -90.0 && extent.high.y <= 90.0;
  const double slope = fits ? rmsSlope() : 0.0;
  if (fits && slope > AbsurdSlope)
  {
    notes.push_back(
      "no CRS: taken as longitude and latitude (WGS 84), because its coordinates fit them and its slope " +
      ("would be " + text(slope, 3)) + " (rms) if they were metres; --crs overrides");
    return { "EPSG:4326", "assumed" };
  }
  notes.push_back(std::string("no CRS: coordinates taken as metres, because ") +
    (fits ? "its slope is then " + text(slope, 3) + " (rms)" : "they do not fit longitude and latitude") +
    "; --crs overrides");
  return { "", "assumed" };
}

bool isLongitudes(const std::string& asked, const std::string& own)
{
  const std::string& crs = asked.empty() ? own : asked;
  return !crs.empty() && plain(crs) != "local" &&
    Georeference(crs, glm::dvec2(0.0), glm::dvec2(0.0)).kind() == GeoreferenceKind::Geographic;
}

}
