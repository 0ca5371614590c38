#include "sim/forms/FormCatalogue.h"

#include "sim/forms/NearestWord.h"

#include <stdexcept>

namespace swellray
{

namespace
{

/** Names and kinds, and what to type for each. */
struct Words
{
  std::vector<std::string> words;
  std::vector<std::string> specs;

  explicit Words(const std::vector<FormDescription>& forms)
  {
    for (const FormDescription& form : forms)
    {
      this->words.push_back(form.name);
      this->specs.push_back(form.name);
    }
    for (const FormDescription& form : forms)
    {
      for (const FormKey& key : form.keys)
      {
        for (const std::string& word : key.words)
        {
          this->words.push_back(word);
          this->specs.push_back(form.name + ":" + key.name + "=" + word);
        }
      }
    }
  }
};

}

std::string formName(const std::string& spec)
{
  return spec.substr(0, spec.find(':'));
}

void refuseForm(const std::string& subject, const std::string& name, const std::vector<FormDescription>& forms)
{
  const Words all(forms);
  const std::string nearest = nearestWord(name, all.words);
  std::size_t i = 0;
  while (all.words[i] != nearest)
  {
    ++i;
  }
  throw std::invalid_argument("unknown built-in " + subject + " '" + name + "'; did you mean '" + all.specs[i] + "'?");
}

bool resemblesForm(const std::string& spec, const std::vector<FormDescription>& forms)
{
  const std::string name = formName(spec);
  if (name.empty() || name.find_first_not_of("abcdefghijklmnopqrstuvwxyz-") != std::string::npos)
  {
    return false;
  }
  if (name.size() < spec.size())
  {
    // Not the prefixes of data sets, as in NETCDF:"file":name.
    return spec.find('=') != std::string::npos || name.size() + 1 == spec.size();
  }
  const std::string nearest = nearestWord(name, Words(forms).words);
  return isBeginning(name, nearest) || editDistance(name, nearest) <= (name.size() + 2) / 3;
}

}
