// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Base/NrrdHeader.h"

#include "Core/Math/NumberText.h"
#include "Core/Platform/HapticFiles.h"
#include "VTK/Base/LengthUnit.h"

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
/**
 * Largest header (bytes) that is read from a file. Headers of segmentations have some kilobytes.
 */
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

/** Converts a text to lower case and removes blanks. */
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

/**
 * Resolves the escape sequences \\ and
 *  in keys and values.
 */
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

/** Parses a line, without blanks around it, and adds its field or key to the header. */
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

/**
 * Reads a vector "(x,y,z)" without blanks, and multiplies each component by a factor. Drops the
 * fourth component, which is a time.
 */
std::optional<NrrdVector> ParseNrrdVector(
  std::string_view text, const NrrdVector& factors, std::size_t count = 3)
{
  if (text.size() < 2 || text.front() != '(' || text.back() != ')')
  {
    return {};
  }
  text = text.substr(1, text.size() - 2);
  NrrdVector vector{};
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t comma = text.find(',');
    const std::optional<double> number = ParseNumber(text.substr(0, comma));
    const bool isLast = i + 1 == count;
    if (!number || !std::isfinite(*number) || (comma == std::string_view::npos) != isLast)
    {
      return {};
    }
    if (i < 3)
    {
      vector[i] = factors[i] * *number;
    }
    text.remove_prefix(isLast ? text.size() : comma + 1);
  }
  return vector;
}

/** Splits a list of texts that are quoted or separated by blanks. */
std::vector<std::string> SplitNrrdTexts(const std::string& list)
{
  std::vector<std::string> texts;
  bool isQuoted = false;
  bool isOpen = false;
  for (const char letter : list)
  {
    const bool isMark = letter == '"';
    const bool isBlank = letter == ' ' || letter == '\t';
    if (isMark ? !isQuoted : (!isBlank && !isQuoted && !isOpen))
    {
      texts.emplace_back();
    }
    isQuoted = isQuoted != isMark;
    isOpen = !isMark && !isBlank;
    if (!isMark && (isQuoted || !isBlank))
    {
      texts.back() += letter;
    }
  }
  return texts;
}

/** Returns the units of a field, one per axis. */
std::vector<std::string> ReadNrrdUnits(const NrrdHeader& header, const char* field)
{
  return SplitNrrdTexts(header.GetField(field));
}

/** Returns the length (mm) of the unit of an axis; 1 if the unit is missing or unknown. */
double UnitOf(const std::vector<std::string>& units, std::size_t axis)
{
  const double unit = axis < units.size() ? MillimetresPerUnit(units[axis]) : 0.0;
  return unit > 0.0 ? unit : 1.0;
}

/** Returns the factors that convert positions in the header's space to millimetres in LPS. */
NrrdVector ComputeSpaceFactors(const NrrdHeader& header)
{
  NrrdVector factors = FindNrrdSpace(header).Signs;
  const std::vector<std::string> units = ReadNrrdUnits(header, "space units");
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    factors[axis] *= UnitOf(units, axis);
  }
  return factors;
}

std::vector<std::string> SplitNrrdWords(const std::string& text)
{
  std::istringstream words(text);
  return { std::istream_iterator<std::string>(words), {} };
}

/**
 * Returns the number for an axis from a field with one number per axis; nothing unless it is
 * finite.
 */
std::optional<double> NumberOfAxis(const NrrdHeader& header, const char* field, std::size_t axis)
{
  const std::vector<std::string> words = SplitNrrdWords(header.GetField(field));
  const std::optional<double> number =
    axis < words.size() ? ParseNumber(words[axis]) : std::nullopt;
  return number && std::isfinite(*number) ? number : std::nullopt;
}

/**
 * Returns whether samples lie at the centres of cells, so that "axis mins" is half a voxel before
 * the first sample.
 */
bool HasCells(const NrrdHeader& header, std::size_t axis)
{
  const std::vector<std::string> centers = SplitNrrdWords(header.GetField("centers"));
  const std::vector<std::string> older = SplitNrrdWords(header.GetField("centerings"));
  const std::vector<std::string>& told = centers.empty() ? older : centers;
  return axis < told.size() && told[axis] == "cell";
}

/**
 * Returns the spacing of samples along an axis, in the axis's unit; nothing if the header lacks it.
 */
std::optional<double> FindAxisSpacing(const NrrdHeader& header, std::size_t axis)
{
  const std::optional<double> given = NumberOfAxis(header, "spacings", axis);
  const std::optional<double> least = NumberOfAxis(header, "axis mins", axis);
  const std::optional<double> most = NumberOfAxis(header, "axis maxs", axis);
  const double count =
    NumberOfAxis(header, "sizes", axis).value_or(1.0) - (HasCells(header, axis) ? 0.0 : 1.0);
  return given || !least || !most || count <= 0.0 ? given : std::optional((*most - *least) / count);
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
    const bool isListed = header.GetDataFile().compare(0, 4, "LIST") == 0;
    if (isListed && !line.empty() && line.front() != '#')
    {
      header.Files.emplace_back(line);
    }
    else
    {
      AddLine(line, header);
    }
    header.Size = bytes.size() - rest.size();
  }
  return header;
}

