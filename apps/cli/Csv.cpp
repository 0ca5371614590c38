#include "Csv.h"

#include "Failure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>

namespace swellray::cli
{

namespace
{

std::vector<std::string> fieldsOf(const std::string& line)
{
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    if (line[i] == '"')
    {
      const bool doubled = quoted && i + 1 < line.size() && line[i + 1] == '"';
      quoted = doubled ? quoted : !quoted;
      i += doubled ? 1 : 0;
      if (doubled)
      {
        fields.back() += '"';
      }
    }
    else if (line[i] == ',' && !quoted)
    {
      fields.emplace_back();
    }
    else
    {
      fields.back() += line[i];
    }
  }
  std::transform(fields.begin(), fields.end(), fields.begin(), trimmed);
  return fields;
}

}

std::string trimmed(const std::string& text)
{
  const auto first = text.find_first_not_of(" \t\r");
  const auto last = text.find_last_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

bool parseField(const std::string& text, double& value)
{
  const char* begin = text.data() + (!text.empty() && text[0] == '+' ? 1 : 0);
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(begin, end, value);
  return error == std::errc() && stop == end && std::isfinite(value);
}

std::optional<std::size_t> columnOf(const std::vector<std::string>& fields, const std::vector<std::string>& words)
{
  for (std::size_t i = 0; i < fields.size(); ++i)
  {
    std::string word = fields[i].substr(0, fields[i].find('_'));
    std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::tolower(c); });
    if (std::find(words.begin(), words.end(), word) != words.end())
    {
      return i;
    }
  }
  return {};
}

std::vector<CsvLine> readCsv(const std::string& path)
{
  std::ifstream file(path);
  if (!file)
  {
    throw WorkError(fmt::format("cannot read '{}': no such file, or it may not be read", path));
  }
  std::vector<CsvLine> lines;
  std::string line;
  for (std::size_t number = 1; std::getline(file, line); ++number)
  {
    if (number == 1 && line.compare(0, 3, "\xEF\xBB\xBF") == 0)
    {
      line.erase(0, 3);
    }
    line = trimmed(line);
    if (!line.empty() && line[0] != '#')
    {
      lines.push_back({ number, line, fieldsOf(line) });
    }
  }
  return lines;
}

}
