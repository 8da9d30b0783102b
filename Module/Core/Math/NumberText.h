// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads numbers from files, command lines and other processes, whatever the locale is.
 */
#ifndef NumberText_h
#define NumberText_h

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace VolumeHaptics
{

/**
 * Parses a decimal number with a decimal point, as in C. Don't use strtod, atof or streams instead:
 * in programs that set the user's locale, they read 1.6 as 1 if the locale has a decimal comma.
 * Returns none if the text contains anything else, or if the number is too large for a double.
 */
inline std::optional<double> ParseNumber(std::string_view text) noexcept
{
  if (text.size() > 1 && text[0] == '+' && text[1] != '-')
  {
    text.remove_prefix(1);
  }
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool isWhole = error == std::errc() && end == text.data() + text.size();
  return isWhole ? std::optional<double>(number) : std::nullopt;
}

} // namespace VolumeHaptics

#endif
