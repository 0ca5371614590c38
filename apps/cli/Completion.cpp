#include "Commands.h"
#include "OptionGroups.h"
#include "OptionKinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace swellray::cli
{

namespace
{

// The words that stand for the value of an option: those between bars, as in "ode|snell"; none for any other value.
std::vector<std::string> wordsOf(const std::string& value)
{
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

std::string joined(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words)
  {
    text += (text.empty() ? "" : " ") + word;
  }
  return text;
}

std::string bashCompletion(const std::vector<CommandSpec>& commands)
{
  std::vector<std::string> names;
  std::string options;
  std::string values;
  for (const CommandSpec& command : commands)
  {
    names.push_back(command.name);
    std::vector<std::string> own{ "--help" };
    for (const OptionSpec& option : command.options)
    {
      own.push_back(option.longName());
      const std::vector<std::string> words = wordsOf(option.value);
      if (!words.empty())
      {
        values += fmt::format("    {}{}) words='{}' ;;\n", command.name, option.longName(), joined(words));
      }
    }
    options += fmt::format("    {}) words='{}' ;;\n", command.name, joined(own));
  }
  return fmt::format(R"(# bash completion for swellray
_swellray()
{{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} command=${{COMP_WORDS[1]}} words=
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ]; then
    words='{} --help --version'
    COMPREPLY=($(compgen -W "$words" -- "$word"))
    return
  fi
  case $command$before in
{}  esac
  if [ -z "$words" ] && [ "${{word:0:1}}" = - ]; then
    case $command in
{}    esac
  fi
  if [ -n "$words" ]; then
    COMPREPLY=($(compgen -W "$words" -- "$word"))
  fi
}}
complete -o default -F _swellray swellray
)",
    joined(names), values, options);
}

}

CommandSpec completionSpec()
{
  CommandSpec spec{ "completion", "print a script that lets bash complete commands, options and their words", false, {},
    {} };
  spec.examples = "  swellray completion > ~/.local/share/bash-completion/completions/swellray\n"
                  "  source <(swellray completion)\n";
  spec.run = [](const Request&, Console&)
  {
    Request request;
    std::vector<CommandSpec> commands = commandSpecs(request);
    for (CommandSpec& command : commands)
    {
      add(command.options, commonOptions(request));
    }
    std::fputs(bashCompletion(commands).c_str(), stdout);
  };
  return spec;
}

}
