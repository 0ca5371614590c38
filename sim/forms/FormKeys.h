#pragma once

#include "sim/BuiltinSeafloor.h"

/** Keys that several built-in forms have. Ranges include their ends. */
namespace swellray::formkeys
{

constexpr double LargestDistance = 1e7; // m
constexpr double SmallestLength = 1e-3; // m

inline FormKey number(const std::string& name, const std::string& symbol, const std::string& unit, double value,
  double low, double high, const std::string& description)
{
  FormKey key;
  key.name = name;
  key.symbol = symbol;
  key.unit = unit;
  key.description = description;
  key.value = value;
  key.low = low;
  key.high = high;
  return key;
}

inline FormKey length(const std::string& name, const std::string& symbol, double value, const std::string& description)
{
  return number(name, symbol, "m", value, SmallestLength, LargestDistance, description);
}

inline FormKey position(const std::string& name, double value, const std::string& description)
{
  return number(name, "", "m", value, -LargestDistance, LargestDistance, description);
}

}
