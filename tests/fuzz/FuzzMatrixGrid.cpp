#include "FuzzInput.h"

#include "bathymetry/MatrixGrid.h"

using namespace swellray;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::vector<std::string> texts = fuzz::textsOf(data, size);
  if (isFrfTable(texts[0]))
  {
    fuzz::expectAnswer([&] { fuzz::useGrid(readFrfTable(texts[0])); });
  }
  else if (texts.size() == 2)
  {
    fuzz::expectAnswer([&] { fuzz::useGrid(readCelerisGrid(texts[0], texts[1])); });
  }
  else
  {
    fuzz::expectAnswer(
      [&] { fuzz::useGrid(readMatrixGrid(texts[0], fuzz::textAt(texts, 1), fuzz::textAt(texts, 2))); });
  }
  return 0;
}
