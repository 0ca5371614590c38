#include "Commands.h"

#include "sim/BuiltinCurrent.h"
#include "sim/BuiltinSeafloor.h"
#include "sim/sections/WaveSection.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

namespace swellray::cli
{

namespace
{

std::string rangeText(const FormKey& key)
{
  std::string text;
  if (!key.words.empty())
  {
    for (const std::string& word : key.words)
    {
      text += (text.empty() ? "" : "|") + word;
    }
    return text;
  }
  return std::isfinite(key.low) && std::isfinite(key.high) ? fmt::format("{:g} to {:g}", key.low, key.high) : "";
}

void print(const FormDescription& form)
{
  std::printf("\n%s\n", fmt::format("{}: {}", form.name, form.summary).c_str());
  if (!form.formula.empty())
  {
    std::printf("  %s\n", form.formula.c_str());
  }
  if (!form.source.empty())
  {
    std::printf("  %s\n", form.source.c_str());
  }
  for (const FormKey& key : form.keys)
  {
    const std::string standard = key.words.empty() ? fmt::format("{:g}", key.value) : key.words.front();
    const std::string unit = key.unit == "-" ? "" : key.unit;
    std::string about = key.description;
    about += key.symbol.empty() || key.symbol == key.name ? "" : fmt::format(" ({})", key.symbol);
    about += key.kind.empty() ? "" : fmt::format("; kind={}", key.kind);
    std::printf(
      "%s\n", fmt::format("    {:<16} {:>9} {:<5} {}; {}", key.name, standard, unit, about, rangeText(key)).c_str());
  }
}

void runList()
{
  std::printf("Built-in seafloors: NAME or NAME:key=value,...\n");
  for (const FormDescription& form : builtinForms())
  {
    print(form);
    std::printf("%s\n",
      fmt::format("  Waves that suit it: --period {:g} --direction {:g}", form.period, form.directionFrom).c_str());
  }
  std::printf("\nBuilt-in currents: --current NAME or NAME:key=value,..., in the metres of the scene\n");
  for (const FormDescription& form : builtinCurrents())
  {
    print(form);
  }
  std::printf("\nVertical sections of waves: surface --profile NAME or NAME:key=value,...\n");
  for (const FormDescription& form : waveSections())
  {
    print(form);
  }
}

}

CommandSpec listSpec()
{
  CommandSpec spec{ "list",
    "list the built-in seafloors, currents and wave sections with their keys, units and defaults", false, {}, {} };
  spec.examples = "  swellray list\n";
  spec.run = [](const Request&, Console&) { runList(); };
  return spec;
}

}
