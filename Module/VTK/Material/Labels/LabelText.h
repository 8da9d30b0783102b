// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Parses lines, words, numbers and names in label files.
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

/** Splits a text into lines, with line ends of Unix, Windows or old Macs. */
class LabelLines
{
public:
  explicit LabelLines(std::string_view text)
    : Rest(text)
  {
  }
  /**
   * Reads the next line, without its end and without blanks around it. Returns false after the last
   * line.
   */
  bool Next(std::string_view& line);
  /** Returns the number (from 1) of the last line read. */
  int GetNumber() const { return this->Number; }

private:
  std::string_view Rest;
  int Number = 0;
};

/** Removes blanks at both ends of a text. */
std::string_view Trim(std::string_view text);

/** Splits a line into words at its blanks. */
std::vector<std::string_view> SplitWords(std::string_view line);

/**
 * Normalises a title: converts it to lower case, and removes blanks, underscores and parts in
 * parentheses.
 */
std::string MakeKey(std::string_view text);

/**
 * Parses a finite number with a decimal point, in any locale. The text may have only blanks around
 * the number.
 */
std::optional<double> ReadNumber(std::string_view text);

/** Parses a label. On failure, sets `error` to the reason and the cure. */
std::optional<int> ReadLabel(std::string_view text, std::string& error);

/** Converts red, green and blue from the range 0 to 255 to a colour from 0 to 1. */
std::optional<std::array<double, 3>> ReadByteColor(
  std::string_view red, std::string_view green, std::string_view blue);

/** Makes a colour from three numbers. Returns nothing unless each is from 0 to 1. */
std::optional<std::array<double, 3>> MakeColor(double red, double green, double blue);

/**
 * Converts a text to UTF-8, with control characters replaced by blanks. A text that is not UTF-8 is
 * read as ISO 8859-1, which old programs write.
 */
std::string MakeLabelName(std::string_view text);

/** Returns the first part of a text in quotes, for a message. */
std::string Quote(std::string_view text);

/** Returns the first words of a message about a line, such as "Line 3: ". */
std::string InLine(int number);

} // namespace VolumeHaptics

#endif
