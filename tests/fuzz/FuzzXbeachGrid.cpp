#include "FuzzInput.h"

#include "bathymetry/XbeachGrid.h"

using namespace swellray;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::vector<std::string> texts = fuzz::textsOf(data, size);
  std::size_t next = 0;
  fuzz::expectAnswer([&] { fuzz::useGrid(readXbeachGrid(texts[0], fuzz::nextOf(texts, next))); });
  return 0;
}
