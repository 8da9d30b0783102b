// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Parses and writes rows and cells of CSV (RFC 4180).
 */
#ifndef CsvRows_h
#define CsvRows_h

#include <string>
#include <string_view>
#include <vector>

namespace VolumeHaptics
{

/**
 * Splits a CSV into rows of cells. Cells in quotes may contain separators, line ends, and quotes,
 * which are doubled.
 */
class CsvRows
{
public:
  CsvRows(std::string_view text, char separator)
    : Text(text)
    , Separator(separator)
  {
  }

  /** Reads the next row. Returns false at the end of the text. */
  bool Next(std::vector<std::string>& cells);
  /** Returns the line number (from 1) where the last row begins. */
  int GetLine() const { return this->RowLine; }
  /** Returns whether the text ended within quotes, and so is probably truncated. */
  bool IsCutOff() const { return this->CutOff; }

private:
  void ReadCell(std::string& cell);
  void ReadQuoted(std::string& cell);
  bool Skip(char character) { return this->SkipText(std::string_view(&character, 1)); }
  bool SkipText(std::string_view text);

  std::string_view Text;
  const char Separator;
  std::size_t Position = 0;
  int Line = 1;
  int RowLine = 1;
  bool CutOff = false;
};

/**
 * Returns the separator (comma, semicolon or tab) that splits the first non-empty line into the
 * most cells.
 */
char DetectSeparator(std::string_view text);

/** Returns the first non-empty line. */
std::string_view FirstLine(std::string_view text);

bool IsEmptyRow(const std::vector<std::string>& cells);

/** Returns a text as a cell, in quotes if separators, quotes, line ends or blanks require them. */
std::string WriteCell(const std::string& text);

} // namespace VolumeHaptics

#endif
