#include "FuzzInput.h"

using namespace swellray;

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
  const std::string main =
    fuzz::writeFile(names[static_cast<unsigned char>(data[0] - 'A') % std::size(names)], texts[0]);
  for (std::size_t i = 0; i < std::size(others); ++i)
  {
    fuzz::writeFile(others[i], fuzz::textAt(texts, i + 1));
  }
  SeafloorOptions options;
  options.crop = { -1e5, -1e5, 1e6, 1e6 };
  fuzz::expectOneLine([&] { fuzz::checkSeafloor(readSeafloor(main, options)); });
  std::filesystem::remove(main);
  return 0;
}
