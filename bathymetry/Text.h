#pragma once

#include <string>

namespace swellray
{

/** A number as people write it: up to `digits` significant digits, no trailing zeros. */
std::string text(double value, int digits = 6);

/** Without blanks at its ends, in lower case. */
std::string plain(const std::string& word);

/** On one line: every run of white space is one blank, and other control characters, which a terminal obeys, are '?'. */
std::string oneLine(const std::string& words);

}
