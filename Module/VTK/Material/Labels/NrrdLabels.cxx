// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Material/Labels/NrrdLabels.h"

#include "VTK/Material/Labels/LabelText.h"

#include <map>
#include <optional>
#include <set>
#include <utility>

namespace VolumeHaptics
{
namespace
{

constexpr std::string_view Prefix = "Segment";

/** One segment, as the header describes it. */
struct SegmentFields
{
  std::optional<int> Layer;
  std::optional<int> Value;
  LabelEntry Entry;
};

/** Splits a key SegmentN_Field into N and Field. Returns false for other keys. */
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

bool ReadSegments(SegmentationHeader& header, std::string& error)
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
    // The largest int has no successor.
    const int number = (fields++)->first;
    segment.Label = isUnique ? segment.Value : number + (number < 0x7FFFFFFF ? 1 : 0);
  }
  return true;
}

} // namespace

bool ReadSegmentationHeader(std::string_view bytes, SegmentationHeader& header, std::string& error)
{
  header = { ParseNrrdHeader(bytes), {} };
  if (!header.HasEnd && header.GetDataFile().empty())
  {
    error = "its NRRD header has no end. Check that the file is complete.";
    return false;
  }
  return ReadSegments(header, error);
}

bool ReadNrrdLabels(std::string_view bytes, LabelEntries& entries, std::string& error)
{
  SegmentationHeader header;
  if (!ReadSegmentationHeader(bytes, header, error))
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
