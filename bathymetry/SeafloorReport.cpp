#include "bathymetry/SeafloorReport.h"

#include "bathymetry/Text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swellray
{

namespace
{

std::string percent(double share)
{
  // A few cells of many are not none.
  return share > 0.0 && share < 0.0005 ? "below 0.1 %" : text(100.0 * share, 3) + " %";
}

std::string range(double low, double high, int digits)
{
  return text(low, digits) + " to " + text(high, digits);
}

}

void SeafloorReport::count(const ElevationGrid& grid, double level)
{
  this->waterLevel = level;
  this->lowest = std::numeric_limits<double>::infinity();
  this->highest = -this->lowest;
  std::size_t water = 0;
  std::size_t land = 0;
  for (const double z : grid.elevation)
  {
    if (std::isnan(z))
    {
      continue;
    }
    ++(z < level ? water : land);
    this->lowest = std::min(this->lowest, z);
    this->highest = std::max(this->highest, z);
  }
  const auto total = static_cast<double>(grid.elevation.size());
  this->waterShare = static_cast<double>(water) / total;
  this->landShare = static_cast<double>(land) / total;
  this->noDataShare = static_cast<double>(grid.elevation.size() - water - land) / total;
}

std::vector<std::pair<std::string, std::string>> SeafloorReport::lines() const
{
  constexpr int coordinateDigits = 10;
  std::vector<std::pair<std::string, std::string>> result;
  const auto add = [&result](const std::string& label, const std::string& words) { result.emplace_back(label, words); };

  add("File", this->path);
  add("Format", this->driver + (this->variable.empty() ? "" : ", " + this->variable));
  if (this->fileColumns > 0)
  {
    std::string size = std::to_string(this->fileColumns) + " x " + std::to_string(this->fileRows);
    if (this->readColumns != this->fileColumns || this->readRows != this->fileRows)
    {
      size += ", read " + std::to_string(this->readColumns) + " x " + std::to_string(this->readRows);
    }
    add("Size", size);
  }
  const char* const kinds[] = { "none, local metres", "projected", "longitude and latitude" };
  const std::string kindName = kinds[static_cast<int>(this->kind)];
  add("CRS",
    (this->crsName.empty() ? kindName : this->crsName + ", " + kindName) +
      (this->crsSource.empty() ? "" : " (" + this->crsSource + ")"));
  add("File extent",
    range(this->fileExtent.low.x, this->fileExtent.high.x, coordinateDigits) + ", " +
      range(this->fileExtent.low.y, this->fileExtent.high.y, coordinateDigits));
  if (this->fileColumns > 0)
  {
    add("File spacing", text(this->fileSpacing.x, 8) + " x " + text(this->fileSpacing.y, 8));
  }
  add("Values", this->units + " (" + this->unitsSource + "), " + this->sign + " (" + this->signSource + ")");
  if (this->soundings)
  {
    const auto said = this->soundings->lines();
    result.insert(result.end(), said.begin(), said.end());
  }
  add("Grid",
    std::to_string(this->columns) + " x " + std::to_string(this->rows) + " of " + text(this->spacing.x, 5) + " x " +
      text(this->spacing.y, 5) + " m" + (this->resampled ? ", resampled" : ""));
  add("Extent",
    range(this->extent.low.x, this->extent.high.x, 8) + " m east, " +
      range(this->extent.low.y, this->extent.high.y, 8) + " m north");
  if (this->standardLatitude)
  {
    add("Earth", "ellipsoid, on Mercator's map with scale 1 at latitude " + text(*this->standardLatitude, 8));
  }
  else if (this->kind == GeoreferenceKind::Geographic)
  {
    add("Scale error", "at most " + text(100.0 * this->scaleError, 2) + " %");
  }
  add("Elevation", range(this->lowest, this->highest, 5) + " m");
  add("Depth",
    range(std::max(0.0, this->waterLevel - this->highest), this->waterLevel - this->lowest, 5) + " m at water level " +
      text(this->waterLevel) + " m");
  add("Water", percent(this->waterShare));
  add("Land", percent(this->landShare));
  add("No data", percent(this->noDataShare));
  if (this->noDataRead > 0)
  {
    add("Gaps",
      std::to_string(this->noDataRead) + " cells without data in the file, " + std::to_string(this->filled) +
        " filled");
  }
  for (const std::string& note : this->notes)
  {
    add("Note", note);
  }
  return result;
}

}
