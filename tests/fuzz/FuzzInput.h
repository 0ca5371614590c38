#pragma once

#include "bathymetry/SeafloorReader.h"
#include "bathymetry/SwanGrid.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <unistd.h>
#include <vector>

namespace swellray::fuzz
{

/** The texts of an input, which lines of %%%% separate. */
inline std::vector<std::string> textsOf(const std::uint8_t* data, std::size_t size)
{
  const std::string separator = "%%%%\n";
  std::string all(reinterpret_cast<const char*>(data), size);
  std::vector<std::string> texts;
  for (std::size_t at = all.find(separator); at != std::string::npos; at = all.find(separator))
  {
    texts.push_back(all.substr(0, at));
    all.erase(0, at + separator.size());
  }
  texts.push_back(all);
  return texts;
}

/** Text `i` of several, empty where there are fewer. */
inline std::string textAt(const std::vector<std::string>& texts, std::size_t i)
{
  return i < texts.size() ? texts[i] : std::string();
}

/** Whatever file is named, the next of the texts after the first. */
inline FileText nextOf(const std::vector<std::string>& texts, std::size_t& next)
{
  return [&texts, &next](const std::string& name)
  {
    if (++next >= texts.size())
    {
      throw std::runtime_error("'" + name + "' is missing: no such file");
    }
    return texts[next];
  };
}

/** A folder of this process in which inputs become files; it goes with the process. */
inline const std::filesystem::path& folder()
{
  static const std::filesystem::path path = []
  {
    const auto made = std::filesystem::temp_directory_path() / ("swellray-fuzz-" + std::to_string(getpid()));
    std::filesystem::create_directories(made);
    std::atexit([] { std::filesystem::remove_all(folder()); });
    return made;
  }();
  return path;
}

/** Makes a file of that folder anew; returns its path. */
inline std::string writeFile(const std::string& name, const std::string& text)
{
  const std::filesystem::path path = folder() / name;
  std::ofstream(path, std::ios::binary) << text;
  return path.string();
}

/** Stops the fuzzer where a promise is broken. */
inline void require(bool kept)
{
  if (!kept)
  {
    std::abort();
  }
}

/** Words for people are some, on one line. */
inline void requireOneLine(const std::string& words)
{
  require(!words.empty() && words.find('\n') == std::string::npos);
}

/** Read; an error that says something is an answer, everything else stops the fuzzer. */
template <typename Read>
void expectAnswer(const Read& read)
{
  try
  {
    read();
  }
  catch (const std::runtime_error& error)
  {
    require(error.what()[0] != '\0');
  }
}

/** The same where the error is what a user is told: it must be one line. */
template <typename Read>
void expectOneLine(const Read& read)
{
  try
  {
    read();
  }
  catch (const std::runtime_error& error)
  {
    requireOneLine(error.what());
  }
}

/** What every seafloor that was read keeps to. */
inline void checkSeafloor(const Bathymetry& read)
{
  require(read.grid.elevation.size() == read.grid.columns * read.grid.rows);
  require(read.report.waterShare > 0.0 && std::isfinite(read.report.lowest));
  for (const auto& [label, words] : read.report.lines())
  {
    require(!label.empty());
    requireOneLine(words);
  }
}

/** What every model's grid keeps to; then what is made of it is made. */
inline void useGrid(ModelGrid&& grid)
{
  require(grid.values.size() == grid.columns * grid.rows);
  require(grid.places.empty() || grid.places.size() == grid.values.size());
  if (grid.places.empty() || grid.makeRegular())
  {
    const auto raster = rasterOf(std::move(grid));
    const RasterHeader& header = raster->header();
    require(raster->read({ 0, 0, header.columns, header.rows }, -999.0).size() == header.columns * header.rows);
    return;
  }
  const Soundings soundings = soundingsOf(std::move(grid));
  require(soundings.x.size() == soundings.size() && soundings.y.size() == soundings.size());
  require(!soundings.cellOffsets.empty() && soundings.cellOffsets.back() == soundings.cellNodes.size());
  for (const std::uint32_t node : soundings.cellNodes)
  {
    require(node < soundings.size());
  }
}

}
