#include "FuzzInput.h"

#include "bathymetry/TextSoundings.h"

using namespace swellray;

// What comes before the first line of %%%% names the column of values.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::vector<std::string> texts = fuzz::textsOf(data, size);
  const std::string path = fuzz::writeFile("a.xyz", texts.back());
  const std::string variable = texts.size() > 1 ? texts[0] : std::string();
  isText(path);
  fuzz::expectAnswer(
    [&]
    {
      const Soundings read = readTextSoundings(path, variable);
      fuzz::require(read.x.size() == read.size() && read.y.size() == read.size());
      for (const std::string& note : read.notes)
      {
        fuzz::requireOneLine(note);
      }
    });
  return 0;
}
