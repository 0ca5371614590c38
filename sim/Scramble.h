#pragma once

#include <cstdint>

namespace swellray
{

/** SplitMix64 (Steele, Lea and Flood 2014): neighbouring numbers give unrelated ones. */
inline std::uint64_t scramble(std::uint64_t x)
{
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/** Such a number as one from 0 to below 1. */
inline double unitOf(std::uint64_t scrambled)
{
  return static_cast<double>(scrambled >> 11) * 0x1p-53;
}

}
