#include "bathymetry/StwaveGrid.h"

#include "bathymetry/FileGrid.h"
#include "bathymetry/QuietGdal.h"
#include "bathymetry/Settings.h"
#include "bathymetry/Text.h"
#include "bathymetry/TextFile.h"
#include "bathymetry/Wkt.h"

#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace swellray
{

namespace
{

// The projection that coord_sys and spzone name; a note where they name none that is known.
void placeOnEarth(const Settings& settings, ModelGrid& grid)
{
  const std::string system = plain(settings.word("coord_sys"));
  if (system.empty() || system == "local")
  {
    return;
  }
  const double zone = settings.number("spzone", 0.0);
  const std::string named = settings.word("coord_sys") + " " + text(zone);
  const QuietGdal quiet;
  OGRSpatialReference crs;
  OGRErr done = OGRERR_FAILURE;
  if (zone == std::floor(zone) && zone > 0.0 && zone < 10000.0)
  {
    if (system == "stateplane")
    {
      done = crs.SetStatePlane(static_cast<int>(zone), TRUE);
    }
    else if (system == "utm" && zone <= 60.0)
    {
      crs.SetWellKnownGeogCS("NAD83");
      done = crs.SetUTM(static_cast<int>(zone), TRUE);
    }
  }
  const std::string wkt = done == OGRERR_NONE ? wktOf(crs) : std::string();
  if (wkt.empty())
  {
    grid.notes.push_back("its coordinate system " + named + " is not known; --crs gives it");
    return;
  }
  grid.crs = wkt;
  grid.crsSource = "coord_sys " + named + ", NAD 83 assumed";
}

// What stands before the first line IDD, the header of the first record.
std::size_t beginOfRecord(const std::string& depths)
{
  for (std::size_t at = 0; at < depths.size();)
  {
    const std::size_t begin = depths.find_first_not_of(" \t\r", at);
    if (begin != std::string::npos && plain(depths.substr(begin, 3)) == "idd")
    {
      return begin;
    }
    const std::size_t end = depths.find('\n', at);
    at = end == std::string::npos ? depths.size() : end + 1;
  }
  throw std::runtime_error("its depth file has no record (a line that begins with IDD)");
}

}

ModelGrid readStwaveGrid(const std::string& sim, const FileText& open)
{
  const Settings settings(sim);
  if (settings.number("idep_opt", 0.0) != 0.0)
  {
    throw std::runtime_error("its depth is not one of a file (idep_opt is not 0)");
  }
  const std::string name = settings.word("dep");
  if (name.empty())
  {
    throw std::runtime_error("it does not set DEP, the name of the depth file");
  }
  ModelGrid grid;
  grid.format = "STWAVE";
  grid.columns = wholeNumber(settings.number("n_cell_i"), "n_cell_i", MostNodes);
  grid.rows = wholeNumber(settings.number("n_cell_j"), "n_cell_j", MostNodes);
  const double dx = settings.number("dx");
  const double dy = settings.number("dy");
  if (!(dx > 0.0 && dy > 0.0))
  {
    throw std::runtime_error("dx and dy must be above 0, not " + text(dx) + " and " + text(dy));
  }
  const glm::dvec2 corner(settings.number("x0", 0.0), settings.number("y0", 0.0));
  grid.layOut(corner, settings.number("azimuth", 0.0), dx, dy);
  grid.first += 0.5 * (grid.columnStep + grid.rowStep);

  const std::string depths = open(name);
  const std::size_t begin = beginOfRecord(depths);
  const Settings header(std::string_view(depths).substr(0, begin));
  const auto agrees = [&](const std::string& key, std::size_t count)
  {
    if (header.number(key, static_cast<double>(count)) != static_cast<double>(count))
    {
      throw std::runtime_error(
        "'" + name + "' has " + key + " = " + header.word(key) + ", the .sim file " + std::to_string(count));
    }
  };
  agrees("ni", grid.columns);
  agrees("nj", grid.rows);
  if (header.number("numflds", 1.0) != 1.0)
  {
    throw std::runtime_error("'" + name + "' has several fields; a depth file has one");
  }
  grid.vertical.units = header.word("fldunits(1)");
  if (grid.vertical.units.empty())
  {
    grid.vertical.units = "m";
    grid.vertical.unitsSource = "STWAVE's unit";
  }
  grid.vertical.rule = "down";
  grid.vertical.ruleSource = "STWAVE depth";

  NumberScanner scanner(std::string_view(depths).substr(begin));
  scanner.skipLines(1);
  grid.values = readNodes(scanner, grid.columns, grid.rows, false, "depth in '" + name + "'");
  for (std::size_t low = 0, high = grid.rows - 1; low < high; ++low, --high)
  {
    const auto at = [&](std::size_t row)
    { return grid.values.begin() + static_cast<std::ptrdiff_t>(row * grid.columns); };
    std::swap_ranges(at(low), at(low) + static_cast<std::ptrdiff_t>(grid.columns), at(high));
  }
  placeOnEarth(settings, grid);
  return grid;
}

}
