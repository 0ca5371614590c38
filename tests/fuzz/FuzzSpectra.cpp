#include "FuzzInput.h"

#include "bathymetry/SpectrumFile.h"

#include <cmath>

using namespace swellray;

namespace
{

// One folder a process; its files are written anew for each input.
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

// The spectra of SWAN and of buoys: further texts are the files of directions and moments beside the first. NetCDF is left
// to those who fuzz that library.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const char* const names[] = { "1w2000.txt", "1d2000.txt", "1j2000.txt", "1i2000.txt", "1k2000.txt" };
  const std::vector<std::string> texts = fuzz::textsOf(data, size);
  if (texts[0].compare(0, 3, "CDF") == 0 || texts[0].compare(0, 4, "\x89HDF") == 0)
  {
    return -1;
  }
  for (std::size_t i = 0; i < std::size(names); ++i)
  {
    std::ofstream(folder() / names[i], std::ios::binary) << fuzz::textAt(texts, i);
  }
  fuzz::expectAnswer(
    [&]
    {
      const SpectrumFile file = readSpectra((folder() / names[0]).string());
      fuzz::require(!file.records.empty());
      for (const SpectrumRecord& record : file.records)
      {
        fuzz::require(record.spectrum.density.size() == record.spectrum.grid.size());
        for (const double density : record.spectrum.density)
        {
          fuzz::require(std::isfinite(density) && density >= 0.0);
        }
      }
    });
  return 0;
}
