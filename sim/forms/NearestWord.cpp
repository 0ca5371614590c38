#include "sim/forms/NearestWord.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace swellray
{

std::size_t editDistance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t(0));
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({ replaced, row[j] + 1, row[j + 1] + 1 });
    }
  }
  return row.back();
}

bool isBeginning(const std::string& letters, const std::string& word)
{
  return letters.size() >= 3 && word.compare(0, letters.size(), letters) == 0;
}

std::string nearestWord(const std::string& word, const std::vector<std::string>& words)
{
  std::string nearest;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const std::string& candidate : words)
  {
    if (isBeginning(word, candidate))
    {
      return candidate;
    }
    const std::size_t distance = editDistance(word, candidate);
    if (distance < least)
    {
      least = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

}
