#include "FuzzInput.h"

#include "bathymetry/GridSoundings.h"

using namespace swellray;

// Options, then three bytes a sounding on a coarse lattice: many lie on one line, on one circle or at one place. With
// cells every four of them are a face.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if (size < 3)
  {
    return -1;
  }
  const unsigned kind = data[0];
  const double scale = std::pow(10.0, static_cast<int>(data[1] % 12) - 6);
  const double origin = data[1] >= 128 ? 1e6 : 0.0;
  Soundings soundings;
  if (kind & 1)
  {
    soundings.crs = "EPSG:4326";
  }
  for (std::size_t at = 3; at + 2 < size; at += 3)
  {
    const auto number = [&](std::size_t i) { return static_cast<double>(static_cast<std::int8_t>(data[at + i])); };
    soundings.add(origin + scale * number(0), scale * number(1), number(2) == 127.0 ? NAN : number(2));
  }
  if (kind & 2)
  {
    soundings.cellOffsets.push_back(0);
    for (std::size_t i = 0; i + 3 < soundings.size(); i += 4)
    {
      for (std::size_t corner = 0; corner < 4; ++corner)
      {
        soundings.cellNodes.push_back(static_cast<std::uint32_t>(i + corner));
      }
      soundings.cellOffsets.push_back(soundings.cellNodes.size());
    }
  }
  SeafloorOptions options;
  options.dropOutliers = kind & 4;
  options.crossValidate = kind & 8;
  if (kind & 16)
  {
    options.resample = scale * (1.0 + data[2]);
  }
  if (kind & 32)
  {
    options.maxGap = scale * data[2];
  }
  fuzz::expectAnswer(
    [&]
    {
      const GriddedSoundings made = gridSoundings(soundings, options);
      fuzz::require(made.grid.elevation.size() == made.grid.columns * made.grid.rows);
      for (const double z : made.grid.elevation)
      {
        fuzz::require(!std::isinf(z));
      }
    });
  return 0;
}
