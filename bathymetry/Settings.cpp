#include "bathymetry/Settings.h"

#include "bathymetry/Text.h"
#include "bathymetry/TextFile.h"

#include <cmath>
#include <stdexcept>

namespace swellray
{

namespace
{

// A value without blanks, the comma that ends it and its quotes.
std::string stripped(std::string_view value)
{
  std::string word = oneLine(std::string(value));
  if (!word.empty() && (word[0] == '\'' || word[0] == '"' || word[0] == '#'))
  {
    const std::size_t end = word.find(word[0], 1);
    return oneLine(word.substr(1, end == std::string::npos ? end : end - 1));
  }
  const std::size_t end = word.find_first_of(",!");
  return oneLine(word.substr(0, end));
}

}

Settings::Settings(std::string_view text)
{
  forLines(text,
    [this](std::string_view line)
    {
      const std::size_t begin = line.find_first_not_of(" \t");
      const std::size_t sign = line.find('=');
      if (begin == std::string_view::npos || sign == std::string_view::npos ||
        std::string_view("#%!").find(line[begin]) != std::string_view::npos)
      {
        return;
      }
      this->Values[plain(std::string(line.substr(0, sign)))] = stripped(line.substr(sign + 1));
    });
}

std::string Settings::word(const std::string& name) const
{
  const auto found = this->Values.find(name);
  return found == this->Values.end() ? std::string() : found->second;
}

double Settings::number(const std::string& name, double otherwise) const
{
  const auto found = this->Values.find(name);
  if (found == this->Values.end())
  {
    return otherwise;
  }
  double value = 0.0;
  if (!parseNumber(found->second, value) || !std::isfinite(value))
  {
    throw std::runtime_error("its setting " + name + " = " + found->second.substr(0, 40) + " is no number");
  }
  return value;
}

double Settings::number(const std::string& name) const
{
  if (!has(name))
  {
    throw std::runtime_error("it does not set " + name);
  }
  return number(name, 0.0);
}

}
