#include "bathymetry/XbeachGrid.h"

#include "bathymetry/Delft3dGrid.h"
#include "bathymetry/FileGrid.h"
#include "bathymetry/Settings.h"
#include "bathymetry/Text.h"
#include "bathymetry/TextFile.h"

#include <stdexcept>

namespace swellray
{

namespace
{

std::string nameOf(const Settings& settings, const std::string& key)
{
  const std::string name = settings.word(key);
  if (name.empty())
  {
    throw std::runtime_error("it does not set " + key);
  }
  return name;
}

std::vector<double> readFile(
  const std::string& name, const FileText& open, const ModelGrid& grid, const std::string& what)
{
  const std::string text = open(name);
  NumberScanner scanner(text);
  return readNodes(scanner, grid.columns, grid.rows, true, what + " in '" + name + "'");
}

}

ModelGrid readXbeachGrid(const std::string& params, const FileText& open)
{
  const Settings settings(params);
  ModelGrid grid;
  const std::string form = plain(settings.word("gridform"));
  const std::string depfile = nameOf(settings, "depfile");
  if (form == "delft3d")
  {
    grid = readDelft3dGrid(open(nameOf(settings, "xyfile")), open(depfile));
  }
  else if (form.empty() || form == "xbeach")
  {
    grid.columns = wholeNumber(settings.number("nx"), "nx", MostNodes) + 1;
    grid.rows =
      static_cast<std::size_t>(settings.number("ny") == 0.0 ? 0 : wholeNumber(settings.number("ny"), "ny", MostNodes)) +
      1;
    const glm::dvec2 origin(settings.number("xori", 0.0), settings.number("yori", 0.0));
    const bool steps = settings.number("vardx", settings.has("xfile") && !settings.has("dx") ? 1.0 : 0.0) == 0.0;
    const double dx = steps ? settings.number("dx") : 1.0;
    const double dy = steps ? settings.number("dy") : 1.0;
    if (!(dx > 0.0 && dy > 0.0))
    {
      throw std::runtime_error("dx and dy must be above 0, not " + text(dx) + " and " + text(dy));
    }
    grid.layOut(origin, settings.number("alfa", 0.0), dx, dy);
    if (!steps)
    {
      const std::vector<double> x = readFile(nameOf(settings, "xfile"), open, grid, "x");
      const std::vector<double> y = readFile(nameOf(settings, "yfile"), open, grid, "y");
      grid.places.reserve(x.size());
      for (std::size_t i = 0; i < x.size(); ++i)
      {
        grid.places.push_back(origin + x[i] * grid.columnStep + y[i] * grid.rowStep);
      }
    }
    grid.values = readFile(depfile, open, grid, "values");
  }
  else
  {
    throw std::runtime_error("its gridform '" + settings.word("gridform") + "' is neither xbeach nor delft3d");
  }
  grid.format = "XBeach";
  const double downward = settings.number("posdwn", 1.0);
  grid.vertical.rule = downward > 0.0 ? "down" : "up";
  grid.vertical.units = "m";
  grid.vertical.unitsSource = "XBeach's unit";
  grid.vertical.ruleSource = settings.has("posdwn") ? "posdwn = " + text(downward) : "XBeach: posdwn is 1 unless set";
  return grid;
}

}
