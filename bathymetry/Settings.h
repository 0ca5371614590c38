#pragma once

#include <map>
#include <string>
#include <string_view>

namespace swellray
{

/**
 * Settings of a file of lines `name = value`: Fortran namelists (groups &name to /, quotes around text, commas at the
 * ends) and parameter files. Names in lower case; of a name that is there twice the last counts. Lines without a sign =
 * and what follows # or % or ! at the beginning of a line are not looked at.
 */
class Settings
{
public:
  explicit Settings(std::string_view text);

  bool has(const std::string& name) const { return this->Values.count(name) > 0; }

  /** The words of a setting without quotes; empty where it is not set. */
  std::string word(const std::string& name) const;

  /** @throws std::runtime_error where it is set to something that is no number */
  double number(const std::string& name, double otherwise) const;

  /** @throws std::runtime_error where it is not set or no number */
  double number(const std::string& name) const;

private:
  std::map<std::string, std::string> Values;
};

}
