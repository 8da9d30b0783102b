// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Sorts file names in natural order.
 */
#ifndef NameOrder_h
#define NameOrder_h

#include <algorithm>
#include <cstddef>
#include <string>

namespace VolumeHaptics
{

inline bool IsDigit(char letter)
{
  return letter >= '0' && letter <= '9';
}

/** Returns the digits that begin at `at`, without leading zeros, and moves `at` behind them. */
inline std::string ReadDigits(const std::string& name, std::size_t& at)
{
  const std::size_t first = std::min(name.find_first_not_of('0', at), name.size());
  for (at = first; at < name.size() && IsDigit(name[at]); ++at)
  {
  }
  return name.substr(first, at - first);
}

/**
 * Compares names in natural order, with digits compared as numbers: "T2" comes before "T10". Digits
 * come before all other characters.
 */
inline bool IsNamedBefore(const std::string& a, const std::string& b)
{
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() && j < b.size())
  {
    if (IsDigit(a[i]) != IsDigit(b[j]))
    {
      return IsDigit(a[i]);
    }
    if (IsDigit(a[i]))
    {
      const std::string one = ReadDigits(a, i);
      const std::string other = ReadDigits(b, j);
      if (one != other)
      {
        return one.size() != other.size() ? one.size() < other.size() : one < other;
      }
    }
    else if (a[i] != b[j])
    {
      return static_cast<unsigned char>(a[i]) < static_cast<unsigned char>(b[j]);
    }
    else
    {
      ++i;
      ++j;
    }
  }
  const bool isEnd = i == a.size() && j == b.size();
  return isEnd ? a < b : i == a.size();
}

} // namespace VolumeHaptics

#endif
