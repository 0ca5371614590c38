#include "OptionKinds.h"

#include "Failure.h"

#include <fmt/format.h>

#include <filesystem>

namespace swellray::cli
{

const NumberRule Metres{ "metres" };
const NumberRule PositiveMetres{ "metres", 0.0, 1e300, true };
const NumberRule NonNegativeMetres{ "metres", 0.0 };
const NumberRule PositiveSeconds{ "seconds", 0.0, 1e300, true };
const NumberRule Degrees{ "degrees", -360.0, 360.0 };
const NumberRule PlainNumber{};
const NumberRule PositiveNumber{ "", 0.0, 1e300, true };
const NumberRule NonNegativeNumber{ "", 0.0 };
const NumberRule Share{ "", 0.0, 1.0 };

std::string OptionSpec::longName() const
{
  const auto comma = this->name.rfind(',');
  return comma == std::string::npos ? this->name : this->name.substr(comma + 1);
}

OptionSpec text(
  const char* name, const char* value, const char* help, const char* standard, const char* group, std::string& target)
{
  OptionSpec spec{ name, value, help, standard, group, false, {} };
  const std::string longName = spec.longName();
  spec.set = [&target, longName](const std::string& typed)
  {
    if (typed.empty())
    {
      throw UsageError(longName + " needs a value");
    }
    target = typed;
  };
  return spec;
}

OptionSpec flag(const char* name, const char* help, const char* group, bool& target)
{
  return { name, "", help, "", group, false, [&target](const std::string&) { target = true; } };
}

OptionSpec outputFile(const char* name, const char* help, std::string& target, const std::vector<std::string>& endings)
{
  OptionSpec spec{ name, "FILE", help, "", "Output", false, {} };
  const std::string longName = spec.longName();
  spec.set = [&target, longName, endings](const std::string& typed)
  {
    const std::string ending = std::filesystem::path(typed).extension().string();
    for (const std::string& allowed : endings)
    {
      if (ending == allowed)
      {
        target = typed;
        return;
      }
    }
    throw UsageError(fmt::format("{} must end in {}, not '{}'", longName, alternatives(endings), typed));
  };
  return spec;
}

void add(std::vector<OptionSpec>& options, std::vector<OptionSpec> more)
{
  for (OptionSpec& option : more)
  {
    options.push_back(std::move(option));
  }
}

}