NrrdHeader ReadNrrdHeader(const std::string& path)
{
  std::ifstream file = OpenStream(path);
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
  const bool isLeftHanded = is("3d-left-handed", "3dl");
  return { is("left-posterior-superior", "lps"), isLeftHanded,
    { 1.0, 1.0, isLeftHanded ? -1.0 : 1.0 } };
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

std::optional<std::array<std::size_t, 3>> ReadNrrdAxes(const NrrdHeader& header)
{
  const std::vector<std::string> directions = SplitNrrdVectors(header.GetField("space directions"));
  const std::vector<std::string> kinds = SplitNrrdWords(header.GetField("kinds"));
  const std::size_t count = SplitNrrdWords(header.GetField("sizes")).size();
  const auto find = [count](const auto& isOfSpace)
  {
    std::vector<std::size_t> axes;
    for (std::size_t axis = 0; axis < count; ++axis)
    {
      axes.insert(axes.end(), isOfSpace(axis) ? 1 : 0, axis);
    }
    return axes;
  };
  std::vector<std::size_t> axes = find([](std::size_t axis) { return axis < 3; });
  if (directions.size() == count &&
    std::find(directions.begin(), directions.end(), "none") != directions.end())
  {
    axes = find([&](std::size_t axis) { return directions[axis] != "none"; });
  }
  else if (kinds.size() == count)
  {
    const auto told = find([&](std::size_t axis)
      { return kinds[axis] == "domain" || kinds[axis] == "space" || kinds[axis] == "???"; });
    axes = told.size() >= 3 ? told : axes;
    axes.resize(std::min<std::size_t>(axes.size(), 3)); // the fourth axis of ITK's files is time
  }
  return axes.size() == 3 ? std::optional<std::array<std::size_t, 3>>({ axes[0], axes[1], axes[2] })
                          : std::nullopt;
}

std::optional<std::array<NrrdVector, 3>> FindNrrdSteps(const NrrdHeader& header)
{
  std::vector<std::string> words = SplitNrrdVectors(header.GetField("space directions"));
  words.erase(std::remove(words.begin(), words.end(), "none"), words.end());
  const NrrdVector factors = ComputeSpaceFactors(header);
  std::array<NrrdVector, 3> steps{};
  const NrrdVector signs = FindNrrdSpace(header).Signs;
  const bool areTurned = words.empty() && (signs[1] < 0.0 || signs[2] < 0.0);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (areTurned) // steps are along the axes of the turned space
    {
      steps[axis][axis] = signs[axis] * FindNrrdSpacings(header)[axis];
      continue;
    }
    const std::optional<NrrdVector> step = words.size() == 3 || words.size() == 4
      ? ParseNrrdVector(words[axis], factors, words.size())
      : std::nullopt;
    if (!step)
    {
      return {};
    }
    steps[axis] = *step;
  }
  return steps;
}

NrrdVector FindNrrdSpacings(const NrrdHeader& header)
{
  const std::vector<std::string> units = ReadNrrdUnits(header, "units");
  const auto axes = ReadNrrdAxes(header);
  NrrdVector spacings{ 1.0, 1.0, 1.0 };
  for (std::size_t a = 0; axes && a < 3; ++a)
  {
    spacings[a] = UnitOf(units, (*axes)[a]) * FindAxisSpacing(header, (*axes)[a]).value_or(1.0);
  }
  return spacings;
}

std::optional<NrrdVector> FindNrrdOrigin(const NrrdHeader& header)
{
  const std::vector<std::string> words = SplitNrrdVectors(header.GetField("space origin"));
  if (!words.empty())
  {
    const NrrdVector factors = ComputeSpaceFactors(header);
    const auto place = ParseNrrdVector(words.front(), factors);
    return words.size() != 1 ? std::nullopt
      : place                ? place
                             : ParseNrrdVector(words.front(), factors, 4);
  }
  NrrdVector origin{};
  const NrrdVector signs = FindNrrdSpace(header).Signs;
  const std::vector<std::string> units = ReadNrrdUnits(header, "units");
  const auto axes = ReadNrrdAxes(header);
  for (std::size_t a = 0; axes && a < 3; ++a)
  {
    const std::size_t axis = (*axes)[a];
    if (const auto least = NumberOfAxis(header, "axis mins", axis))
    {
      const double half =
        HasCells(header, axis) ? 0.5 * FindAxisSpacing(header, axis).value_or(1.0) : 0.0;
      origin[a] = signs[a] * UnitOf(units, axis) * (*least + half);
    }
  }
  return origin;
}

std::string DescribeNrrdGuess(const NrrdHeader& header)
{
  const auto axes = ReadNrrdAxes(header);
  bool isSpaced = true;
  for (std::size_t a = 0; axes && a < 3 && header.GetField("space directions").empty(); ++a)
  {
    isSpaced = isSpaced && FindAxisSpacing(header, (*axes)[a]);
  }
  const std::string encoding = MakePlain(header.GetField("encoding"));
  const bool isOrdered = header.GetType().Size < 2 || !header.GetField("endian").empty() ||
    encoding == "ascii" || encoding == "text" || encoding == "txt";
  const std::string spacing =
    isSpaced ? "" : "no distance of samples along an axis: 1 mm is assumed";
  return spacing + (isSpaced || isOrdered ? "" : "; ") +
    (isOrdered ? "" : "no order of bytes (endian): the lower byte first is assumed");
}

std::string DescribeNrrdUnits(const NrrdHeader& header)
{
  const std::vector<std::string> ofSpace = ReadNrrdUnits(header, "space units");
  const std::vector<std::string> units = ofSpace.empty() ? ReadNrrdUnits(header, "units") : ofSpace;
  for (const std::string& unit : units)
  {
    if (!unit.empty() && MillimetresPerUnit(unit) != 1.0)
    {
      return MillimetresPerUnit(unit) > 0.0
        ? "lengths turned from the unit " + Printable(unit) + " into millimetres"
        : "the unit " + Printable(unit) + " is not known: lengths are taken for millimetres";
    }
  }
  return {};
}

} // namespace VolumeHaptics
