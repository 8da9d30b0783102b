// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lines, words, numbers and names in files of labels.
 */
#ifndef LabelText_h
#define LabelText_h

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace VolumeHaptics
{

/** The lines of a text, which end as on Unix, Windows or old Macs. */
class LabelLines
{
public:
  explicit LabelLines(std::string_view text)
    : Rest(text)
  {
  }
  /** The next line without its end, and without blanks around it. False if there is none. */
  bool Next(std::string_view& line);
  /** The number of that line, from 1 on. */
  int GetNumber() const { return this->Number; }

private:
  std::string_view Rest;
  int Number = 0;
};

/** A text without blanks around it. */
std::string_view Trim(std::string_view text);

/** The words of a text, which blanks separate. */
std::vector<std::string_view> SplitWords(std::string_view line);

/** A text in lower case, without blanks, underscores, and what stands in parentheses. */
std::string MakeKey(std::string_view text);

/** A finite number, in any locale with a decimal point, and with nothing around it but blanks. */
std::optional<double> ReadNumber(std::string_view text);

/** A label. If there is none, the error says why, and what helps. */
std::optional<int> ReadLabel(std::string_view text, std::string& error);

/** Red, green and blue from 0 to 255, as a colour from 0 to 1. */
std::optional<std::array<double, 3>> ReadByteColor(
  std::string_view red, std::string_view green, std::string_view blue);

/** Three numbers as a colour, if all of them are from 0 to 1. */
std::optional<std::array<double, 3>> MakeColor(double red, double green, double blue);

/**
 * A text as UTF-8 without control characters. If it is not UTF-8, it is taken for ISO 8859-1, which
 * old programs write; control characters become blanks.
 */
std::string MakeLabelName(std::string_view text);

/** The beginning of a text in quotes, for a message. */
std::string Quote(std::string_view text);

/** "Line 3: ", for a message. */
std::string InLine(int number);

} // namespace VolumeHaptics

#endif
