// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Material/Labels/LabelText.h"

#include "Core/Math/NumberText.h"
#include "Core/Platform/HapticFiles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace VolumeHaptics
{
namespace
{

constexpr std::string_view Blanks = " \t\v\f\r\n";

} // namespace

bool LabelLines::Next(std::string_view& line)
{
  if (this->Rest.empty())
  {
    return false;
  }
  ++this->Number;
  const std::size_t end = std::min(this->Rest.find_first_of("\r\n"), this->Rest.size());
  line = Trim(this->Rest.substr(0, end));
  const bool isWindows = this->Rest.substr(end, 2) == "\r\n";
  this->Rest.remove_prefix(std::min(end + (isWindows ? 2 : 1), this->Rest.size()));
  return true;
}

std::string_view Trim(std::string_view text)
{
  const std::size_t first = text.find_first_not_of(Blanks);
  return first == std::string_view::npos
    ? std::string_view()
    : text.substr(first, text.find_last_not_of(Blanks) + 1 - first);
}

std::vector<std::string_view> SplitWords(std::string_view line)
{
  std::vector<std::string_view> words;
  for (line = Trim(line); !line.empty();)
  {
    const std::size_t end = std::min(line.find_first_of(Blanks), line.size());
    words.push_back(line.substr(0, end));
    line = Trim(line.substr(end));
  }
  return words;
}

std::string MakeKey(std::string_view text)
{
  std::string key;
  for (const char character : text.substr(0, text.find('(')))
  {
    if (character >= 'A' && character <= 'Z')
    {
      key += static_cast<char>(character - 'A' + 'a');
    }
    else if (character != '_' && character != '-' && Blanks.find(character) == Blanks.npos)
    {
      key += character;
    }
  }
  return key;
}

std::optional<double> ReadNumber(std::string_view text)
{
  text = Trim(text);
  const std::optional<double> number = ParseNumber(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::optional<int> ReadLabel(std::string_view text, std::string& error)
{
  const std::optional<double> number = ReadNumber(text);
  if (!number || *number != std::floor(*number))
  {
    error = "the label " + Quote(text) + " is not a whole number";
    return {};
  }
  constexpr int least = std::numeric_limits<int>::min();
  constexpr int most = std::numeric_limits<int>::max();
  if (*number < least || *number > most)
  {
    error = "the label " + Quote(text) + " is out of range. Number the labels from " +
      std::to_string(least) + " to " + std::to_string(most);
    return {};
  }
  return static_cast<int>(*number);
}

std::optional<std::array<double, 3>> ReadByteColor(
  std::string_view red, std::string_view green, std::string_view blue)
{
  const std::optional<double> r = ReadNumber(red);
  const std::optional<double> g = ReadNumber(green);
  const std::optional<double> b = ReadNumber(blue);
  return r && g && b ? MakeColor(*r / 255.0, *g / 255.0, *b / 255.0) : std::nullopt;
}

std::optional<std::array<double, 3>> MakeColor(double red, double green, double blue)
{
  const std::array<double, 3> color = { red, green, blue };
  const bool isGood =
    std::all_of(color.begin(), color.end(), [](double part) { return part >= 0.0 && part <= 1.0; });
  return isGood ? std::optional<std::array<double, 3>>(color) : std::nullopt;
}

std::string MakeLabelName(std::string_view text)
{
  const std::string bytes(text);
  const bool isLatin = !IsUtf8(bytes);
  std::string name;
  for (const char character : bytes)
  {
    const auto byte = static_cast<unsigned char>(character);
    if (byte < 0x20 || byte == 0x7F)
    {
      name += ' ';
    }
    else if (isLatin && byte >= 0x80)
    {
      name += static_cast<char>(0xC0 | (byte >> 6));
      name += static_cast<char>(0x80 | (byte & 0x3F));
    }
    else
    {
      name += character;
    }
  }
  return name;
}

std::string Quote(std::string_view text)
{
  constexpr std::size_t most = 40;
  // Do not cut a multi-byte character, because the text would become unprintable.
  std::size_t end = std::min(text.size(), most);
  while (end < text.size() && end > 0 && (text[end] & 0xC0) == 0x80)
  {
    --end;
  }
  return "\"" + Printable(std::string(text.substr(0, end))) + (end < text.size() ? "...\"" : "\"");
}

std::string InLine(int number)
{
  return "Line " + std::to_string(number) + ": ";
}

} // namespace VolumeHaptics
