#pragma once

#include "bathymetry/SwanGrid.h"

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

/** Stops the fuzzer where a promise is broken. */
inline void require(bool kept)
{
  if (!kept)
  {
    std::abort();
  }
}

/** Read; an error with one line is an answer, everything else stops the fuzzer. */
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
