// The only file that includes CLI11, which takes seconds to compile.
#include "CommandLine.h"

#include "Failure.h"
#include "OptionGroups.h"
#include "OptionKinds.h"
#include "OptionTable.h"
#include "ShellWords.h"
#include "Sweep.h"
#include "Values.h"
#include "Version.h"

#include "sim/forms/NearestWord.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <fstream>

namespace swellray::cli
{

namespace
{

constexpr std::size_t HelpColumn = 34;

std::vector<std::string> namesOf(const OptionSpec& spec)
{
  return CLI::detail::split_names(spec.name);
}

// One option of a command, and whether the command line gave it.
struct Registered
{
  OptionSpec spec;
  CLI::Option* option = nullptr;
};

Registered registerOption(CLI::App& app, const OptionSpec& spec)
{
  std::string help = spec.help;
  if (spec.required)
  {
    help += " (required)";
  }
  else if (!spec.standard.empty())
  {
    help += " [" + spec.standard + "]";
  }
  Registered registered{ spec, nullptr };
  if (spec.value.empty())
  {
    registered.option = app.add_flag_function(
      spec.name, [](std::int64_t) {}, help);
  }
  else
  {
    registered.option = app.add_option(
      spec.name, [](const CLI::results_t&) { return true; }, help);
    registered.option->type_name(spec.value)->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  }
  registered.option->group(spec.group);
  return registered;
}

class Parser
{
public:
  explicit Parser(const std::vector<std::string>& words);
  std::optional<Call> read();

private:
  struct CommandApp
  {
    CommandSpec spec;
    CLI::App* app = nullptr;
    std::vector<Registered> options;
    CLI::Option* seafloor = nullptr;
    CLI::Option* file = nullptr;
  };

  void addCommand(const CommandSpec& spec);
  void parse();
  void refuseExtras() const;
  void refuseExtra(const std::string& extra, const std::vector<Registered>& known, const std::string& where) const;
  void take(Registered& registered);
  void set(const OptionSpec& spec, const std::string& value);
  std::vector<Request> sweep();
  void takeConfiguration();
  std::string lineForTheFiles() const;
  void checkSection(const CLI::ConfigItem& item) const;
  void takeConfigurationItem(const CLI::ConfigItem& item);
  bool belongsToAnyCommand(const std::string& option) const;

