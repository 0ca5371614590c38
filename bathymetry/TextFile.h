#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace swellray
{

/** Longest text file that is read, bytes: 100 million numbers of ten characters. */
constexpr std::size_t LongestText = 1000000000;

/**
 * The whole of a text file.
 * @throws std::runtime_error naming the file where there is none, where it is longer than LongestText or where it holds
 *   a zero byte, which no text does
 */
std::string readTextFile(const std::string& path);

/**
 * Numbers of a text as Fortran writes and reads them: separated by blanks, commas and line ends, with exponents E or D
 * and repeats such as 3*0.5, at most 10 million times.
 */
class NumberScanner
{
public:
  /** @param text must outlive the scanner */
  explicit NumberScanner(std::string_view text);

  /**
   * The next number.
   * @return false at the end of the text
   * @throws std::runtime_error naming the line where the next word is no number
   */
  bool next(double& value);

  /** Go on with the next line, unless nothing of this line has been read yet; what is left of a repeat is dropped. */
  void startLine();

  /** Skip this many lines. */
  void skipLines(std::size_t count);

  /** The next word whatever it is; empty at the end. */
  std::string_view word();

  /** What the next call of word() will give. */
  std::string_view peek();

  /** Line of the last word, from 1. */
  std::size_t line() const { return this->Line; }

private:
  void skipBlanks();

  std::string_view Text;
  std::size_t At = 0;
  std::size_t Line = 1;
  bool LineBegun = false;
  double Repeated = 0.0;
  std::size_t Repeats = 0;
};

/**
 * A word as a number (forms: NumberScanner, without repeats).
 * @return false where it is none
 */
bool parseNumber(std::string_view word, double& value);

/**
 * As many numbers as a grid has nodes.
 * @param what names the values in the error
 * @param lines true where each row begins on a line of its own, and what is left of the line before is not read
 * @throws std::runtime_error where the grid is larger than MostNodes or the text ends too early
 */
std::vector<double> readNodes(
  NumberScanner& scanner, std::size_t columns, std::size_t rows, bool lines, const std::string& what);

/** A table of numbers, one row a line, all rows equally long. */
struct Matrix
{
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::vector<double> values; ///< row by row, first line first
};

/**
 * @param text lines of numbers; empty lines and those that begin with # or % are skipped
 * @throws std::runtime_error where the rows differ in length or there is no number
 */
Matrix readMatrix(std::string_view text);

/** The lines of a text without their ends, one after the other. */
void forLines(std::string_view text, const std::function<void(std::string_view)>& visit);

/** A whole number of 1 to `most`, else an error naming `what`. @throws std::runtime_error */
std::size_t wholeNumber(double value, const std::string& what, std::size_t most);

}
