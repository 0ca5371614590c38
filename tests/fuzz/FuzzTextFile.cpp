#include "FuzzInput.h"

#include "bathymetry/Settings.h"
#include "bathymetry/TextFile.h"

#include <cmath>

using namespace swellray;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string text(reinterpret_cast<const char*>(data), size);
  fuzz::expectAnswer(
    [&]
    {
      // Few enough that a long repeat ends.
      NumberScanner scanner(text);
      double value = 0.0;
      for (int i = 0; i < 100000 && scanner.next(value); ++i)
      {
        if (i % 7 == 3)
        {
          scanner.startLine();
        }
      }
    });
  fuzz::expectAnswer(
    [&]
    {
      const Matrix matrix = readMatrix(text);
      fuzz::require(matrix.values.size() == matrix.columns * matrix.rows);
    });
  const Settings settings(text);
  fuzz::expectAnswer([&] { fuzz::require(std::isfinite(settings.number("nx"))); });
  settings.word("depfile");
  return 0;
}
