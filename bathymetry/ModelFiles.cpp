#include "bathymetry/ModelFiles.h"

#include "bathymetry/Delft3dGrid.h"
#include "bathymetry/MatrixGrid.h"
#include "bathymetry/Settings.h"
#include "bathymetry/StwaveGrid.h"
#include "bathymetry/SwanGrid.h"
#include "bathymetry/Text.h"
#include "bathymetry/TextFile.h"
#include "bathymetry/XbeachGrid.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <vector>

namespace swellray
{

namespace
{

namespace fs = std::filesystem;

std::string endingOf(const fs::path& path)
{
  return plain(path.extension().string());
}

// The beginning of a file, empty where it cannot be read or is no text.
std::string headOf(const fs::path& path)
{
  constexpr std::size_t length = 65536;
  std::string head(length, '\0');
  std::ifstream stream(path, std::ios::binary);
  stream.read(head.data(), static_cast<std::streamsize>(length));
  head.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream.gcount(), 0)));
  return head.find('\0') == std::string::npos ? head : std::string();
}

using Files = std::vector<std::string>;

// The text of a file, which is then one of those that were read.
std::string readText(const fs::path& path, Files& files)
{
  files.push_back(path.string());
  return readTextFile(path.string());
}

// Texts of the files that one file names, in its folder.
FileText besides(const fs::path& path, Files& files)
{
  return [path, &files](const std::string& name)
  {
    std::string portable = name;
    std::replace(portable.begin(), portable.end(), '\\', '/');
    std::error_code error;
    fs::path found = path.parent_path() / portable;
    if (!fs::exists(found, error))
    {
      const fs::path here = path.parent_path() / fs::path(portable).filename();
      found = fs::exists(here, error) ? here : found;
    }
    return readText(found, files);
  };
}

