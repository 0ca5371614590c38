#pragma once

#include <string>
#include <vector>

namespace swellray
{

/**
 * The word that takes the fewest insertions, deletions and replacements of letters (Levenshtein 1966) to become
 * `word`; the first of several; empty where `words` is.
 */
std::string nearestWord(const std::string& word, const std::vector<std::string>& words);

}
