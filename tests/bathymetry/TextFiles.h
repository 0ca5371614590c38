#pragma once

#include "bathymetry/SwanGrid.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <stdexcept>
#include <string>

namespace swellray::test
{

/** Files of a test by name, without a folder. */
struct TextFiles
{
  std::map<std::string, std::string> texts;

  FileText open() const
  {
    return [this](const std::string& name)
    {
      const auto found = this->texts.find(name);
      if (found == this->texts.end())
      {
        throw std::runtime_error("'" + name + "' is missing: no such file");
      }
      return found->second;
    };
  }
};

inline void writeText(const std::string& path, const std::string& text)
{
  std::ofstream(path, std::ios::binary) << text;
}

/** What a call that must fail with std::runtime_error says. */
template <typename Call>
std::string failureOf(const Call& call)
{
  try
  {
    call();
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "no error";
}

/** Numbers `values(column, row)` of a grid, one row a line. */
template <typename Values>
std::string lines(int columns, int rows, const Values& values)
{
  std::string text;
  for (int row = 0; row < rows; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      text += (column > 0 ? " " : "") + std::to_string(values(column, row));
    }
    text += "\n";
  }
  return text;
}

}
