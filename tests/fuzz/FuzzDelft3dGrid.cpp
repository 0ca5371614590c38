#include "FuzzInput.h"

#include "bathymetry/Delft3dGrid.h"

using namespace swellray;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::vector<std::string> texts = fuzz::textsOf(data, size);
  isDelft3dGrid(texts[0]);
  fuzz::expectAnswer([&] { fuzz::useGrid(readDelft3dGrid(texts[0], fuzz::textAt(texts, 1))); });
  return 0;
}
