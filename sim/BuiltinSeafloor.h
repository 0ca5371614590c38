#pragma once

#include "sim/Seafloor.h"

#include <memory>
#include <string>
#include <vector>

namespace swellray
{

/** A key of a built-in form: a number, or one of some words. */
struct FormKey
{
  std::string name;
  std::string symbol; ///< its letter in the formula, accepted as well; empty: none
  std::string unit;   ///< "-" without one
  std::string description;
  double value = 0.0; ///< default
  double low = 0.0;   ///< allowed range, ends included
  double high = 0.0;
  std::vector<std::string> words; ///< allowed words, the default first; empty: the key is a number
  std::string kind;               ///< the one kind of the form that takes the key; empty: every kind
};

/** A built-in form as `NAME:key=value,...` makes it. */
struct FormDescription
{
  std::string name;
  std::string summary;
  std::string formula; ///< in the symbols of the keys, depth h in m
  std::string source;
  std::vector<FormKey> keys;
  double directionFrom = 0.0; ///< nautical degrees from where waves suit the form with its default keys
  double period = 10.0;       ///< s, of such waves
};

/** Every built-in form, in the order of a listing. */
const std::vector<FormDescription>& builtinForms();

/** True where the text before the first ':' of spec is the name of a built-in form. */
bool isBuiltinSeafloor(const std::string& spec);

/** True where spec, should it name no file, means a built-in form and may be misspelt: makeBuiltinSeafloor says how. */
bool resemblesBuiltinSeafloor(const std::string& spec);

/**
 * Make a built-in seafloor.
 * @param spec `NAME` or `NAME:key=value,...`
 * @throws std::invalid_argument unknown form or key (naming the nearest), a value that is not a number or out of
 *   range, a key given twice, one that the chosen kind does not take, or values that do not go together
 */
std::unique_ptr<Seafloor> makeBuiltinSeafloor(const std::string& spec);

}
