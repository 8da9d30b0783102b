// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Material/Labels/NrrdLabels.h"

#include "VTK/Base/ByteOrder.h"
#include "VTK/Material/Labels/LabelText.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace VolumeHaptics
{
namespace
{

constexpr std::string_view Prefix = "Segment";

/** Fields of one segment in the header. */
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
    // Avoid an overflow: the largest int has no successor.
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

//------------------------------------------------------------------------------
namespace
{

constexpr const char* SaveAgain =
  ". Save it again in 3D Slicer as one file, .seg.nrrd, of a binary labelmap.";
constexpr double MostSamples = 1e12;

bool ReadType(const NrrdHeader& header, NrrdImage& image, std::string& error)
{
  const NrrdType type = header.GetType();
  if (type.Size == 0 || !type.IsInteger)
  {
    error = "its samples are of the type " + Quote(header.GetField("type")) +
      ", labels are whole numbers" + SaveAgain;
    return false;
  }
  image.SampleSize = type.Size;
  image.IsSigned = type.IsSigned;
  image.IsSwapped =
    image.SampleSize > 1 && !header.GetField("endian").empty() && IsOtherByteOrder(header.IsBig());
  return true;
}

bool ReadEncoding(const NrrdHeader& header, NrrdImage& image, std::string& error)
{
  if (!header.GetDataFile().empty())
  {
    error = std::string("its samples are in another file") + SaveAgain;
    return false;
  }
  for (const char* const field : { "byte skip", "line skip", "block size" })
  {
    if (!header.GetField(field).empty() && header.GetField(field) != "0")
    {
      error = std::string("its header has the field \"") + field + "\"" + SaveAgain;
      return false;
    }
  }
  const std::string encoding = MakeKey(header.GetField("encoding"));
  image.IsCompressed = encoding == "gzip" || encoding == "gz";
  if (!image.IsCompressed && encoding != "raw")
  {
    error = "its encoding is " + Quote(encoding) + ", not raw or gzip" + SaveAgain;
    return false;
  }
  return true;
}

/** Returns the index of the axis of layers; the number of axes if there is no such axis. */
std::size_t FindListAxis(const NrrdHeader& header, std::size_t axes)
{
  const std::vector<std::string> directions = SplitNrrdVectors(header.GetField("space directions"));
  const auto none = std::find(directions.begin(), directions.end(), "none");
  if (none != directions.end())
  {
    return static_cast<std::size_t>(none - directions.begin());
  }
  const std::string kinds = header.GetField("kinds");
  const std::vector<std::string_view> words = SplitWords(kinds);
  const auto list = std::find(words.begin(), words.end(), "list");
  return list == words.end() ? axes : static_cast<std::size_t>(list - words.begin());
}

bool ReadSizes(
  const NrrdHeader& header, NrrdImage& image, std::size_t& listAxis, std::string& error)
{
  const std::string text = header.GetField("sizes");
  std::vector<std::size_t> sizes;
  double samples = 1.0;
  for (const std::string_view word : SplitWords(text))
  {
    std::string ignored;
    const int size = ReadLabel(word, ignored).value_or(0);
    samples *= size;
    sizes.push_back(static_cast<std::size_t>(std::max(size, 0)));
  }
  listAxis = FindListAxis(header, sizes.size());
  const bool hasLayers = sizes.size() == 4;
  if ((sizes.size() != 3 && !hasLayers) || (hasLayers && listAxis > 3) || !(samples >= 1.0) ||
    samples > MostSamples)
  {
    error = "its sizes " + Quote(text) +
      " are not three sizes of a volume, with or without a list of layers" + SaveAgain;
    return false;
  }
  if (hasLayers)
  {
    image.Layers = sizes[listAxis];
    for (std::size_t axis = 0; axis < listAxis; ++axis)
    {
      image.Inner *= sizes[axis];
    }
    sizes.erase(sizes.begin() + static_cast<std::ptrdiff_t>(listAxis));
  }
  std::copy_n(sizes.begin(), 3, image.Size.begin());
  return true;
}

double Determinant(const std::array<double, 9>& m)
{
  return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
    m[2] * (m[3] * m[7] - m[4] * m[6]);
}

bool ReadFrame(const NrrdHeader& header, NrrdImage& image, std::string& error)
{
  const std::string directions = header.GetField("space directions");
  const std::string sizes = header.GetField("spacings");
  const std::string origin = header.GetField("space origin");
  const auto steps = FindNrrdSteps(header);
  const NrrdVector spacings = FindNrrdSpacings(header);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (directions.empty() && !steps)
    {
      image.Spacing[axis] = spacings[axis];
      continue;
    }
    const NrrdVector step = steps ? (*steps)[axis] : NrrdVector{};
    image.Spacing[axis] = std::hypot(step[0], step[1], step[2]);
    for (std::size_t row = 0; row < 3 && image.Spacing[axis] > 0.0; ++row)
    {
      image.Directions[3 * row + axis] = step[row] / image.Spacing[axis];
    }
  }
  const std::optional<NrrdVector> position = FindNrrdOrigin(header);
  const bool isGood = std::all_of(image.Spacing.begin(), image.Spacing.end(),
    [](double spacing) { return spacing > 0.0 && std::isfinite(spacing); });
  if (!isGood || !position || !(std::abs(Determinant(image.Directions)) > 1e-6))
  {
    error = "its space directions " + Quote(directions) + ", spacings " + Quote(sizes) +
      " or its space origin " + Quote(origin) + " place no volume in space" + SaveAgain;
    return false;
  }
  image.Origin = *position;
  return true;
}

/** Reads a sample of any type as a 64-bit number. */
std::int64_t LoadSample(const char* from, const NrrdImage& image)
{
  unsigned char raw[sizeof(std::uint64_t)];
  std::copy_n(from, image.SampleSize, raw);
  if (image.IsSwapped)
  {
    std::reverse(raw, raw + image.SampleSize);
  }
  const auto load = [&raw](auto number)
  {
    std::memcpy(&number, raw, sizeof(number));
    return static_cast<std::int64_t>(number);
  };
  switch (image.SampleSize)
  {
    case 1:
      return image.IsSigned ? load(std::int8_t{}) : load(std::uint8_t{});
    case 2:
      return image.IsSigned ? load(std::int16_t{}) : load(std::uint16_t{});
    case 4:
      return image.IsSigned ? load(std::int32_t{}) : load(std::uint32_t{});
    default:
      return image.IsSigned ? load(std::int64_t{}) : load(std::uint64_t{});
  }
}

/** Maps the values in each layer to segments and their labels. */
class SegmentMap
{
public:
  SegmentMap(const SegmentationHeader& header, std::size_t layers)
    : Header(header)
    , ByLayer(layers)
  {
    for (std::size_t i = 0; i < header.Segments.size(); ++i)
    {
      const NrrdSegment& segment = header.Segments[i];
      this->KeepsValues = this->KeepsValues && segment.Label == segment.Value;
      if (static_cast<std::size_t>(segment.Layer) < layers)
      {
        this->ByLayer[static_cast<std::size_t>(segment.Layer)][segment.Value] =
          static_cast<int>(i) + 1;
      }
    }
  }

  /**
   * Returns the rank of a value's segment, and its label in `label`. Returns 0 for a value without
   * a segment.
   */
  int Rank(std::size_t layer, std::int64_t value, int& label)
  {
    const auto found = this->ByLayer[layer].find(value);
    if (found == this->ByLayer[layer].end())
    {
      label = this->KeepsValues ? static_cast<int>(value) : 0;
      return 0;
    }
    label = this->Header.Segments[static_cast<std::size_t>(found->second) - 1].Label;
    return found->second;
  }

private:
  const SegmentationHeader& Header;
  std::vector<std::unordered_map<std::int64_t, int>> ByLayer;
  bool KeepsValues = true;
};

} // namespace

bool ReadNrrdImage(const NrrdHeader& header, NrrdImage& image, std::string& error)
{
  image = {};
  const auto representation = header.Values.find("Segmentation_SourceRepresentation");
  if (representation != header.Values.end() && representation->second == "Fractional labelmap")
  {
    error = std::string("it is a fractional labelmap") + SaveAgain;
    return false;
  }
  std::size_t listAxis = 0;
  return ReadType(header, image, error) && ReadEncoding(header, image, error) &&
    ReadSizes(header, image, listAxis, error) && ReadFrame(header, image, error);
}

bool ReadNrrdSamples(const SegmentationHeader& header, const NrrdImage& image,
  const NrrdBytes& bytes, int* labels, std::string& error)
{
  constexpr std::size_t chunkSamples = 1 << 15;
  const std::size_t voxels = image.CountVoxels();
  const std::size_t samples = voxels * image.Layers;
  SegmentMap segments(header, image.Layers);
  std::vector<int> ranks(image.Layers > 1 ? voxels : 0);
  std::vector<char> chunk(chunkSamples * image.SampleSize);
  std::int64_t lastValue = 0;
  std::size_t lastLayer = 0;
  int label = 0;
  int rank = 0;
  for (std::size_t position = 0; position < samples;)
  {
    const std::size_t count = std::min(chunkSamples, samples - position);
    if (bytes(chunk.data(), count * image.SampleSize) != count * image.SampleSize)
    {
      error = "it has fewer samples than its header says. Check that the file is complete.";
      return false;
    }
    for (std::size_t i = 0; i < count; ++i, ++position)
    {
      const std::int64_t value = LoadSample(&chunk[i * image.SampleSize], image);
      if (value == 0)
      {
        continue;
      }
      if (value < std::numeric_limits<int>::min() || value > std::numeric_limits<int>::max())
      {
        error = "a voxel has the label " + std::to_string(value) +
          ", which is out of range. Number the labels from -2147483648 to 2147483647.";
        return false;
      }
      const std::size_t layer = position / image.Inner % image.Layers;
      if (value != lastValue || layer != lastLayer)
      {
        rank = segments.Rank(layer, value, label);
        lastValue = value;
        lastLayer = layer;
      }
      const std::size_t voxel =
        position % image.Inner + position / (image.Inner * image.Layers) * image.Inner;
      if (ranks.empty())
      {
        labels[voxel] = label;
      }
      else if (rank >= ranks[voxel] && label != 0)
      {
        labels[voxel] = label;
        ranks[voxel] = rank;
      }
    }
  }
  return true;
}

} // namespace VolumeHaptics
