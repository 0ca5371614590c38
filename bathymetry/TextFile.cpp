#include "bathymetry/TextFile.h"

#include "bathymetry/FileGrid.h"
#include "bathymetry/Text.h"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace swellray
{

namespace
{

// Longest word that can be a number: more digits than a double has.
constexpr std::size_t LongestNumber = 400;

// A few bytes must not stand for more memory than the machine has.
constexpr std::size_t MostRepeats = 10000000;

bool isSeparator(char c)
{
  return c == ' ' || c == '\t' || c == ',' || c == '\r' || c == '\f' || c == '\v';
}

std::string shown(std::string_view word)
{
  constexpr std::size_t most = 24;
  std::string result;
  for (const char c : word.substr(0, most))
  {
    result += c >= ' ' && c <= '~' ? c : '?';
  }
  return result + (word.size() > most ? "..." : "");
}

}

std::string readTextFile(const std::string& path)
{
  namespace fs = std::filesystem;
  std::error_code error;
  if (!fs::is_regular_file(path, error))
  {
    throw std::runtime_error("'" + path + "' is " + (fs::exists(path, error) ? "not a file" : "missing: no such file"));
  }
  const std::uintmax_t size = fs::file_size(path, error);
  if (error || size > LongestText)
  {
    throw std::runtime_error("'" + path + "' is longer than " + std::to_string(LongestText / 1000000) +
      " million bytes, too long for a text; bring it to a raster (GeoTIFF, NetCDF) first");
  }
  std::ifstream stream(path, std::ios::binary);
  std::string text(static_cast<std::size_t>(size), '\0');
  if (!stream.read(text.data(), static_cast<std::streamsize>(size)))
  {
    throw std::runtime_error("'" + path + "' cannot be read");
  }
  const std::size_t zero = text.find('\0');
  if (zero != std::string::npos)
  {
    throw std::runtime_error("'" + path + "' is no text: byte " + std::to_string(zero + 1) + " is zero");
  }
  return text;
}

bool parseNumber(std::string_view word, double& value)
{
  // A sign +, which is not followed by another one.
  if (word.size() > 1 && word[0] == '+' && word[1] != '-')
  {
    word.remove_prefix(1);
  }
  if (word.empty() || word.size() > LongestNumber)
  {
    return false;
  }
  const char* end = word.data() + word.size();
  std::from_chars_result result = std::from_chars(word.data(), end, value);
  if (result.ec == std::errc::result_out_of_range)
  {
    // Too small is zero and too large infinite, as everywhere else.
    value = std::strtod(std::string(word).c_str(), nullptr);
    return true;
  }
  if (result.ec != std::errc())
  {
    return false;
  }
  if (result.ptr != end && (*result.ptr == 'd' || *result.ptr == 'D'))
  {
    std::string fortran(word);
    fortran[static_cast<std::size_t>(result.ptr - word.data())] = 'e';
    double shifted = 0.0;
    const char* last = fortran.data() + fortran.size();
    result = std::from_chars(fortran.data(), last, shifted);
    if (result.ec == std::errc() && result.ptr == last)
    {
      value = shifted;
      return true;
    }
    return false;
  }
  return result.ptr == end;
}

NumberScanner::NumberScanner(std::string_view text)
  : Text(text)
{
}

void NumberScanner::skipBlanks()
{
  while (this->At < this->Text.size())
  {
    const char c = this->Text[this->At];
    if (c == '\n')
    {
      ++this->Line;
      this->LineBegun = false;
    }
    else if (!isSeparator(c))
    {
      return;
    }
    ++this->At;
  }
}

std::string_view NumberScanner::peek()
{
  skipBlanks();
  std::size_t end = this->At;
  while (end < this->Text.size() && this->Text[end] != '\n' && !isSeparator(this->Text[end]))
  {
    ++end;
  }
  return this->Text.substr(this->At, end - this->At);
}

std::string_view NumberScanner::word()
{
  const std::string_view found = peek();
  this->At += found.size();
  this->LineBegun = this->LineBegun || !found.empty();
  return found;
}

bool NumberScanner::next(double& value)
{
  if (this->Repeats > 0)
  {
    --this->Repeats;
    value = this->Repeated;
    return true;
  }
  std::string_view found = word();
  if (found.empty())
  {
    return false;
  }
  const std::string_view whole = found;
  const std::size_t star = found.find('*');
  std::size_t count = 1;
  if (star != std::string_view::npos)
  {
    const auto [end, error] = std::from_chars(found.data(), found.data() + star, count);
    if (error != std::errc() || end != found.data() + star || count == 0)
    {
      throw std::runtime_error("line " + std::to_string(this->Line) + ": '" + shown(whole) + "' is no number");
    }
    if (count > MostRepeats)
    {
      throw std::runtime_error(
        "line " + std::to_string(this->Line) + " repeats a number " + std::to_string(count) + " times, too often");
    }
    found.remove_prefix(star + 1);
  }
  if (!parseNumber(found, value))
  {
    throw std::runtime_error("line " + std::to_string(this->Line) + ": '" + shown(whole) + "' is no number");
  }
  this->Repeated = value;
  this->Repeats = count - 1;
  return true;
}

void NumberScanner::startLine()
{
  this->Repeats = 0;
  if (this->LineBegun)
  {
    skipLines(1);
  }
}

void NumberScanner::skipLines(std::size_t count)
{
  for (; count > 0 && this->At < this->Text.size(); --count)
  {
    const std::size_t end = this->Text.find('\n', this->At);
    this->At = end == std::string_view::npos ? this->Text.size() : end + 1;
    ++this->Line;
  }
  this->LineBegun = false;
}

std::vector<double> readNodes(
  NumberScanner& scanner, std::size_t columns, std::size_t rows, bool lines, const std::string& what)
{
  if (columns == 0 || rows == 0 || columns > MostNodes / rows)
  {
    throw std::runtime_error("a grid of " + std::to_string(columns) + " x " + std::to_string(rows) + " nodes of " +
      what + " cannot be read: the limit is " + std::to_string(MostNodes / 1000000) + " million");
  }
  // Grown with what is really there: a size that is only claimed takes no memory.
  std::vector<double> values;
  for (std::size_t row = 0; row < rows; ++row)
  {
    if (lines)
    {
      scanner.startLine();
    }
    for (std::size_t column = 0; column < columns; ++column)
    {
      double value = 0.0;
      if (!scanner.next(value))
      {
        throw std::runtime_error("it ends after " + std::to_string(values.size()) + " of " +
          std::to_string(columns * rows) + " values of " + what + " (" + std::to_string(columns) + " x " +
          std::to_string(rows) + ")");
      }
      values.push_back(value);
    }
  }
  return values;
}

Matrix readMatrix(std::string_view text)
{
  Matrix matrix;
  NumberScanner scanner(text);
  std::size_t line = 0;
  while (true)
  {
    const std::string_view word = scanner.peek();
    if (word.empty())
    {
      break;
    }
    if (word[0] == '#' || word[0] == '%')
    {
      scanner.skipLines(1);
      continue;
    }
    line = scanner.line();
    std::size_t count = 0;
    while (!scanner.peek().empty() && scanner.line() == line)
    {
      double value = 0.0;
      if (!parseNumber(scanner.word(), value))
      {
        throw std::runtime_error("line " + std::to_string(line) + " holds a word that is no number");
      }
      matrix.values.push_back(value);
      ++count;
    }
    if (matrix.rows > 0 && count != matrix.columns)
    {
      throw std::runtime_error("line " + std::to_string(line) + " has " + std::to_string(count) +
        " numbers, the first has " + std::to_string(matrix.columns));
    }
    matrix.columns = count;
    ++matrix.rows;
  }
  if (matrix.rows == 0)
  {
    throw std::runtime_error("it holds no numbers");
  }
  return matrix;
}

void forLines(std::string_view text, const std::function<void(std::string_view)>& visit)
{
  while (!text.empty())
  {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    if (!line.empty() && line.back() == '\r')
    {
      line.remove_suffix(1);
    }
    visit(line);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
}

std::size_t wholeNumber(double value, const std::string& what, std::size_t most)
{
  if (!(value >= 1.0 && value <= static_cast<double>(most)) || value != std::floor(value))
  {
    throw std::runtime_error(what + " must be a whole number of 1 to " + std::to_string(most) + ", not " + text(value));
  }
  return static_cast<std::size_t>(value);
}

}
