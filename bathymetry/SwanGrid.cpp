#include "bathymetry/SwanGrid.h"

#include "bathymetry/FileGrid.h"
#include "bathymetry/Text.h"
#include "bathymetry/TextFile.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

namespace swellray
{

namespace
{

// Height of land that a grid marks without saying how high it is, m above the datum: dry at any tide.
constexpr double LeastLand = 5.0;

struct Word
{
  std::string text;
  bool quoted = false;
};

using Command = std::vector<Word>;

// Commands of a file: one a line unless it ends with & or _; $ begins a remark up to the next $ or the end, ! to the
// end.
std::vector<Command> commandsOf(const std::string& text)
{
  std::vector<Command> commands;
  bool goesOn = false;
  forLines(text,
    [&](std::string_view line)
    {
      Command words;
      bool remark = false;
      for (std::size_t i = 0; i < line.size();)
      {
        const char c = line[i];
        if (c == '$')
        {
          remark = !remark;
          ++i;
        }
        else if (remark || c == ',' || std::isspace(static_cast<unsigned char>(c)) != 0)
        {
          ++i;
        }
        else if (c == '!')
        {
          break;
        }
        else if (c == '\'' || c == '"')
        {
          const std::size_t end = std::min(line.find(c, i + 1), line.size());
          words.push_back({ std::string(line.substr(i + 1, end - i - 1)), true });
          i = end + 1;
        }
        else
        {
          const std::size_t end = std::min(line.find_first_of(" \t\r\f\v,'\"$!", i), line.size());
          words.push_back({ plain(std::string(line.substr(i, end - i))), false });
          i = end;
        }
      }
      const bool toBeContinued =
        !words.empty() && !words.back().quoted && (words.back().text.back() == '&' || words.back().text.back() == '_');
      if (toBeContinued)
      {
        words.back().text.pop_back();
        if (words.back().text.empty())
        {
          words.pop_back();
        }
      }
      if (goesOn)
      {
        Command& before = commands.back();
        before.insert(before.end(), words.begin(), words.end());
      }
      else if (!words.empty() || toBeContinued)
      {
        commands.push_back(words);
      }
      goesOn = toBeContinued;
    });
  return commands;
}

// True for the keyword in full or shortened to no fewer letters than `least`.
bool is(const Word& word, const std::string& keyword, std::size_t least)
{
  return !word.quoted && word.text.size() >= least && keyword.compare(0, word.text.size(), word.text) == 0;
}

// The words of a command, taken one after the other.
class Words
{
public:
  explicit Words(const Command& command, std::size_t first)
    : List(command)
    , At(first)
  {
  }

  bool take(const std::string& keyword, std::size_t least)
  {
    const bool found = this->At < this->List.size() && is(this->List[this->At], keyword, least);
    this->At += found ? 1 : 0;
    return found;
  }

  // A number, also as name=number.
  std::optional<double> number()
  {
    if (this->At >= this->List.size() || this->List[this->At].quoted)
    {
      return {};
    }
    const std::string& word = this->List[this->At].text;
    const std::size_t sign = word.find('=');
    double value = 0.0;
    if (!parseNumber(sign == std::string::npos ? word : word.substr(sign + 1), value))
    {
      return {};
    }
    ++this->At;
    return value;
  }

  double needNumber(const std::string& what)
  {
    const std::optional<double> value = number();
    if (!value || !std::isfinite(*value))
    {
      throw std::runtime_error(what + " is missing");
    }
    return *value;
  }

  std::string needName(const std::string& what)
  {
    if (this->At >= this->List.size() || !this->List[this->At].quoted)
    {
      throw std::runtime_error(what + " names no file in quotes");
    }
    return this->List[this->At++].text;
  }