// Files of a folder with this ending, in the order of their names.
std::vector<fs::path> filesBeside(const fs::path& path, const std::string& ending)
{
  std::vector<fs::path> found;
  std::error_code error;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
  {
    if (endingOf(entry->path()) == ending && fs::is_regular_file(entry->path(), error))
    {
      found.push_back(entry->path());
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

// The file of one coordinate that goes with the file of z: z_NAME or NAME_z with another letter.
std::optional<fs::path> companion(const fs::path& path, char letter)
{
  std::string stem = path.stem().string();
  const auto isZ = [](char c) { return c == 'z' || c == 'Z'; };
  const bool first = !stem.empty() && isZ(stem[0]) && (stem.size() == 1 || stem[1] == '_');
  const bool last = stem.size() > 2 && isZ(stem.back()) && stem[stem.size() - 2] == '_';
  if (!first && !last)
  {
    return {};
  }
  char& place = first ? stem.front() : stem.back();
  place = place == 'z' ? letter : static_cast<char>(letter - 'a' + 'A');
  for (const std::string& ending : { path.extension().string(), std::string(".grd"), std::string(".txt") })
  {
    const fs::path candidate = path.parent_path() / (stem + ending);
    std::error_code error;
    if (fs::is_regular_file(candidate, error))
    {
      return candidate;
    }
  }
  return {};
}

std::optional<ModelGrid> readMatrices(const fs::path& path, Files& files)
{
  const std::optional<fs::path> x = companion(path, 'x');
  const std::optional<fs::path> y = companion(path, 'y');
  if (!x || !y || headOf(path).empty())
  {
    return {};
  }
  return readMatrixGrid(readText(*x, files), readText(*y, files), readText(path, files));
}

ModelGrid readDelft3dFiles(const fs::path& path, Files& files)
{
  // An XBeach run may use such a grid; its params.txt then says which way its depths count.
  std::error_code error;
  const fs::path params = path.parent_path() / "params.txt";
  if (fs::exists(params, error))
  {
    const std::string text = readText(params, files);
    if (fs::path(Settings(text).word("xyfile")).filename() == path.filename())
    {
      return readXbeachGrid(text, besides(path, files));
    }
  }
  fs::path depth = path;
  depth.replace_extension(".dep");
  if (!fs::exists(depth, error))
  {
    const std::vector<fs::path> candidates = filesBeside(path, ".dep");
    if (candidates.size() != 1)
    {
      throw std::runtime_error("it is a Delft3D grid, but which of " + std::to_string(candidates.size()) +
        " .dep files beside it has its depths? Name that as '" + depth.filename().string() +
        "', or name the .mdf file");
    }
    depth = candidates.front();
  }
  ModelGrid grid = readDelft3dGrid(readText(path, files), readText(depth, files));
  grid.notes.push_back("depths from '" + depth.filename().string() + "'");
  return grid;
}

ModelGrid readDelft3dRun(const fs::path& path, Files& files)
{
  const std::string run = readText(path, files);
  const Settings settings(run);
  const std::string grid = settings.word("filcco");
  const std::string depth = settings.word("fildep");
  if (grid.empty() || depth.empty())
  {
    throw std::runtime_error("it does not name a grid and its depths (Filcco, Fildep)");
  }
  if (plain(settings.word("dpsopt")) == "dp")
  {
    throw std::runtime_error(
      "its depths lie at the cells' centres (Dpsopt = DP), which are not read; bring them to the "
      "corners first");
  }
  const FileText open = besides(path, files);
  return readDelft3dGrid(open(grid), open(depth));
}

// A matrix of numbers in a .txt file whose size a configuration beside it has.
std::optional<ModelGrid> readCelerisFiles(const fs::path& path, Files& files)
{
  constexpr std::uintmax_t longest = 1000000; // a configuration is a page of text
  std::optional<std::string> fits;
  std::size_t columns = 0;
  for (const fs::path& candidate : filesBeside(path, ".json"))
  {
    std::error_code error;
    const std::uintmax_t size = fs::file_size(candidate, error);
    if (error || size > longest)
    {
      continue;
    }
    const std::string head = headOf(path);
    const std::string line = head.substr(0, head.find('\n'));
    if (columns == 0)
    {
      NumberScanner scanner(line);
      while (!scanner.word().empty())
      {
        ++columns;
      }
    }
    const std::string text = readTextFile(candidate.string());
    std::size_t width = 0;
    std::size_t height = 0;
    if (isCelerisConfiguration(text, width, height) && width == columns)
    {
      if (fits)
      {
        throw std::runtime_error("several .json files beside it have its size; leave one");
      }
      fits = text;
      files.push_back(candidate.string());
    }
  }
  if (!fits)
  {
    return {};
  }
  return readCelerisGrid(readText(path, files), *fits);
}

std::optional<ModelGrid> readByKind(const fs::path& path, Files& files)
{
  const std::string ending = endingOf(path);
  const std::string name = plain(path.filename().string());
  if (ending == ".swn")
  {
    return readSwanGrid(readText(path, files), besides(path, files));
  }
  if (ending == ".sim")
  {
    return readStwaveGrid(readText(path, files), besides(path, files));
  }
  if (ending == ".txt" && name.find("params") != std::string::npos)
  {
    return readXbeachGrid(readText(path, files), besides(path, files));
  }
  if (ending == ".mdf")
  {
    return readDelft3dRun(path, files);
  }
  if (std::optional<ModelGrid> grid = readMatrices(path, files))
  {
    return grid;
  }
  if (ending == ".grd" && isDelft3dGrid(headOf(path)))
  {
    return readDelft3dFiles(path, files);
  }
  if (ending == ".grid" && isFrfTable(headOf(path)))
  {
    return readFrfTable(readText(path, files));
  }
  if (ending == ".txt")
  {
    return readCelerisFiles(path, files);
  }
  if (ending == ".bot" || ending == ".dep")
  {
    throw std::runtime_error(
      "it holds depths without their places; name the file that has these: SWAN's .swn, STWAVE's "
      ".sim, Delft3D's .mdf or .grd, or XBeach's params.txt");
  }
  return {};
}

}

std::optional<ModelGrid> readModelGrid(const std::string& path)
{
  std::error_code error;
  if (!fs::is_regular_file(path, error))
  {
    return {};
  }
  Files files;
  std::optional<ModelGrid> grid = readByKind(path, files);
  if (grid)
  {
    grid->files = std::move(files);
  }
  if (grid && !grid->places.empty())
  {
    grid->makeRegular();
  }
  return grid;
}

}
