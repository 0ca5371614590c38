#pragma once

#include <string>
#include <vector>

namespace swellray
{

/** Insertions, deletions and replacements of letters that turn one word into the other (Levenshtein 1966). */
std::size_t editDistance(const std::string& a, const std::string& b);

/** True where three letters or more begin the word. */
bool isBeginning(const std::string& letters, const std::string& word);

/**
 * The first word that `word` begins, three letters or more: it may have been left unfinished. Else the one with the least
 * editDistance to it, the first of several; empty where `words` is.
 */
std::string nearestWord(const std::string& word, const std::vector<std::string>& words);

}
