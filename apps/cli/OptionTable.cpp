#include "OptionTable.h"

#include "OptionGroups.h"
#include "OptionKinds.h"

#include <algorithm>

namespace swellray::cli
{

const char* const ProgramHelp =
  "Wave refraction over real seafloors: rays, heights and crests as VTK data and pictures.";
const char* const SeafloorHelp =
  "a raster, a mesh, a model's .swn, params.txt, .sim or .grd, or a built-in form NAME:key=value,... (see "
  "'swellray list')";
const char* const ExitCodes = "0 done, 1 the work failed, 2 the call is wrong.";

OptionSpec configurationOption(std::string& target)
{
  OptionSpec spec{ "--config", "FILE.toml", "read options from this file", "", "General", false, {} };
  spec.set = [&target](const std::string& typed) { target = typed; };
  return spec;
}

std::vector<CommandSpec> completeSpecs(Request& request, std::string& configuration)
{
  std::vector<CommandSpec> commands = commandSpecs(request);
  for (CommandSpec& command : commands)
  {
    command.options.push_back(configurationOption(configuration));
    add(command.options, commonOptions(request));
  }
  return commands;
}

std::vector<std::string> wordsOf(const OptionSpec& option)
{
  const std::string& value = option.value;
  const bool words = value.find('|') != std::string::npos &&
    std::none_of(value.begin(), value.end(), [](char c) { return (c >= 'A' && c <= 'Z') || c == ':'; });
  std::vector<std::string> list;
  for (std::size_t begin = 0; words && begin <= value.size();)
  {
    const std::size_t end = std::min(value.find('|', begin), value.size());
    list.push_back(value.substr(begin, end - begin));
    begin = end + 1;
  }
  return list;
}

std::string shortName(const OptionSpec& option)
{
  const auto comma = option.name.find(',');
  return comma == std::string::npos ? "" : option.name.substr(0, comma);
}

bool takesFile(const OptionSpec& option)
{
  return option.value.find("FILE") != std::string::npos;
}

bool takesFolder(const OptionSpec& option)
{
  return option.value == "FOLDER";
}

}
