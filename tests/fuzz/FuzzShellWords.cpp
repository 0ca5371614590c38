// The command line that a file carries: whatever stands there is words that survive being joined again, or an error.
#include "FuzzInput.h"

#include "apps/cli/ShellWords.h"

#include <stdexcept>

using namespace swellray;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string line(reinterpret_cast<const char*>(data), size);
  try
  {
    const std::vector<std::string> words = cli::splitWords(line);
    fuzz::require(cli::splitWords(cli::joinWords(words)) == words);
  }
  catch (const std::invalid_argument& error)
  {
    fuzz::require(error.what()[0] != '\0');
  }
  return 0;
}
