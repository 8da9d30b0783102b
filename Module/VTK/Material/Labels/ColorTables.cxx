// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Material/Labels/ColorTables.h"

#include "VTK/Material/Labels/LabelText.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace VolumeHaptics
{
namespace
{

using Words = std::vector<std::string_view>;

constexpr int PaletteLabels = 256;

bool MeansSomething(std::string_view line)
{
  return !line.empty() && line[0] != '#';
}

/** Returns the first line that is neither empty nor a comment; empty if there is none. */
std::string_view FirstEntry(std::string_view text)
{
  LabelLines lines(text);
  std::string_view line;
  while (lines.Next(line))
  {
    if (MeansSomething(line))
    {
      return line;
    }
  }
  return {};
}

bool AreNumbers(const Words& words, std::size_t first, std::size_t count)
{
  return first + count <= words.size() &&
    std::all_of(words.begin() + static_cast<std::ptrdiff_t>(first),
      words.begin() + static_cast<std::ptrdiff_t>(first + count),
      [](std::string_view word) { return ReadNumber(word).has_value(); });
}

/** Returns the text between two words of the same line, without blanks around it. */
std::string_view Between(std::string_view from, std::string_view to)
{
  return Trim(std::string_view(from.data(), static_cast<std::size_t>(to.data() - from.data())));
}

/**
 * Returns the index of the first colour component at the end of a FreeSurfer line; 0 if the line
 * has no colour.
 */
std::size_t FindFreeSurferColor(const Words& words)
{
  for (const std::size_t numbers : { 4, 3 })
  {
    if (words.size() >= numbers + 2 && AreNumbers(words, words.size() - numbers, numbers))
    {
      return words.size() - numbers;
    }
  }
  return 0;
}

bool SetColor(const Words& words, std::size_t first, LabelEntry& entry, std::string& error)
{
  entry.Color = ReadByteColor(words[first], words[first + 1], words[first + 2]);
  if (!entry.Color)
  {
    error = "red, green and blue are not three numbers from 0 to 255";
  }
  return entry.Color.has_value();
}

bool ReadItkSnapLine(std::string_view line, LabelEntry& entry, std::string& error)
{
  const Words words = SplitWords(line);
  const std::size_t first = line.find('"');
  const std::size_t last = line.rfind('"');
  if (words.size() < 8 || !AreNumbers(words, 0, 7) || last == std::string_view::npos ||
    first == last)
  {
    error = "this is not label, red, green, blue, opacity, two flags, and a name in quotes";
    return false;
  }
  entry.Name = MakeLabelName(line.substr(first + 1, last - first - 1));
  return SetColor(words, 1, entry, error);
}

bool ReadFreeSurferLine(std::string_view line, LabelEntry& entry, std::string& error)
{
  const Words words = SplitWords(line);
  const std::size_t color = FindFreeSurferColor(words);
  if (color == 0)
  {
    error = "this is not label, name, red, green, blue and transparency";
    return false;
  }
  entry.Name = MakeLabelName(Between(words[1], words[color]));
  return SetColor(words, color, entry, error);
}

bool ReadNameLine(std::string_view line, LabelEntry& entry, std::string& error)
{
  const Words words = SplitWords(line);
  if (words.size() < 2)
  {
    error = "this is not a label and a name";
    return false;
  }
  const bool hasNumber = words.size() > 2 && ReadNumber(words.back());
  const char* const end = hasNumber ? words.back().data() : line.data() + line.size();
  entry.Name = MakeLabelName(Between(words[1], std::string_view(end, 0)));
  return true;
}

template <typename ReadLine>
bool ReadTable(
  std::string_view text, const ReadLine& readLine, LabelEntries& entries, std::string& error)
{
  LabelEntries found;
  LabelLines lines(text);
  std::string_view line;
  while (lines.Next(line))
  {
    if (!MeansSomething(line))
    {
      continue;
    }
    LabelEntry entry;
    const std::optional<int> label = ReadLabel(SplitWords(line).front(), error);
    if (!label || !readLine(line, entry, error))
    {
      error = InLine(lines.GetNumber()) + error +
        ". Correct the line, or begin it with # to leave it out.";
      return false;
    }
    found[*label] = std::move(entry);
  }
  entries = std::move(found);
  return true;
}

} // namespace

bool IsItkSnapTable(std::string_view text)
{
  const Words words = SplitWords(FirstEntry(text));
  return words.size() > 7 && AreNumbers(words, 0, 7) && words[7][0] == '"';
}

bool IsFreeSurferTable(std::string_view text)
{
  const Words words = SplitWords(FirstEntry(text));
  return words.size() > 4 && AreNumbers(words, 0, 1) && !ReadNumber(words[1]) &&
    FindFreeSurferColor(words) > 0;
}

bool IsNameList(std::string_view text)
{
  const Words words = SplitWords(FirstEntry(text));
  return words.size() > 1 && AreNumbers(words, 0, 1) && !ReadNumber(words[1]) &&
    FindFreeSurferColor(words) == 0;
}

bool ReadItkSnapTable(std::string_view text, LabelEntries& entries, std::string& error)
{
  return ReadTable(text, ReadItkSnapLine, entries, error);
}

bool ReadFreeSurferTable(std::string_view text, LabelEntries& entries, std::string& error)
{
  return ReadTable(text, ReadFreeSurferLine, entries, error);
}

bool ReadNameList(std::string_view text, LabelEntries& entries, std::string& error)
{
  return ReadTable(text, ReadNameLine, entries, error);
}

bool IsPalette(std::string_view bytes)
{
  return bytes.size() == 3 * PaletteLabels;
}

void ReadPalette(std::string_view bytes, LabelEntries& entries)
{
  entries.clear();
  for (int label = 0; label < PaletteLabels; ++label)
  {
    std::array<double, 3> color{};
    for (std::size_t c = 0; c < color.size(); ++c)
    {
      color[c] =
        static_cast<unsigned char>(bytes[c * PaletteLabels + static_cast<std::size_t>(label)]) /
        255.0;
    }
    entries[label].Color = color;
  }
}

} // namespace VolumeHaptics
