#include "bathymetry/Delft3dGrid.h"

#include "bathymetry/FileGrid.h"
#include "bathymetry/Text.h"
#include "bathymetry/TextFile.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace swellray
{

namespace
{

constexpr double None = std::numeric_limits<double>::quiet_NaN();

// A depth that is none (manual, appendix A.2.3).
constexpr double NoDepth = -999.0;

bool startsRow(std::string_view word)
{
  return plain(std::string(word.substr(0, 4))) == "eta=";
}

// Rows of one coordinate, each after its own ETA= and number.
std::vector<double> readRows(NumberScanner& scanner, std::size_t columns, std::size_t rows, const std::string& what)
{
  std::vector<double> values;
  for (std::size_t row = 0; row < rows; ++row)
  {
    const std::string_view word = scanner.word();
    double number = 0.0;
    const bool begins = startsRow(word) && parseNumber(word.size() > 4 ? word.substr(4) : scanner.word(), number);
    if (!begins || number != static_cast<double>(row + 1))
    {
      throw std::runtime_error("its row " + std::to_string(row + 1) + " of " + std::to_string(rows) + " of " + what +
        " does not begin with ETA= and its number (line " + std::to_string(scanner.line()) + ")");
    }
    for (std::size_t column = 0; column < columns; ++column)
    {
      double value = 0.0;
      if (startsRow(scanner.peek()) || !scanner.next(value))
      {
        throw std::runtime_error("its row " + std::to_string(row + 1) + " of " + what + " has " +
          std::to_string(column) + " of " + std::to_string(columns) + " values");
      }
      values.push_back(value);
    }
  }
  return values;
}

void readPlaces(const std::string& grd, ModelGrid& grid)
{
  double missing = 0.0;
  bool spherical = false;
  std::size_t skipped = 0;
  bool header = true;
  forLines(grd,
    [&](std::string_view line)
    {
      const std::string words = header ? plain(std::string(line)) : std::string();
      const std::size_t sign = words.find('=');
      const bool remark = words.empty() || words[0] == '*';
      if (!header || (!remark && sign == std::string::npos))
      {
        header = false;
        return;
      }
      ++skipped;
      if (!remark && words.compare(0, 10, "coordinate") == 0)
      {
        spherical = words.find("spherical", sign) != std::string::npos;
      }
      else if (!remark && words.compare(0, 7, "missing") == 0 && !parseNumber(plain(words.substr(sign + 1)), missing))
      {
        throw std::runtime_error("its missing value '" + words.substr(sign + 1, 20) + "' is no number");
      }
    });
  NumberScanner scanner(grd);
  scanner.skipLines(skipped);
  double size[2] = { 0.0, 0.0 };
  if (!scanner.next(size[0]) || !scanner.next(size[1]))
  {
    throw std::runtime_error("it does not give the size of its grid");
  }
  grid.columns = wholeNumber(size[0], "the number of its columns", MostNodes);
  grid.rows = wholeNumber(size[1], "the number of its rows", MostNodes);
  if (grid.columns > MostNodes / grid.rows)
  {
    throw std::runtime_error("it has " + std::to_string(grid.columns) + " x " + std::to_string(grid.rows) +
      " nodes, above the limit of " + std::to_string(MostNodes / 1000000) + " million");
  }
  // Three numbers that newer files leave at 0, or none.
  scanner.startLine();
  while (!scanner.peek().empty() && !startsRow(scanner.peek()))
  {
    scanner.word();
  }
  const std::vector<double> x = readRows(scanner, grid.columns, grid.rows, "x");
  const std::vector<double> y = readRows(scanner, grid.columns, grid.rows, "y");
  grid.places.reserve(x.size());
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    grid.places.push_back(x[i] == missing && y[i] == missing ? glm::dvec2(None) : glm::dvec2(x[i], y[i]));
  }
  if (spherical)
  {
    grid.crs = "EPSG:4326";
    grid.crsSource = "spherical coordinates";
  }
}

}

bool isDelft3dGrid(const std::string& text)
{
  constexpr std::size_t head = 20000; // the comments before the first row are far shorter
  return plain(text.substr(0, head)).find("eta=") != std::string::npos;
}

ModelGrid readDelft3dGrid(const std::string& grd, const std::string& dep)
{
  ModelGrid grid;
  grid.format = "Delft3D";
  readPlaces(grd, grid);

  // A last column and a last row without a corner of their own, or without them.
  std::size_t count = 0;
  {
    NumberScanner counter(dep);
    double value = 0.0;
    for (; count <= (grid.columns + 1) * (grid.rows + 1) && counter.next(value); ++count)
    {
    }
  }
  const std::size_t extra = count == grid.columns * grid.rows ? 0 : 1;
  if (count != (grid.columns + extra) * (grid.rows + extra))
  {
    throw std::runtime_error("its depth file has " + std::to_string(count) + " values or more; a grid of " +
      std::to_string(grid.columns) + " x " + std::to_string(grid.rows) + " nodes takes " +
      std::to_string((grid.columns + 1) * (grid.rows + 1)));
  }
  NumberScanner scanner(dep);
  const std::vector<double> all = readNodes(scanner, grid.columns + extra, grid.rows + extra, false, "depth");
  grid.values.reserve(grid.columns * grid.rows);
  for (std::size_t row = 0; row < grid.rows; ++row)
  {
    for (std::size_t column = 0; column < grid.columns; ++column)
    {
      const double depth = all[row * (grid.columns + extra) + column];
      grid.values.push_back(depth == NoDepth ? None : depth);
    }
  }
  grid.vertical.rule = "down";
  grid.vertical.ruleSource = "Delft3D depth";
  grid.vertical.units = "m";
  grid.vertical.unitsSource = "Delft3D's unit";
  return grid;
}

}
