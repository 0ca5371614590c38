#include "FuzzInput.h"

#include "bathymetry/SpectrumFile.h"

using namespace swellray;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string path = fuzz::writeFile("a.spc", std::string(reinterpret_cast<const char*>(data), size));
  fuzz::expectOneLine(
    [&]
    {
      const SpectrumFile read = readSpectra(path);
      fuzz::require(!read.records.empty());
      for (const SpectrumRecord& record : read.records)
      {
        record.spectrum.grid.validate();
        fuzz::require(record.spectrum.density.size() == record.spectrum.grid.size());
        for (const double density : record.spectrum.density)
        {
          fuzz::require(density >= 0.0);
        }
      }
    });
  return 0;
}