  std::vector<std::string> Words;    // of the call
  std::vector<std::string> FromFile; // what the configuration file adds to them
  Request Result;
  std::string ConfigFile;
  std::vector<SweepAxis> Axes;
  CLI::App App;
  std::vector<Registered> Common;
  std::vector<CommandApp> Commands;
  CommandApp* Chosen = nullptr;
};

Parser::Parser(const std::vector<std::string>& words)
  : Words(words)
  , App(ProgramHelp, "swellray")
{
  this->App.get_formatter()->column_width(HelpColumn);
  this->App.set_help_flag("-h,--help", "show this help");
  this->App.set_version_flag(
    "--version", [] { return versionText(); }, "show the version and the libraries of this build");
  this->App.require_subcommand(0, 1);
  this->App.allow_extras();
  this->App.footer(
    std::string("\n'swellray COMMAND --help' shows the options of a command and examples.\n"
                "SEAFLOOR is a file (raster, mesh, grid of a wave model, .vti) or a built-in form; see 'swellray "
                "list'.\n\n"
                "Examples:\n"
                "  swellray info harbour.tif\n"
                "  swellray trace harbour.tif --period 14 --direction 135 --height 2 -o rays.vtp\n"
                "  swellray render harbour.tif --rays rays.vtp -o picture.png\n\n"
                "Exit codes: ") +
    ExitCodes);

  std::vector<OptionSpec> common{ configurationOption(this->ConfigFile) };
  add(common, commonOptions(this->Result));
  for (const OptionSpec& spec : common)
  {
    this->Common.push_back(registerOption(this->App, spec));
  }
  for (const CommandSpec& spec : completeSpecs(this->Result, this->ConfigFile))
  {
    this->addCommand(spec);
  }
}

void Parser::addCommand(const CommandSpec& spec)
{
  CommandApp command;
  command.spec = spec;
  command.app = this->App.add_subcommand(spec.name, spec.help);
  command.app->set_help_flag("-h,--help", "show this help");
  command.app->footer("\nExamples:\n" + spec.examples);
  command.app->allow_extras();
  if (spec.takesSeafloor)
  {
    command.seafloor = command.app->add_option(
      "seafloor", [](const CLI::results_t&) { return true; }, SeafloorHelp);
    command.seafloor->type_name("")->expected(1);
  }
  if (spec.file.target)
  {
    const std::string help = spec.file.help + (spec.file.standard.empty() ? "" : " [" + spec.file.standard + "]");
    command.file = command.app->add_option(
      CLI::detail::to_lower(spec.file.name), [](const CLI::results_t&) { return true; }, help);
    command.file->type_name("")->expected(1);
  }
  for (const OptionSpec& option : spec.options)
  {
    command.options.push_back(registerOption(*command.app, option));
  }
  this->Commands.push_back(std::move(command));
}

void Parser::parse()
{
  try
  {
    // CLI11 takes the words from the last to the first, without the program.
    this->App.parse(std::vector<std::string>(this->Words.rbegin(), this->Words.rend() - 1));
  }
  catch (const CLI::ArgumentMismatch& mismatch)
  {
    // CLI11 says "--period: 1 required S missing"; the option's name is all that is of use in it.
    const std::string text = mismatch.what();
    throw UsageError(text.substr(0, text.find(':')) + " needs a value");
  }
}

void Parser::refuseExtra(const std::string& extra, const std::vector<Registered>& known, const std::string& where) const
{
  const std::string word = extra.substr(0, extra.find('='));
  if (word.size() < 2 || word[0] != '-')
  {
    throw UsageError(fmt::format("unexpected argument '{}'{}", extra, where));
  }
  std::vector<std::string> names{ "--help" };
  for (const Registered& registered : known)
  {
    const auto own = namesOf(registered.spec);
    names.insert(names.end(), own.begin(), own.end());
  }
  throw UsageError(fmt::format("unknown option '{}'{}; did you mean '{}'?", word, where, nearestWord(word, names)));
}

void Parser::refuseExtras() const
{
  if (!this->Chosen)
  {
    std::vector<std::string> names;
    for (const CommandApp& command : this->Commands)
    {
      names.push_back(command.spec.name);
    }
    for (const std::string& extra : this->App.remaining())
    {
      if (!extra.empty() && extra[0] == '-')
      {
        this->refuseExtra(extra, this->Common, "");
      }
      throw UsageError(fmt::format("unknown command '{}'; did you mean '{}'?", extra, nearestWord(extra, names)));
    }
    throw UsageError("no command given; the commands are " + alternatives(names));
  }
  const auto before = this->App.remaining();
  if (!before.empty())
  {
    this->refuseExtra(before.front(), this->Common, " before the command");
  }
  const auto after = this->Chosen->app->remaining();
  if (!after.empty())
  {
    // An option is the likelier slip: its value, left over beside it, is only a consequence.
    const auto option =
      std::find_if(after.begin(), after.end(), [](const std::string& w) { return w.rfind("--", 0) == 0; });
    this->refuseExtra(option == after.end() ? after.front() : *option, this->Chosen->options,
      fmt::format(" for '{}'", this->Chosen->spec.name));
  }
}

void Parser::set(const OptionSpec& spec, const std::string& value)
{
  if (spec.takesLists && isList(value))
  {
    this->Axes.push_back({ spec.longName(), expandList(spec.longName(), value) });
    spec.set(this->Axes.back().values.front());
    return;
  }
  spec.set(value);
}

// The request once a case, each checked. Options write into the one request, which is copied.
std::vector<Request> Parser::sweep()
{
  std::vector<Request> cases;
  const std::size_t count = this->Axes.empty() ? 0 : caseCount(this->Axes);
  for (std::size_t i = 0; i < count; ++i)
  {
    for (std::size_t axis = 0; axis < this->Axes.size(); ++axis)
    {
      for (const Registered& registered : this->Chosen->options)
      {
        if (registered.spec.longName() == this->Axes[axis].option)
        {
          registered.spec.set(caseValue(this->Axes, axis, i));
        }
      }
    }
    cases.push_back(this->Result);
    becomeCase(cases.back(), this->Axes, i);
    if (this->Chosen->spec.check)
    {
      this->Chosen->spec.check(cases.back());
    }
  }
  return cases;
}

void Parser::take(Registered& registered)
{
  if (registered.option->count() == 0)
  {
    return;
  }
  if (registered.spec.value.empty())
  {
    registered.spec.set("");
    return;
  }
  const auto values = registered.option->results();
  if (values.size() > 1 && !registered.spec.repeatable)
  {
    throw UsageError(registered.spec.longName() + " is given more than once");
  }
  for (const std::string& value : values)
  {
    this->set(registered.spec, value);
  }
}

bool Parser::belongsToAnyCommand(const std::string& option) const
{
  for (const CommandApp& command : this->Commands)
  {
    for (const Registered& registered : command.options)
    {
      if (registered.spec.longName() == option)
      {
        return true;
      }
    }
  }
  return false;
}

// Every section of the file is looked at, also those of other commands.
void Parser::checkSection(const CLI::ConfigItem& item) const
{
  const std::string section = item.parents.front();
  const auto command = std::find_if(this->Commands.begin(), this->Commands.end(),
    [&](const CommandApp& candidate) { return candidate.spec.name == section; });
  if (command == this->Commands.end() || item.parents.size() > 1)
  {
    throw UsageError(fmt::format("{}: unknown section [{}]; a section has the name of a command", this->ConfigFile,
      CLI::detail::join(item.parents, ".")));
  }
  std::vector<std::string> names;
  if (command->spec.takesSeafloor)
  {
    names.emplace_back("seafloor");
  }
  for (const Registered& registered : command->options)
  {
    names.push_back(registered.spec.longName().substr(2));
  }
  if (std::find(names.begin(), names.end(), item.name) == names.end())
  {
    throw UsageError(fmt::format("{}: unknown option '{}' in [{}]; did you mean '{}'?", this->ConfigFile, item.name,
      section, nearestWord(item.name, names)));
  }
}

void Parser::takeConfigurationItem(const CLI::ConfigItem& item)
{
  if (item.name == "++" || item.name == "--")
  {
    return; // CLI11's marks where a section begins and ends
  }
  if (!item.parents.empty())
  {
    this->checkSection(item);
    if (item.parents.front() != this->Chosen->spec.name)
    {
      return;
    }
  }
  std::string value;
  for (const std::string& input : item.inputs)
  {
    value += (value.empty() ? "" : ",") + input;
  }
  if (item.name == "seafloor" && this->Chosen->seafloor)
  {
    if (this->Chosen->seafloor->count() == 0)
    {
      this->Result.seafloor.source = value;
      this->FromFile.push_back(value);
    }
    return;
  }
  const std::string name = "--" + item.name;
  std::vector<std::string> names;
  for (Registered& registered : this->Chosen->options)
  {
    names.push_back(registered.spec.longName().substr(2));
    if (registered.spec.longName() != name)
    {
      continue;
    }
    // The command line wins.
    if (registered.option->count() == 0 && !(registered.spec.value.empty() && value == "false"))
    {
      try
      {
        this->set(registered.spec, value);
        registered.option->add_result(value);
        this->FromFile.push_back(registered.spec.value.empty() ? name : name + "=" + value);
      }
      catch (const UsageError& error)
      {
        throw UsageError(this->ConfigFile + ": " + error.what());
      }
    }
    return;
  }
  // A file may serve several commands, so an option of another one is no mistake.
  if (!this->belongsToAnyCommand(name))
  {
    throw UsageError(fmt::format(
      "{}: unknown option '{}'; did you mean '{}'?", this->ConfigFile, item.name, nearestWord(item.name, names)));
  }
}

void Parser::takeConfiguration()
{
  std::ifstream file(this->ConfigFile);
  if (!file.good() || file.peek() == std::ifstream::traits_type::eof())
  {
    throw WorkError(fmt::format("cannot read the configuration file '{}'", this->ConfigFile));
  }
  std::vector<CLI::ConfigItem> items;
  try
  {
    items = CLI::ConfigTOML().from_config(file);
  }
  catch (const CLI::Error& error)
  {
    throw UsageError(fmt::format("{}: {}", this->ConfigFile, error.what()));
  }
  for (const CLI::ConfigItem& item : items)
  {
    this->takeConfigurationItem(item);
  }
}

// The call with the options of the configuration file in place of its name: the file may change or go.
std::string Parser::lineForTheFiles() const
{
  const std::string config = "--config";
  std::vector<std::string> words{ "swellray" };
  for (std::size_t i = 1; i < this->Words.size(); ++i)
  {
    const std::string& word = this->Words[i];
    if (word == config)
    {
      ++i;
    }
    else if (word.compare(0, config.size() + 1, config + "=") != 0)
    {
      words.push_back(word);
    }
  }
  words.insert(words.end(), this->FromFile.begin(), this->FromFile.end());
  return joinWords(words);
}

std::optional<Call> Parser::read()
{
  try
  {
    this->parse();
  }
  catch (const CLI::Success& asked)
  {
    // Help or version.
    this->App.exit(asked);
    return {};
  }
  for (CommandApp& command : this->Commands)
  {
    if (command.app->parsed())
    {
      this->Chosen = &command;
    }
  }
  if (!this->Chosen && this->Words.size() == 1)
  {
    std::fputs(this->App.help().c_str(), stderr);
    throw UsageError("no command given");
  }
  this->refuseExtras();
  for (Registered& registered : this->Common)
  {
    this->take(registered);
  }
  for (Registered& registered : this->Chosen->options)
  {
    this->take(registered);
  }
  if (this->Chosen->seafloor && this->Chosen->seafloor->count() > 0)
  {
    this->Result.seafloor.source = this->Chosen->seafloor->results().front();
  }
  if (this->Chosen->file)
  {
    const FileSpec& file = this->Chosen->spec.file;
    if (this->Chosen->file->count() == 0 && file.standard.empty())
    {
      throw UsageError(fmt::format("{} needs a {}: {}", this->Chosen->spec.name, file.name, file.help));
    }
    *file.target = this->Chosen->file->count() == 0 ? file.standard : this->Chosen->file->results().front();
  }
  if (!this->ConfigFile.empty())
  {
    this->takeConfiguration();
  }
  this->Result.commandLine = this->lineForTheFiles();

  const std::string& name = this->Chosen->spec.name;
  if (this->Chosen->seafloor && this->Result.seafloor.source.empty())
  {
    throw UsageError(fmt::format("{} needs a SEAFLOOR: a file or a built-in form (see 'swellray list')", name));
  }
  for (const Registered& registered : this->Chosen->options)
  {
    const RayRequest& rays = this->Result.rays;
    const StartRequest& start = this->Result.start;
    const bool isHeight = registered.spec.name == "--height"; // of no use to rays followed back from a site
    const bool isDirection = registered.spec.name == "--direction";
    const bool directed = rays.source != RayRequest::Source::PlaneWave || !start.launch.empty() || start.site;
    const bool needed = (registered.spec.required && !(isHeight && start.site)) ||
      (rays.wanted && ((isHeight && !start.site) || (isDirection && !directed)));
    if (needed && registered.option->count() == 0)
    {
      throw UsageError(fmt::format("{} needs {} {}", name, registered.spec.longName(), registered.spec.value));
    }
  }
  const Request asked = this->Result;
  if (this->Chosen->spec.check)
  {
    this->Chosen->spec.check(this->Result);
  }
  const Request single = this->Result;
  this->Result = asked;
  return Call{ single, this->sweep(), this->Chosen->spec.run };
}

}

std::optional<Call> readCommandLine(const std::vector<std::string>& words)
{
  return Parser(words).read();
}

}
