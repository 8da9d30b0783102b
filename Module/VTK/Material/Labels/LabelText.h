// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Parses lines, words, numbers and names in files of labels.
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

/** Lines of a text, with the line ends of Unix, Windows or old Macs. */
class LabelLines
{
public:
  explicit LabelLines(std::string_view text)
    : Rest(text)
  {
  }
  /**
   * Reads the next line without its end, and without blanks around it. Returns false if there is
   * none.
   */
  bool Next(std::string_view& line);
  /** Returns the number of the last line read, counted from 1. */
  int GetNumber() const { return this->Number; }

private:
  std::string_view Rest;
  int Number = 0;
};

/** Removes the blanks around a text. */
std::string_view Trim(std::string_view text);

/** Splits a text into words at its blanks. */
std::vector<std::string_view> SplitWords(std::string_view line);

/** Converts a text to lower case, without blanks, underscores and parts in parentheses. */
std::string MakeKey(std::string_view text);

/**
 * Reads a finite number with a decimal point, in any locale. The text may have blanks around it,
 * but nothing else.
 */
std::optional<double> ReadNumber(std::string_view text);

/** Reads a label. If there is none, writes the reason and the cure to `error`. */
std::optional<int> ReadLabel(std::string_view text, std::string& error);

/** Converts red, green and blue from 0 to 255 to a colour from 0 to 1. */
std::optional<std::array<double, 3>> ReadByteColor(
  std::string_view red, std::string_view green, std::string_view blue);

/** Makes a colour of three numbers; nothing unless all of them are from 0 to 1. */
std::optional<std::array<double, 3>> MakeColor(double red, double green, double blue);

/**
 * Converts a text to UTF-8 without control characters, which become blanks. A text that is not
 * UTF-8 is read as ISO 8859-1, which old programs write.
 */
std::string MakeLabelName(std::string_view text);

/** Returns the beginning of a text, in quotes, for a message. */
std::string Quote(std::string_view text);

/** Returns the beginning of a message about a line, such as "Line 3: ". */
std::string InLine(int number);

} // namespace VolumeHaptics

#endif
