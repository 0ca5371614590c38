#include "ShellWords.h"

#include <stdexcept>

namespace swellray::cli
{

std::string joinWords(const std::vector<std::string>& words)
{
  std::string line;
  for (const std::string& word : words)
  {
    const bool plain = !word.empty() && word.find_first_of(" \t\n'\"\\$&|;<>()*?[]{}#!`~") == std::string::npos;
    std::string quoted;
    for (const char c : word)
    {
      quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    line += (line.empty() ? "" : " ") + (plain ? word : "'" + quoted + "'");
  }
  return line;
}

std::vector<std::string> splitWords(const std::string& line)
{
  std::vector<std::string> words;
  std::string word;
  bool within = false; // a word, which may be empty where it is quoted
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    const char c = line[i];
    if (quoted)
    {
      quoted = c != '\'';
      if (quoted)
      {
        word += c;
      }
    }
    else if (c == ' ')
    {
      if (within)
      {
        words.push_back(word);
      }
      word.clear();
      within = false;
    }
    else
    {
      within = true;
      if (c == '\'')
      {
        quoted = true;
      }
      else
      {
        const bool escaped = c == '\\' && i + 1 < line.size();
        word += escaped ? line[++i] : c;
      }
    }
  }
  if (quoted)
  {
    throw std::invalid_argument("a quote does not end");
  }
  if (within)
  {
    words.push_back(word);
  }
  return words;
}

}
