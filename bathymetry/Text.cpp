#include "bathymetry/Text.h"

#include <cctype>
#include <cstdio>

namespace swellray
{

std::string text(double value, int digits)
{
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.*g", digits, value);
  return buffer;
}

std::string oneLine(const std::string& words)
{
  std::string line;
  bool blank = false;
  for (const char c : words)
  {
    if (std::isspace(static_cast<unsigned char>(c)))
    {
      blank = !line.empty();
      continue;
    }
    if (blank)
    {
      line += ' ';
      blank = false;
    }
    line += std::iscntrl(static_cast<unsigned char>(c)) ? '?' : c;
  }
  return line;
}

std::string plain(const std::string& word)
{
  std::string lower = oneLine(word);
  for (char& c : lower)
  {
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return lower;
}

}
