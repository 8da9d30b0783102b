// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Material/Labels/NrrdLabels.h"

#include "VTK/Material/Labels/LabelText.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace VolumeHaptics
{
namespace
{

constexpr std::string_view Magic = "NRRD000";
constexpr std::string_view Prefix = "Segment";

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

/** One segment, as the header describes it. */
struct SegmentFields
{
  std::optional<int> Layer;
  std::optional<int> Value;
  LabelEntry Entry;
};

/** Splits SegmentN_Field. False for other keys. */
bool SplitKey(std::string_view key, int& number, std::string_view& field)
{
  const std::size_t underscore = key.find('_');
  if (key.substr(0, Prefix.size()) != Prefix || underscore == std::string_view::npos)
  {
    return false;
  }
  const std::string_view digits = key.substr(Prefix.size(), underscore - Prefix.size());
  std::string ignored;
  if (digits.empty() || digits.find_first_not_of("0123456789") != std::string_view::npos)
  {
    return false;
  }
  const std::optional<int> found = ReadLabel(digits, ignored);
  number = found.value_or(0);
  field = key.substr(underscore + 1);
  return found.has_value();
}

bool ReadField(
  std::string_view field, const std::string& value, SegmentFields& segment, std::string& error)
{
  if (field == "Name")
  {
    segment.Entry.Name = MakeLabelName(value);
  }
  else if (field == "LabelValue")
  {
    segment.Value = ReadLabel(value, error);
    return segment.Value.has_value();
  }
  else if (field == "Layer")
  {
    segment.Layer = ReadLabel(value, error);
    if (!segment.Layer || *segment.Layer < 0)
    {
      error = "the layer " + Quote(value) + " is not a whole number, 0 or more";
      return false;
    }
  }
  else if (field == "Color")
  {
    const std::vector<std::string_view> words = SplitWords(value);
    const auto part = [&words](std::size_t i) { return ReadNumber(words[i]).value_or(-1.0); };
    if (words.size() == 3)
    {
      segment.Entry.Color = MakeColor(part(0), part(1), part(2));
    }
    if (!segment.Entry.Color)
    {
      error = "the colour " + Quote(value) + " is not three numbers from 0 to 1";
      return false;
    }
  }
  return true;
}

bool ReadSegments(NrrdHeader& header, std::string& error)
{
  std::map<int, SegmentFields> segments;
  for (const auto& [key, value] : header.Values)
  {
    int number = 0;
    std::string_view field;
    if (SplitKey(key, number, field) && !ReadField(field, value, segments[number], error))
    {
      error = Quote(key) + " can't be used: " + error + ". Save the segmentation again.";
      return false;
    }
  }
  std::set<int> values;
  bool isUnique = true;
  for (auto& [number, fields] : segments)
  {
    NrrdSegment segment;
    segment.Value = fields.Value.value_or(1);
    segment.Layer = fields.Layer.value_or(fields.Value ? 0 : number);
    segment.Entry = std::move(fields.Entry);
    isUnique = values.insert(segment.Value).second && isUnique;
    header.Segments.push_back(std::move(segment));
  }
  auto fields = segments.begin();
  for (NrrdSegment& segment : header.Segments)
  {
    // The largest number has no successor.
    const int number = (fields++)->first;
    segment.Label = isUnique ? segment.Value : number + (number < 0x7FFFFFFF ? 1 : 0);
  }
  return true;
}

} // namespace

bool IsNrrd(std::string_view bytes)
{
  return bytes.substr(0, Magic.size()) == Magic;
}

bool ReadNrrdHeader(std::string_view bytes, NrrdHeader& header, std::string& error)
{
  header = {};
  std::string_view rest = bytes;
  bool hasEnd = false;
  while (!rest.empty() && !hasEnd)
  {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = Trim(rest.substr(0, end));
    const std::size_t colon = line.find(": ");
    const std::size_t equals = line.find(":=");
    rest.remove_prefix(std::min(end + 1, rest.size()));
    hasEnd = line.empty();
    if (line.substr(0, 1) == "#")
    {
      continue;
    }
    if (equals != std::string_view::npos && equals < colon)
    {
      header.Values[Unescape(line.substr(0, equals))] = Unescape(line.substr(equals + 2));
    }
    else if (colon != std::string_view::npos)
    {
      std::string field(line.substr(0, colon));
      std::transform(field.begin(), field.end(), field.begin(),
        [](char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c); });
      header.Fields[field] = Trim(line.substr(colon + 2));
    }
  }
  header.Size = bytes.size() - rest.size();
  const bool isDetached = header.Fields.count("data file") + header.Fields.count("datafile") > 0;
  if (!hasEnd && !isDetached)
  {
    error = "its NRRD header has no end. Check that the file is complete.";
    return false;
  }
  return ReadSegments(header, error);
}

bool ReadNrrdLabels(std::string_view bytes, LabelEntries& entries, std::string& error)
{
  NrrdHeader header;
  if (!ReadNrrdHeader(bytes, header, error))
  {
    return false;
  }
  if (header.Segments.empty())
  {
    error = "its NRRD header has no segments. Save it as a segmentation (.seg.nrrd), or give the "
            "names in a table of their own.";
    return false;
  }
  LabelEntries found;
  for (NrrdSegment& segment : header.Segments)
  {
    found[segment.Label] = std::move(segment.Entry);
  }
  entries = std::move(found);
  return true;
}

} // namespace VolumeHaptics
