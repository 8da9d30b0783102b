// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Base/NrrdHeader.h"

#include "Core/Math/NumberText.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>

namespace VolumeHaptics
{
namespace
{

constexpr std::string_view NrrdMagic = "NRRD000";
/** Limit on the size of a header that is read from a file; segmentations have some kilobytes. */
constexpr std::size_t LongestNrrdHeader = std::size_t{ 1 } << 24;

struct NamedType
{
  NrrdType Type;
  const char* Names[6];
};
constexpr NamedType NrrdTypes[] = {
  { { 1, true, true }, { "signedchar", "int8", "int8_t" } },
  { { 1, true, false }, { "uchar", "unsignedchar", "uint8", "uint8_t" } },
  { { 2, true, true },
    { "short", "shortint", "signedshort", "signedshortint", "int16", "int16_t" } },
  { { 2, true, false }, { "ushort", "unsignedshort", "unsignedshortint", "uint16", "uint16_t" } },
  { { 4, true, true }, { "int", "signedint", "int32", "int32_t" } },
  { { 4, true, false }, { "uint", "unsignedint", "uint32", "uint32_t" } },
  { { 8, true, true },
    { "longlong", "longlongint", "signedlonglong", "signedlonglongint", "int64", "int64_t" } },
  { { 8, true, false },
    { "ulonglong", "unsignedlonglong", "unsignedlonglongint", "uint64", "uint64_t" } },
  { { 4, false, true }, { "float" } },
  { { 8, false, true }, { "double" } },
};

std::string_view TrimLine(std::string_view text)
{
  constexpr std::string_view blanks = " \t\v\f\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string_view::npos
    ? std::string_view()
    : text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

/** Converts a text to lower case, without blanks. */
std::string MakePlain(std::string_view text)
{
  std::string plain;
  for (const char c : text)
  {
    if (c != ' ' && c != '\t')
    {
      plain += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    }
  }
  return plain;
}

/** Resolves the backslashes of keys and values: \\ and \n. */
std::string Unescape(std::string_view text)
{
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const bool isEscape = text[i] == '\\' && i + 1 < text.size();
    if (isEscape && (text[i + 1] == 'n' || text[i + 1] == '\\'))
    {
      ++i;
      result += text[i] == 'n' ? '\n' : '\\';
    }
    else
    {
      result += text[i];
    }
  }
  return result;
}

/** Adds a line without blanks around it. */
void AddLine(std::string_view line, NrrdHeader& header)
{
  const std::size_t equals = line.find(":=");
  std::size_t colon = line.find(": ");
  colon =
    colon == std::string_view::npos && equals == std::string_view::npos ? line.find(':') : colon;
  if (line.substr(0, 1) == "#")
  {
    return;
  }
  if (equals != std::string_view::npos && equals < colon)
  {
    header.Values[Unescape(line.substr(0, equals))] = Unescape(line.substr(equals + 2));
  }
  else if (colon != std::string_view::npos)
  {
    header.Fields[MakePlain(line.substr(0, colon))] = TrimLine(line.substr(colon + 1));
  }
}

/** Reads three numbers in parentheses, "(x,y,z)" without blanks, and multiplies each by a sign. */
std::optional<NrrdVector> ParseNrrdVector(std::string_view text, const NrrdVector& signs)
{
  if (text.size() < 2 || text.front() != '(' || text.back() != ')')
  {
    return {};
  }
  text = text.substr(1, text.size() - 2);
  NrrdVector vector{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::size_t comma = text.find(',');
    const std::optional<double> number = ParseNumber(text.substr(0, comma));
    if (!number || !std::isfinite(*number) || (comma == std::string_view::npos) != (i == 2))
    {
      return {};
    }
    vector[i] = signs[i] * *number;
    text.remove_prefix(i == 2 ? text.size() : comma + 1);
  }
  return vector;
}

} // namespace

std::string NrrdHeader::GetField(const std::string& name) const
{
  const auto field = this->Fields.find(MakePlain(name));
  return field == this->Fields.end() ? std::string() : field->second;
}

std::vector<double> NrrdHeader::GetNumbers(const std::string& name) const
{
  std::vector<double> numbers;
  std::istringstream words(this->GetField(name));
  for (std::string word; words >> word;)
  {
    if (const std::optional<double> number = ParseNumber(word))
    {
      numbers.push_back(*number);
    }
  }
  return numbers;
}

NrrdType NrrdHeader::GetType() const
{
  const std::string name = MakePlain(this->GetField("type"));
  for (const NamedType& named : NrrdTypes)
  {
    const auto isName = [&name](const char* known) { return known && name == known; };
    if (std::any_of(std::begin(named.Names), std::end(named.Names), isName))
    {
      return named.Type;
    }
  }
  return {};
}

bool NrrdHeader::IsBig() const
{
  return MakePlain(this->GetField("endian")) == "big";
}

bool IsNrrd(std::string_view bytes)
{
  return bytes.substr(0, NrrdMagic.size()) == NrrdMagic;
}

NrrdHeader ParseNrrdHeader(std::string_view bytes)
{
  NrrdHeader header;
  std::string_view rest = IsNrrd(bytes) ? bytes : std::string_view();
  while (!rest.empty() && !header.HasEnd)
  {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = TrimLine(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    header.HasEnd = line.empty();
    AddLine(line, header);
    header.Size = bytes.size() - rest.size();
  }
  return header;
}

NrrdHeader ReadNrrdHeader(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::string bytes;
  std::string line;
  do
  {
    std::getline(file, line);
    bytes += line + '\n';
  } while (IsNrrd(bytes) && file && !TrimLine(line).empty() && bytes.size() < LongestNrrdHeader);
  return ParseNrrdHeader(bytes);
}

NrrdSpace FindNrrdSpace(const NrrdHeader& header)
{
  const std::string space = MakePlain(header.GetField("space"));
  const auto is = [&space](const std::string& name, const std::string& letters) {
    return space == name || space == name + "-time" || space == letters || space == letters + "t";
  };
  if (is("right-anterior-superior", "ras"))
  {
    return { true, false, { -1.0, -1.0, 1.0 } };
  }
  if (is("left-anterior-superior", "las"))
  {
    return { true, true, { 1.0, -1.0, 1.0 } };
  }
  return { is("left-posterior-superior", "lps"), is("3d-left-handed", "3d-left-handed"),
    { 1.0, 1.0, 1.0 } };
}

std::vector<std::string> SplitNrrdVectors(const std::string& text)
{
  std::string joined;
  int depth = 0;
  for (const char character : text)
  {
    depth += character == '(' ? 1 : character == ')' ? -1 : 0;
    if (depth <= 0 || (character != ' ' && character != '\t'))
    {
      joined += character;
    }
  }
  std::istringstream words(joined);
  return { std::istream_iterator<std::string>(words), {} };
}

std::optional<std::array<NrrdVector, 3>> FindNrrdSteps(const NrrdHeader& header)
{
  std::vector<std::string> words = SplitNrrdVectors(header.GetField("space directions"));
  words.erase(std::remove(words.begin(), words.end(), "none"), words.end());
  const NrrdVector signs = FindNrrdSpace(header).Signs;
  std::array<NrrdVector, 3> steps{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::optional<NrrdVector> step =
      words.size() == 3 ? ParseNrrdVector(words[axis], signs) : std::nullopt;
    if (!step)
    {
      return {};
    }
    steps[axis] = *step;
  }
  return steps;
}

std::optional<NrrdVector> FindNrrdOrigin(const NrrdHeader& header)
{
  const std::vector<std::string> words = SplitNrrdVectors(header.GetField("space origin"));
  if (words.empty())
  {
    return NrrdVector{};
  }
  return words.size() == 1 ? ParseNrrdVector(words.front(), FindNrrdSpace(header).Signs)
                           : std::nullopt;
}

} // namespace VolumeHaptics
