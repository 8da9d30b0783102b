// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Material/Labels/CsvRows.h"

#include "VTK/Material/Labels/LabelText.h"

#include <algorithm>
#include <iterator>

namespace VolumeHaptics
{

bool CsvRows::Next(std::vector<std::string>& cells)
{
  cells.clear();
  if (this->Position >= this->Text.size())
  {
    return false;
  }
  this->RowLine = this->Line;
  do
  {
    cells.emplace_back();
    this->ReadCell(cells.back());
  } while (this->Skip(this->Separator));
  // Skip the line end, which is missing if the text ends within quotes.
  if (!this->SkipText("\r\n") && !this->Skip('\n'))
  {
    this->Skip('\r');
  }
  ++this->Line;
  return true;
}

void CsvRows::ReadCell(std::string& cell)
{
  if (this->Skip('"'))
  {
    this->ReadQuoted(cell);
  }
  const char ends[] = { this->Separator, '\r', '\n' };
  const std::size_t end =
    std::min(this->Text.find_first_of(std::string_view(ends, std::size(ends)), this->Position),
      this->Text.size());
  cell += Trim(this->Text.substr(this->Position, end - this->Position));
  this->Position = end;
}

void CsvRows::ReadQuoted(std::string& cell)
{
  while (this->Position < this->Text.size())
  {
    if (this->SkipText("\"\""))
    {
      cell += '"';
    }
    else if (this->Skip('"'))
    {
      return;
    }
    else
    {
      this->Line += this->Text[this->Position] == '\n' ? 1 : 0;
      cell += this->Text[this->Position++];
    }
  }
  this->CutOff = true;
}

bool CsvRows::SkipText(std::string_view text)
{
  const bool isHere = this->Text.substr(this->Position, text.size()) == text;
  this->Position += isHere ? text.size() : 0;
  return isHere;
}

std::string_view FirstLine(std::string_view text)
{
  LabelLines lines(text);
  std::string_view line;
  while (lines.Next(line) && line.empty())
  {
  }
  return line;
}

char DetectSeparator(std::string_view text)
{
  const std::string_view line = FirstLine(text);
  char separator = ',';
  for (const char other : { ';', '\t' })
  {
    if (std::count(line.begin(), line.end(), other) >
      std::count(line.begin(), line.end(), separator))
    {
      separator = other;
    }
  }
  return separator;
}

bool IsEmptyRow(const std::vector<std::string>& cells)
{
  return std::all_of(
    cells.begin(), cells.end(), [](const std::string& cell) { return cell.empty(); });
}

std::string WriteCell(const std::string& text)
{
  std::string quoted = "\"";
  for (const char character : text)
  {
    quoted += character == '"' ? "\"\"" : std::string(1, character);
  }
  // Without quotes, blanks at the ends would get lost.
  const bool isPlain =
    text.find_first_of("\",;\t\r\n") == std::string::npos && Trim(text) == std::string_view(text);
  return isPlain ? text : quoted + "\"";
}

} // namespace VolumeHaptics