  bool find(const std::string& keyword, std::size_t least)
  {
    for (std::size_t i = this->At; i < this->List.size(); ++i)
    {
      if (is(this->List[i], keyword, least))
      {
        this->At = i + 1;
        return true;
      }
    }
    return false;
  }

private:
  const Command& List;
  std::size_t At;
};

struct Layout
{
  double factor = 1.0;
  std::string file;
  int idla = 1;
  std::size_t headerLines = 0;
};

struct Deck
{
  bool spherical = false;
  bool curvilinear = false;
  bool inputGiven = false;
  glm::dvec2 origin{ 0.0 };
  double angle = 0.0;
  glm::dvec2 spacing{ 0.0 };
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::optional<double> exception;
  std::size_t gridColumns = 0; // of the computational grid where it is curvilinear
  std::size_t gridRows = 0;
  std::vector<double> gridExceptions;
  std::optional<Layout> coordinates;
  std::optional<Layout> bottom;
  double level = 0.0;
};

// Nodes of a number of meshes.
std::size_t nodes(double meshes, const std::string& what)
{
  return wholeNumber(meshes, what, MostNodes) + 1;
}

Layout readLayout(Words words, const std::string& command, bool headerForEach)
{
  Layout layout;
  layout.factor = words.number().value_or(1.0);
  if (words.take("series", 3))
  {
    throw std::runtime_error(command + ": a series in time is not read; name one field with FREE format");
  }
  layout.file = words.needName(command);
  const double idla = words.number().value_or(1.0);
  if (!(idla >= 1.0 && idla <= 6.0) || idla != std::floor(idla))
  {
    throw std::runtime_error(command + ": [idla] must be 1 to 6, not " + text(idla));
  }
  layout.idla = static_cast<int>(idla);
  double lines = words.number().value_or(0.0);
  lines += headerForEach ? words.number().value_or(0.0) : 0.0;
  if (!(lines >= 0.0 && lines <= static_cast<double>(MostNodes)))
  {
    throw std::runtime_error(command + ": [nhedf] must be 0 or more, not " + text(lines));
  }
  layout.headerLines = static_cast<std::size_t>(lines);
  if (words.find("format", 3) || words.find("unformatted", 3))
  {
    throw std::runtime_error(command + ": only FREE format is read; write '" + layout.file + "' so");
  }
  return layout;
}

void readInputGrid(const Command& command, Deck& deck)
{
  static const char* const others[] = { "wlevel", "current", "vx", "vy", "friction", "wind", "wx", "wy", "nplants",
    "turbvisc", "mudlayer", "aice", "hice", "hss", "tss", "dss" };
  for (const char* other : others)
  {
    if (command.size() > 1 && is(command[1], other, 2))
    {
      return;
    }
  }
  Words words(command, 1);
  words.take("bottom", 3);
  deck.inputGiven = true;
  if (words.take("unstructured", 6))
  {
    throw std::runtime_error("INPGRID: an unstructured bottom is not read; bring it to a regular grid first");
  }
  deck.curvilinear = words.take("curvilinear", 4);
  if (deck.curvilinear)
  {
    const double staggerX = words.number().value_or(0.0);
    const double staggerY = words.number().value_or(0.0);
    if (staggerX != 0.0 || staggerY != 0.0)
    {
      throw std::runtime_error("INPGRID: a bottom staggered against the grid ([stagrx], [stagry]) is not read");
    }
    const std::optional<double> columns = words.number();
    const std::optional<double> rows = words.number();
    deck.columns = columns ? nodes(*columns, "INPGRID: [mxinp]") : 0;
    deck.rows = rows ? nodes(*rows, "INPGRID: [myinp]") : 0;
  }
  else
  {
    words.take("regular", 3);
    deck.origin.x = words.needNumber("INPGRID: [xpinp]");
    deck.origin.y = words.needNumber("INPGRID: [ypinp]");
    deck.angle = words.needNumber("INPGRID: [alpinp]");
    deck.columns = nodes(words.needNumber("INPGRID: [mxinp]"), "INPGRID: [mxinp]");
    deck.rows = nodes(words.needNumber("INPGRID: [myinp]"), "INPGRID: [myinp]");
    deck.spacing.x = words.needNumber("INPGRID: [dxinp]");
    deck.spacing.y = words.needNumber("INPGRID: [dyinp]");
    if (!(deck.spacing.x > 0.0 && deck.spacing.y > 0.0))
    {
      throw std::runtime_error(
        "INPGRID: [dxinp] and [dyinp] must be above 0, not " + text(deck.spacing.x) + " and " + text(deck.spacing.y));
    }
  }
  if (words.find("nonstationary", 7))
  {
    throw std::runtime_error("INPGRID: a bottom that changes in time is not read");
  }
  if (words.find("exception", 3))
  {
    deck.exception = words.needNumber("INPGRID: [excval]");
  }
}

void readComputationalGrid(const Command& command, Deck& deck)
{
  Words words(command, 1);
  if (words.take("curvilinear", 4))
  {
    deck.gridColumns = nodes(words.needNumber("CGRID: [mxc]"), "CGRID: [mxc]");
    deck.gridRows = nodes(words.needNumber("CGRID: [myc]"), "CGRID: [myc]");
    if (words.take("exception", 3))
    {
      const double x = words.needNumber("CGRID: [xexc]");
      deck.gridExceptions = { x, words.number().value_or(x) };
    }
  }
}

Deck readDeck(const std::string& text)
{
  Deck deck;
  for (const Command& command : commandsOf(text))
  {
    if (command.empty())
    {
      continue;
    }
    if (is(command[0], "cgrid", 2))
    {
      readComputationalGrid(command, deck);
    }
    else if (is(command[0], "inpgrid", 3))
    {
      readInputGrid(command, deck);
    }
    else if (is(command[0], "readgrid", 5) && command.size() > 1 && is(command[1], "coordinates", 4))
    {
      deck.coordinates = readLayout(Words(command, 2), "READGRID", true);
    }
    else if (is(command[0], "readinp", 4) && command.size() > 1 && is(command[1], "bottom", 3))
    {
      deck.bottom = readLayout(Words(command, 2), "READINP BOTTOM", false);
    }
    else if (is(command[0], "coordinates", 4))
    {
      Words words(command, 1);
      deck.spherical = words.take("spherical", 4);
    }
    else if (is(command[0], "set", 3))
    {
      Words words(command, 1);
      const bool named = words.take("level", 3);
      const bool byName = command.size() > 1 && command[1].text.compare(0, 6, "level=") == 0;
      const bool first = command.size() > 1 && std::isdigit(static_cast<unsigned char>(command[1].text[0])) != 0;
      deck.level = named || byName || first ? words.number().value_or(0.0) : deck.level;
    }
  }
  return deck;
}

// Numbers of a map in the order of [idla], turned so that columns run fastest from the first row.
std::vector<double> readMap(
  NumberScanner& scanner, const Layout& layout, std::size_t columns, std::size_t rows, const std::string& what)
{
  const bool lines = layout.idla % 2 == 1;
  const bool byColumn = layout.idla >= 5;
  std::vector<double> map =
    readNodes(scanner, byColumn ? rows : columns, byColumn ? columns : rows, lines, what + " in '" + layout.file + "'");
  if (byColumn)
  {
    std::vector<double> turned(map.size());
    for (std::size_t column = 0; column < columns; ++column)
    {
      for (std::size_t row = 0; row < rows; ++row)
      {
        turned[row * columns + column] = map[column * rows + row];
      }
    }
    return turned;
  }
  if (layout.idla <= 2)
  {
    for (std::size_t low = 0, high = rows - 1; low < high; ++low, --high)
    {
      const auto at = [&](std::size_t row) { return map.begin() + static_cast<std::ptrdiff_t>(row * columns); };
      std::swap_ranges(at(low), at(low) + static_cast<std::ptrdiff_t>(columns), at(high));
    }
  }
  return map;
}

void readCoordinates(const Deck& deck, const FileText& open, ModelGrid& grid)
{
  if (!deck.coordinates || deck.gridColumns == 0)
  {
    throw std::runtime_error("its bottom is curvilinear, but CGRID CURVILINEAR and READGRID COORDINATES do not give "
                             "the places of the nodes");
  }
  const std::string text = open(deck.coordinates->file);
  NumberScanner scanner(text);
  scanner.skipLines(deck.coordinates->headerLines);
  const std::vector<double> x = readMap(scanner, *deck.coordinates, grid.columns, grid.rows, "x coordinates");
  scanner.startLine();
  const std::vector<double> y = readMap(scanner, *deck.coordinates, grid.columns, grid.rows, "y coordinates");
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  grid.places.reserve(x.size());
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    const bool excluded =
      !deck.gridExceptions.empty() && x[i] == deck.gridExceptions[0] && y[i] == deck.gridExceptions[1];
    grid.places.push_back(excluded ? glm::dvec2(none) : glm::dvec2(x[i], y[i]) * deck.coordinates->factor);
  }
}

void raiseExceptions(const Deck& deck, ModelGrid& grid)
{
  NoDataMark excluded;
  excluded.add(*deck.exception, true);
  double land = LeastLand;
  std::size_t count = 0;
  for (const double depth : grid.values)
  {
    count += excluded(depth) ? 1 : 0;
    land = excluded(depth) ? land : std::max(land, -depth * deck.bottom->factor);
  }
  if (count == 0)
  {
    return;
  }
  for (double& depth : grid.values)
  {
    depth = excluded(depth) ? -land / deck.bottom->factor : depth;
  }
  grid.notes.push_back(std::to_string(count) + " nodes with the exception value " + text(*deck.exception) +
    " are land of no known height: taken " + text(land) + " m high");
}

}

