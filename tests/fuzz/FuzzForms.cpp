#include "FuzzInput.h"

#include "sim/BuiltinCurrent.h"
#include "sim/BuiltinSeafloor.h"

using namespace swellray;

namespace
{

template <typename Make>
void expectForm(const Make& make)
{
  try
  {
    fuzz::require(make());
  }
  catch (const std::invalid_argument& error)
  {
    fuzz::require(error.what()[0] != '\0');
  }
}

}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string spec(reinterpret_cast<const char*>(data), size);
  isBuiltinSeafloor(spec);
  resemblesBuiltinSeafloor(spec);
  expectForm(
    [&]
    {
      const std::unique_ptr<Seafloor> form = makeBuiltinSeafloor(spec);
      const Rectangle box = form->bounds();
      fuzz::require(std::isfinite(form->elevation(0.5 * (box.low + box.high))));
      return form != nullptr;
    });
  isBuiltinCurrent(spec);
  resemblesBuiltinCurrent(spec);
  expectForm([&] { return makeBuiltinCurrent(spec) != nullptr; });
  return 0;
}
