#include "FuzzInput.h"

#include "bathymetry/SeafloorReader.h"

#include <cmath>

using namespace swellray;

namespace
{

// One folder a process; the file of each ending is written anew for each input.
const std::filesystem::path& folder()
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

}

// The first letter chooses the kind of file; further texts become the files beside it. Binary rasters are left to those
// who fuzz GDAL and netCDF: a header of netCDF may make that library allocate what it claims.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const char* const names[] = { "a.asc", "a.swn", "a.sim", "params.txt", "a.grd", "z_a.grd", "a.grid", "a.txt",
    "a.csv", "a.xyz", "a.dat" };
  static const char* const others[] = { "a.dep", "x_a.grd", "y_a.grd", "a.json" };
  if (size < 1)
  {
    return -1;
  }
  const std::vector<std::string> texts = fuzz::textsOf(data + 1, size - 1);
  const std::filesystem::path main = folder() / names[static_cast<unsigned char>(data[0] - 'A') % std::size(names)];
  const auto write = [](const std::filesystem::path& path, const std::string& text)
  { std::ofstream(path, std::ios::binary) << text; };
  write(main, texts[0]);
  for (std::size_t i = 0; i < std::size(others); ++i)
  {
    write(folder() / others[i], fuzz::textAt(texts, i + 1));
  }
  SeafloorOptions options;
  options.crop = { -1e5, -1e5, 1e6, 1e6 };
  fuzz::expectAnswer(
    [&]
    {
      const Bathymetry read = readSeafloor(main.string(), options);
      fuzz::require(read.grid.elevation.size() == read.grid.columns * read.grid.rows);
      fuzz::require(read.report.waterShare > 0.0 && std::isfinite(read.report.lowest));
      for (const auto& [label, words] : read.report.lines())
      {
        fuzz::require(!label.empty() && words.find('\n') == std::string::npos);
      }
    });
  std::filesystem::remove(main);
  return 0;
}
