// Scripts that let shells complete the program's commands, options and their words.
#include "Commands.h"
#include "OptionKinds.h"
#include "OptionTable.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace swellray::cli
{

namespace
{

const std::vector<std::string> Shells{ "bash", "zsh", "fish" };

std::string joined(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words)
  {
    text += (text.empty() ? "" : " ") + word;
  }
  return text;
}

// The text with this before each of these characters.
std::string escaped(const std::string& text, const std::string& characters, const std::string& before)
{
  std::string result;
  for (const char c : text)
  {
    result += (characters.find(c) == std::string::npos ? "" : before) + c;
  }
  return result;
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
      const std::vector<std::string> words = wordsOf(option);
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
    completion*) words='{}' ;;
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
    joined(names), joined(Shells), values, options);
}

// A word within single quotes.
std::string zshQuoted(const std::string& text)
{
  std::string result;
  for (const char c : text)
  {
    result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return "'" + result + "'";
}

// What an argument is, for _arguments: its name, and what completes it.
std::string zshValue(const OptionSpec& option)
{
  const std::vector<std::string> words = wordsOf(option);
  const std::string action = !words.empty() ? "(" + joined(words) + ")"
    : takesFile(option)                     ? "_files"
    : takesFolder(option)                   ? "_files -/"
                                            : " ";
  return fmt::format(":{}:{}", escaped(words.empty() ? option.value : "word", ":\\", "\\"), action);
}

std::string zshCompletion(const std::vector<CommandSpec>& commands)
{
  std::string names;
  std::string cases;
  for (const CommandSpec& command : commands)
  {
    names += fmt::format("    {}\n", zshQuoted(fmt::format("{}:{}", escaped(command.name, ":", "\\"), command.help)));
    cases += fmt::format("    {})\n      _arguments", command.name);
    const auto argument = [&cases](const std::string& text) { cases += " \\\n        " + text; };
    argument("'(-h --help)'{-h,--help}'[show this help]'");
    for (const OptionSpec& option : command.options)
    {
      const std::string help = "[" + escaped(option.help, "[]\\", "\\") + "]";
      const std::string value = option.value.empty() ? "" : zshValue(option);
      const std::string longName = option.longName() + (option.value.empty() ? "" : "=");
      const std::string letter = shortName(option);
      const std::string repeated = option.repeatable ? "*" : "";
      argument(letter.empty()
          ? zshQuoted(fmt::format("{}{}{}{}", repeated, longName, help, value))
          : fmt::format("'({} {})'{{{},{}}}{}", letter, option.longName(), letter, longName, zshQuoted(help + value)));
    }
    if (command.takesSeafloor)
    {
      argument("'1:seafloor:_files'");
    }
    else if (command.file.target)
    {
      argument(command.file.name == "SHELL" ? fmt::format("'1:shell:({})'", joined(Shells)) : "'1:file:_files'");
    }
    cases += "\n      ;;\n";
  }
  return fmt::format(R"(#compdef swellray
# zsh completion for swellray
_swellray()
{{
  local -a commands
  commands=(
{}  )
  if (( CURRENT == 2 )); then
    _describe -t commands command commands
    _arguments '--help[show this help]' '--version[show the version and the libraries of this build]'
    return
  fi
  shift words
  (( CURRENT-- ))
  case $words[1] in
{}  esac
}}
if [ "$funcstack[1]" = _swellray ]; then
  _swellray "$@"
else
  compdef _swellray swellray
fi
)",
    names, cases);
}

std::string fishQuoted(const std::string& text)
{
  return "'" + escaped(text, "'\\", "\\") + "'";
}

std::string fishCompletion(const std::vector<CommandSpec>& commands)
{
  std::string text = "# fish completion for swellray\n"
                     "complete -c swellray -n __fish_use_subcommand -f -l help -s h -d 'show this help'\n"
                     "complete -c swellray -n __fish_use_subcommand -f -l version -d 'show the version and the "
                     "libraries of this build'\n";
  for (const CommandSpec& command : commands)
  {
    text += fmt::format(
      "complete -c swellray -n __fish_use_subcommand -f -a {} -d {}\n", command.name, fishQuoted(command.help));
    const std::string start = fmt::format("complete -c swellray -n '__fish_seen_subcommand_from {}'", command.name);
    text += start + " -l help -s h -d 'show this help'\n";
    for (const OptionSpec& option : command.options)
    {
      const std::vector<std::string> words = wordsOf(option);
      const std::string letter = shortName(option);
      const std::string value = option.value.empty() ? ""
        : !words.empty()                             ? fmt::format(" -x -a {}", fishQuoted(joined(words)))
        : takesFile(option)                          ? " -r -F"
        : takesFolder(option)                        ? " -x -a '(__fish_complete_directories)'"
                                                     : " -x";
      text += fmt::format("{} -l {}{}{} -d {}\n", start, option.longName().substr(2),
        letter.empty() ? "" : " -s " + letter.substr(1), value, fishQuoted(option.help));
    }
    if (command.file.name == "SHELL")
    {
      text += fmt::format("{} -f -a {}\n", start, fishQuoted(joined(Shells)));
    }
  }
  return text;
}

}

CommandSpec completionSpec(Request& request)
{
  CommandSpec spec{ "completion", "print a script that lets a shell complete commands, options and their words", false,
    {}, {} };
  spec.file = { "SHELL", "bash, zsh or fish", &request.manual.shell, "bash" };
  spec.examples = "  swellray completion bash > ~/.local/share/bash-completion/completions/swellray\n"
                  "  swellray completion zsh > ~/.zfunc/_swellray\n"
                  "  swellray completion fish > ~/.config/fish/completions/swellray.fish\n"
                  "Of zsh the folder must be in fpath before compinit is called. An installed Swellray has the three "
                  "scripts where Debian's shells look for them.\n";
  spec.check = [](Request& call) { parseChoice("completion", call.manual.shell, Shells); };
  spec.run = [](const Request& call, Console&)
  {
    Request unused;
    std::string configuration;
    const std::vector<CommandSpec> commands = completeSpecs(unused, configuration);
    const std::string& shell = call.manual.shell;
    const std::string script = shell == "bash" ? bashCompletion(commands)
      : shell == "zsh"                         ? zshCompletion(commands)
                                               : fishCompletion(commands);
    std::fputs(script.c_str(), stdout);
  };
  return spec;
}

}