ModelGrid readSwanGrid(const std::string& commands, const FileText& open)
{
  const Deck deck = readDeck(commands);
  if (!deck.inputGiven || !deck.bottom)
  {
    throw std::runtime_error("it has no commands INPGRID BOTTOM and READINP BOTTOM, which name a bottom");
  }
  if (!(std::isfinite(deck.bottom->factor) && deck.bottom->factor != 0.0))
  {
    throw std::runtime_error("READINP BOTTOM: [fac] must not be 0");
  }
  ModelGrid grid;
  grid.format = "SWAN";
  grid.columns = deck.columns > 0 ? deck.columns : deck.gridColumns;
  grid.rows = deck.rows > 0 ? deck.rows : deck.gridRows;
  if (deck.curvilinear)
  {
    if (grid.columns != deck.gridColumns || grid.rows != deck.gridRows)
    {
      throw std::runtime_error("INPGRID has another number of meshes than CGRID CURVILINEAR");
    }
    readCoordinates(deck, open, grid);
  }
  else
  {
    grid.layOut(deck.origin, deck.angle, deck.spacing.x, deck.spacing.y);
  }
  const std::string text = open(deck.bottom->file);
  NumberScanner scanner(text);
  scanner.skipLines(deck.bottom->headerLines);
  grid.values = readMap(scanner, *deck.bottom, grid.columns, grid.rows, "depth");
  if (deck.exception)
  {
    raiseExceptions(deck, grid);
  }
  for (double& depth : grid.values)
  {
    depth *= deck.bottom->factor;
  }
  grid.vertical.rule = "down";
  grid.vertical.ruleSource = "SWAN bottom";
  grid.vertical.units = "m";
  grid.vertical.unitsSource = "SWAN's unit";
  if (deck.spherical)
  {
    grid.crs = "EPSG:4326";
    grid.crsSource = "COORDINATES SPHERICAL";
  }
  if (deck.level != 0.0)
  {
    grid.notes.push_back("its run sets the water level to " + swellray::text(deck.level) +
      " m: for the same say --water-level " + swellray::text(deck.level));
  }
  return grid;
}

}
