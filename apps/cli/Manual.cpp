// The manual, one page a command, out of the table of options.
#include "Commands.h"
#include "Failure.h"
#include "OptionKinds.h"
#include "OptionTable.h"
#include "OutputFile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace swellray::cli
{

namespace
{

// Options of the program itself, beside its commands.
const std::vector<std::pair<std::string, std::string>> ProgramOptions{ { "-h,--help", "show this help" },
  { "--version", "show the version and the libraries of this build" } };

std::vector<std::string> linesOf(const std::string& text)
{
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();)
  {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

// Lines of examples are calls, set in by two blanks, and sentences.
bool isCall(const std::string& line)
{
  return line.compare(0, 2, "  ") == 0;
}

std::string synopsis(const CommandSpec& command)
{
  std::string argument = command.takesSeafloor ? "SEAFLOOR" : command.file.name;
  if (!command.takesSeafloor && !command.file.standard.empty())
  {
    argument = "[" + argument + "]";
  }
  return argument.empty() ? "[OPTIONS]" : argument + " [OPTIONS]";
}

// The argument of a command and what it is; empty: it takes none.
std::pair<std::string, std::string> argumentOf(const CommandSpec& command)
{
  if (command.takesSeafloor)
  {
    return { "SEAFLOOR", SeafloorHelp };
  }
  return { command.file.name, command.file.help };
}

std::string standardOf(const OptionSpec& option)
{
  return option.required ? "required" : option.standard;
}

// Groups in the order in which they come first.
std::vector<std::string> groupsOf(const CommandSpec& command)
{
  std::vector<std::string> groups;
  for (const OptionSpec& option : command.options)
  {
    if (std::find(groups.begin(), groups.end(), option.group) == groups.end())
    {
      groups.push_back(option.group);
    }
  }
  return groups;
}

std::string sentence(std::string text)
{
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text + ".";
}

// Text of a man page: hyphens that can be typed, and no line that looks like a request.
std::string roff(const std::string& text)
{
  std::string result;
  for (const char c : text)
  {
    result += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
  }
  return result.empty() || (result[0] != '.' && result[0] != '\'') ? result : "\\&" + result;
}

std::string manHeader(const std::string& page, const std::string& help)
{
  std::string upper = page;
  std::transform(upper.begin(), upper.end(), upper.begin(), [](unsigned char c) { return std::toupper(c); });
  return fmt::format(".TH {} 1 \"\" \"Swellray {}\" \"User Commands\"\n.SH NAME\n{} \\- {}\n", roff(upper),
    SWELLRAY_VERSION, roff(page), roff(help));
}

std::string manOption(const std::string& names, const std::string& value, const std::string& help)
{
  std::string text = ".TP\n";
  std::string bold;
  for (const char c : names)
  {
    bold += c == ',' ? std::string("\\fR, \\fB") : c == '-' ? std::string("\\-") : std::string(1, c);
  }
  return text + "\\fB" + bold + "\\fR" + (value.empty() ? "" : " \\fI" + roff(value) + "\\fR") + "\n" + roff(help) +
    "\n";
}

std::string manExamples(const std::string& examples)
{
  std::string text = ".SH EXAMPLES\n";
  bool open = false;
  for (const std::string& line : linesOf(examples))
  {
    if (isCall(line) != open)
    {
      text += open ? ".EE\n" : ".EX\n";
      open = !open;
    }
    text += roff(open ? line.substr(2) : line) + "\n";
  }
  return text + (open ? ".EE\n" : "");
}

std::string manEnd(const std::vector<std::string>& seeAlso)
{
  std::string text = fmt::format(".SH EXIT STATUS\n{}\n.SH SEE ALSO\n", roff(ExitCodes));
  for (std::size_t i = 0; i < seeAlso.size(); ++i)
  {
    text += fmt::format(".BR {} (1){}\n", roff(seeAlso[i]), i + 1 < seeAlso.size() ? " ," : "");
  }
  return text;
}

std::string manPage(const CommandSpec& command)
{
  const std::string page = "swellray-" + command.name;
  std::string text = manHeader(page, command.help);
  text += fmt::format(".SH SYNOPSIS\n\\fBswellray {}\\fR {}\n", roff(command.name), roff(synopsis(command)));
  const auto [argument, help] = argumentOf(command);
  text += ".SH DESCRIPTION\n" + roff(sentence(command.help)) + "\n";
  if (!argument.empty())
  {
    text += ".TP\n\\fI" + roff(argument) + "\\fR\n" + roff(help) + "\n";
  }
  text += ".SH OPTIONS\n";
  for (const std::string& group : groupsOf(command))
  {
    text += ".SS " + roff(group) + "\n";
    for (const OptionSpec& option : command.options)
    {
      if (option.group == group)
      {
        const std::string standard = standardOf(option);
        text += manOption(option.name, option.value, option.help + (standard.empty() ? "" : " [" + standard + "]"));
      }
    }
  }
  return text + manExamples(command.examples) + manEnd({ "swellray" });
}

std::string manMain(const std::vector<CommandSpec>& commands)
{
  std::string text = manHeader("swellray", "wave refraction over real seafloors");
  text += ".SH SYNOPSIS\n\\fBswellray\\fR COMMAND [SEAFLOOR] [OPTIONS]\n.SH DESCRIPTION\n" + roff(ProgramHelp) +
    "\n.PP\nSEAFLOOR is " + roff(SeafloorHelp) + ".\n.SH COMMANDS\n";
  std::vector<std::string> pages;
  for (const CommandSpec& command : commands)
  {
    text += manOption(command.name, "", command.help);
    pages.push_back("swellray-" + command.name);
  }
  text += ".SH OPTIONS\n";
  for (const auto& [names, help] : ProgramOptions)
  {
    text += manOption(names, "", help);
  }
  return text + manEnd(pages);
}

// A cell of a table.
std::string cell(const std::string& text)
{
  std::string result;
  for (const char c : text)
  {
    result += c == '|' ? std::string("\\|") : c == '<' ? std::string("&lt;") : std::string(1, c);
  }
  return result;
}

std::string markdownPage(const CommandSpec& command)
{
  std::string text = fmt::format("# swellray {}\n\n{}\n\n```\nswellray {} {}\n```\n", command.name,
    sentence(command.help), command.name, synopsis(command));
  const auto [argument, help] = argumentOf(command);
  if (!argument.empty())
  {
    text += fmt::format("\n{}: {}{}.\n", argument, help,
      command.takesSeafloor || command.file.standard.empty() ? "" : " [" + command.file.standard + "]");
  }
  text += "\n## Examples\n";
  bool open = false;
  for (const std::string& line : linesOf(command.examples))
  {
    if (isCall(line) != open)
    {
      text += open ? "```\n\n" : "\n```\n";
      open = !open;
    }
    text += (open ? line.substr(2) : line) + "\n";
  }
  text += open ? "```\n" : "";
  for (const std::string& group : groupsOf(command))
  {
    text += fmt::format("\n## {}\n\n| option | | default |\n| --- | --- | --- |\n", group);
    for (const OptionSpec& option : command.options)
    {
      if (option.group == group)
      {
        const std::string names =
          shortName(option).empty() ? option.name : shortName(option) + ", " + option.longName();
        text += fmt::format("| `{}{}` | {} | {} |\n", names, option.value.empty() ? "" : " " + cell(option.value),
          cell(option.help), cell(standardOf(option)));
      }
    }
  }
  return text;
}

std::string markdownMain(const std::vector<CommandSpec>& commands)
{
  std::string text = fmt::format("# Commands\n\n{}\n\n```\nswellray COMMAND [SEAFLOOR] [OPTIONS]\n```\n\n| command | "
                                 "does |\n| --- | --- |\n",
    ProgramHelp);
  for (const CommandSpec& command : commands)
  {
    text += fmt::format("| [{}]({}.md) | {} |\n", command.name, command.name, cell(command.help));
  }
  return text +
    fmt::format("\nSEAFLOOR is {}.\n\nExit codes: {}\n\nThese pages are written by `swellray manual --format markdown "
                "docs/commands`, out of the table of options that the program reads its calls by.\n",
      SeafloorHelp, ExitCodes);
}

void writePage(const std::filesystem::path& path, const std::string& text)
{
  OutputFile file(path.string(), {});
  std::ofstream stream(file.temporary(), std::ios::binary);
  stream << text;
  stream.close();
  if (!stream)
  {
    file.fail("the page could not be stored");
  }
  file.commit();
}

void runManual(const Request& call, Console& console)
{
  Request request;
  std::string configuration;
  const std::vector<CommandSpec> commands = completeSpecs(request, configuration);
  const std::filesystem::path folder(call.manual.folder);
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure)
  {
    throw WorkError(fmt::format("cannot make the folder '{}': {}", folder.string(), failure.message()));
  }
  const bool markdown = call.manual.markdown;
  writePage(folder / (markdown ? "README.md" : "swellray.1"), markdown ? markdownMain(commands) : manMain(commands));
  for (const CommandSpec& command : commands)
  {
    writePage(folder / (markdown ? command.name + ".md" : "swellray-" + command.name + ".1"),
      markdown ? markdownPage(command) : manPage(command));
  }
  console.say(fmt::format("wrote {} pages to {}", commands.size() + 1, folder.string()));
}

}

CommandSpec manualSpec(Request& request)
{
  CommandSpec spec{ "manual", "write the manual of the program: a page a command", false, {}, {} };
  spec.file = { "FOLDER", "where the pages go", &request.manual.folder };
  spec.options = { choice("--format", "pages for man, or Markdown", "man", "Output", request.manual.markdown,
    std::vector<std::pair<std::string, bool>>{ { "man", false }, { "markdown", true } }) };
  spec.examples = "  swellray manual man1\n"
                  "  swellray manual --format markdown docs/commands\n";
  spec.run = runManual;
  return spec;
}

}
