#pragma once

#include <string>
#include <vector>

namespace swellray::cli
{

/** Words as one line that a shell reads back as these words. */
std::string joinWords(const std::vector<std::string>& words);

/**
 * The words of a line that joinWords() has made: separated by spaces, quoted by single quotes or by a backslash.
 * @throws std::invalid_argument where a quote does not end
 */
std::vector<std::string> splitWords(const std::string& line);

}
