#include "FuzzInput.h"

#include "apps/cli/Csv.h"
#include "apps/cli/WaterLevels.h"

using namespace swellray;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string path = fuzz::writeFile("a.csv", std::string(reinterpret_cast<const char*>(data), size));
  for (const cli::CsvLine& line : cli::readCsv(path))
  {
    fuzz::require(line.number > 0 && !line.text.empty() && !line.fields.empty());
    cli::columnOf(line.fields, { "x", "lon" });
  }
  fuzz::expectAnswer([&] { fuzz::require(!cli::readWaterLevels(path).empty()); });
  return 0;
}
