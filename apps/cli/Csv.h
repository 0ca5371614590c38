#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace swellray::cli
{

/** Without blanks at its ends. */
std::string trimmed(const std::string& text);

/** A finite number and nothing else. */
bool parseField(const std::string& text, double& value);

/** The first field that is one of these words, in either case, before what follows an underscore: x_rd. */
std::optional<std::size_t> columnOf(const std::vector<std::string>& fields, const std::vector<std::string>& words);

/** A line of a CSV file. */
struct CsvLine
{
  std::size_t number = 0;          ///< in the file, from 1
  std::string text;                ///< as it was read, trimmed
  std::vector<std::string> fields; ///< trimmed, without the quotes around them
};

/**
 * Lines of a CSV file that hold something. Blank lines and lines that begin with # are passed over, and so is a byte
 * order mark; fields may stand in double quotes.
 * @throws WorkError where it cannot be read
 */
std::vector<CsvLine> readCsv(const std::string& path);

}
