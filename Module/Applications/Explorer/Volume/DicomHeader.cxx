// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Volume/DicomHeader.h"

#include "Applications/Explorer/Volume/DicomStream.h"

#include "vtkMath.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <locale>
#include <sstream>
#include <vector>

namespace
{
using Explore::DEEPEST;
using Explore::DicomHeader;
using Explore::DicomStream;
using Explore::ITEM;
using Explore::ITEM_END;
using Explore::SEQUENCE_END;
using Explore::UNKNOWN_LENGTH;

constexpr std::uint32_t PIXELS = 0x7fe00010;
constexpr std::uint32_t SHARED_GROUPS = 0x52009229;
constexpr std::uint32_t FRAME_GROUPS = 0x52009230;
constexpr std::uint32_t LONGEST_VALUE = 1024; // the longest value that is read
constexpr int MOST_FRAMES = 100000;
constexpr const char* IMPLICIT_LITTLE = "1.2.840.10008.1.2";
constexpr const char* EXPLICIT_LITTLE = "1.2.840.10008.1.2.1";
constexpr const char* EXPLICIT_BIG = "1.2.840.10008.1.2.2";
constexpr const char* DEFLATED = "1.2.840.10008.1.2.1.99";

/// The places of the frames in a file with several.
struct FramePlaces
{
  std::vector<DicomHeader> Groups; // per frame: differences from the file's header
  std::vector<double> Offsets;     // along the normal, mm
  double Step = 0.0;               // from frame to frame, mm
};

/// Removes the blank or zero that makes lengths even.
std::string TrimValue(std::string text)
{
  text.erase(std::find(text.begin(), text.end(), '\0'), text.end());
  const std::size_t last = text.find_last_not_of(' ');
  text.erase(last == std::string::npos ? 0 : last + 1);
  return text.substr(std::min(text.find_first_not_of(' '), text.size()));
}

/// Decimal numbers between backslashes; false if there are too few.
bool ReadDecimals(const std::string& text, double* numbers, int count)
{
  std::string plain = text;
  std::replace(plain.begin(), plain.end(), '\\', ' ');
  std::istringstream stream(plain);
  stream.imbue(std::locale::classic());
  std::vector<double> read(static_cast<std::size_t>(count));
  for (double& number : read)
  {
    if (!(stream >> number) || !std::isfinite(number))
    {
      return false;
    }
  }
  std::copy(read.begin(), read.end(), numbers);
  return true;
}

int ReadWhole(const std::string& text, int unknown)
{
  double number = 0.0;
  return ReadDecimals(text, &number, 1) && std::abs(number) < 1e9 ? static_cast<int>(number)
                                                                  : unknown;
}

void ReadValue(const DicomStream& stream, std::uint32_t tag, const std::string& value,
  DicomHeader& header, double orientation[6])
{
  const auto number = [&] { return static_cast<int>(stream.Number(value, 0, 2)); };
  switch (tag)
  {
    case 0x00080060:
      header.Modality = TrimValue(value);
      break;
    case 0x0008103e:
      header.Description = TrimValue(value);
      break;
    case 0x0020000e:
      header.Series = TrimValue(value);
      break;
    case 0x00200011:
      header.SeriesNumber = ReadWhole(value, 0);
      break;
    case 0x00200032:
      ReadDecimals(value, header.Position, 3);
      break;
    case 0x00200037:
      ReadDecimals(value, orientation, 6);
      break;
    case 0x00280002:
      header.Samples = number();
      break;
    case 0x00280004:
      header.IsYbr = TrimValue(value) == "YBR_FULL";
      break;
    case 0x00280008:
      header.Frames = ReadWhole(value, 1);
      break;
    case 0x00280010:
      header.Height = number();
      break;
    case 0x00280011:
      header.Width = number();
      break;
    case 0x00280030:
    {
      double spacing[2]; // from row to row first
      if (ReadDecimals(value, spacing, 2))
      {
        header.Spacing[0] = spacing[1];
        header.Spacing[1] = spacing[0];
      }
      break;
    }
    case 0x00280006:
      header.ArePlanes = number() == 1;
      break;
    case 0x00280100:
      header.Bits = number();
      break;
    case 0x00280101:
      header.Stored = number();
      break;
    case 0x00280103:
      header.IsSigned = number() == 1;
      break;
    case 0x00280120:
      if (value.size() >= 2)
      {
        header.Padding = number();
      }
      break;
    case 0x00281052:
      ReadDecimals(value, &header.Intercept, 1);
      break;
    case 0x00281053:
      ReadDecimals(value, &header.Slope, 1);
      break;
    default:
      break;
  }
}

/// Decimal numbers between backslashes, as many as there are.
std::vector<double> ReadAllDecimals(const std::string& text)
{
  std::vector<double> numbers(
    static_cast<std::size_t>(1 + std::count(text.begin(), text.end(), '\\')));
  return ReadDecimals(text, numbers.data(), static_cast<int>(numbers.size()))
    ? numbers
    : std::vector<double>();
}

void ReadPlaces(std::uint32_t tag, const std::string& value, FramePlaces& places)
{
  double step;
  if (tag == 0x3004000c)
  {
    places.Offsets = ReadAllDecimals(value);
  }
  else if (tag == 0x00180088 && ReadDecimals(value, &step, 1))
  {
    places.Step = std::abs(step);
  }
}

/// The functional groups of an item, which are sequences of one item each.
bool IsGroup(std::uint32_t tag)
{
  // The spacing of pixels, the place, the orientation, and slope and intercept.
  return tag == 0x00289110 || tag == 0x00209113 || tag == 0x00209116 || tag == 0x00289145;
}

/// Calls `take` with the value of an element, unless it is longer, and continues after it. False if
/// the file ends too early.
template <typename Take>
bool ReadAndSkip(
  DicomStream& stream, const DicomStream::Element& element, std::uint32_t longest, Take&& take)
{
  const std::uint64_t begin = stream.Place();
  if (element.Length <= longest && element.Length <= stream.Left())
  {
    take(stream.Read(element.Length));
    stream.GoTo(begin);
  }
  return stream.Skip(element);
}

/// Calls `take` for each value in a sequence, with the number of its item in the outermost
/// sequence; groups are entered, other sequences are not. False if the file ends too early.
template <typename Take>
bool WalkItems(
  DicomStream& stream, const DicomStream::Element& sequence, Take&& take, int number, int depth)
{
  const bool isBounded = sequence.Length != UNKNOWN_LENGTH;
  const std::uint64_t end = stream.Place() + (isBounded ? sequence.Length : 0);
  DicomStream::Element element;
  while ((!isBounded || stream.Place() < end) && stream.Next(element))
  {
    if (element.Tag == SEQUENCE_END)
    {
      return true;
    }
    if (element.Tag == ITEM)
    {
      number += depth == 0 ? 1 : 0;
      continue; // enter it: its elements follow
    }
    if (element.Tag == ITEM_END)
    {
      continue;
    }
    if (IsGroup(element.Tag) && depth < DEEPEST)
    {
      if (!WalkItems(stream, element, take, number, depth + 1))
      {
        return false;
      }
      continue;
    }
    const auto takeOfItem = [&](const std::string& value) { take(number, element.Tag, value); };
    if (!ReadAndSkip(stream, element, LONGEST_VALUE, takeOfItem))
    {
      return false;
    }
  }
  return isBounded && stream.Place() >= end;
}

void OrientSlice(const double orientation[6], DicomHeader& header)
{
  double normal[3];
  vtkMath::Cross(orientation, orientation + 3, normal);
  // Else the header has no orientation: an axial slice, as scanners make them by default.
  if (vtkMath::Normalize(normal) > 0.5)
  {
    std::copy_n(orientation, 3, header.Row);
    std::copy_n(orientation + 3, 3, header.Column);
    std::copy_n(normal, 3, header.Normal);
  }
  header.Along = vtkMath::Dot(header.Position, header.Normal);
}

/// Reads the transfer syntax, which says how the data set is written, from the part before the data
/// set. False if this is not a DICOM file.
bool ReadMeta(DicomStream& stream, DicomHeader& header)
{
  constexpr std::uint64_t preamble = 128;
  stream.GoTo(preamble);
  if (stream.Read(4) != "DICM")
  {
    // Files older than the standard begin with the data set, in group 2 or 8.
    stream.GoTo(0);
    const std::string first = stream.Read(6);
    stream.GoTo(0);
    const auto isLetter = [&](std::size_t i) { return first[i] >= 'A' && first[i] <= 'Z'; };
    if (first.size() < 6 || (first[0] != 8 && first[0] != 2) || first[1] != 0 || first[3] != 0)
    {
      return false;
    }
    stream.IsExplicit = isLetter(4) && isLetter(5);
  }
  std::uint64_t place = stream.Place();
  DicomStream::Element element;
  while (stream.Next(element) && element.Tag >> 16 == 2)
  {
    if (element.Length > stream.Left())
    {
      return false;
    }
    const std::string value = element.Tag == 0x00020010 ? stream.Read(element.Length) : "";
    header.TransferSyntax = value.empty() ? header.TransferSyntax : TrimValue(value);
    stream.GoTo(value.empty() ? stream.Place() + element.Length : stream.Place());
    place = stream.Place();
  }
  stream.GoTo(place);
  if (!header.TransferSyntax.empty())
  {
    stream.IsExplicit = header.TransferSyntax != IMPLICIT_LITTLE;
    stream.IsBig = header.TransferSyntax == EXPLICIT_BIG;
  }
  return true;
}

/// Reads everything up to the pixels; false if there are none.
bool ReadDataSet(DicomStream& stream, DicomHeader& header, FramePlaces& places)
{
  double orientation[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
  std::vector<std::array<double, 6>> orientations;
  const auto takeOfFrame = [&](int number, std::uint32_t tag, const std::string& value)
  {
    if (number < 0 || number >= MOST_FRAMES)
    {
      return;
    }
    const auto index = static_cast<std::size_t>(number);
    while (places.Groups.size() <= index)
    {
      places.Groups.push_back(header);
      orientations.emplace_back();
      std::copy_n(orientation, 6, orientations.back().begin());
      places.Groups.back().HasPlaces = false;
    }
    places.Groups[index].HasPlaces = places.Groups[index].HasPlaces || tag == 0x00200032;
    ReadValue(stream, tag, value, places.Groups[index], orientations[index].data());
  };
  constexpr std::uint32_t longestOffsets = 65536;
  DicomStream::Element element;
  while (stream.Next(element) && element.Tag != PIXELS)
  {
    if (element.Tag == SHARED_GROUPS || element.Tag == FRAME_GROUPS)
    {
      const bool isShared = element.Tag == SHARED_GROUPS;
      const auto takeOfAll = [&](int, std::uint32_t tag, const std::string& value)
      { ReadValue(stream, tag, value, header, orientation); };
      if (!(isShared ? WalkItems(stream, element, takeOfAll, -1, 0)
                     : WalkItems(stream, element, takeOfFrame, -1, 0)))
      {
        return false;
      }
      continue;
    }
    const auto takeOfFile = [&](const std::string& value)
    {
      ReadValue(stream, element.Tag, value, header, orientation);
      ReadPlaces(element.Tag, value, places);
    };
    const bool areOffsets = element.Tag == 0x3004000c;
    if (!ReadAndSkip(stream, element, areOffsets ? longestOffsets : LONGEST_VALUE, takeOfFile))
    {
      return false;
    }
  }
  if (element.Tag != PIXELS || header.Width <= 0 || header.Height <= 0 || header.Bits <= 0 ||
    header.Samples <= 0)
  {
    return false;
  }
  header.IsBig = stream.IsBig;
  header.Pixels = stream.Place();
  header.Frames = std::max(header.Frames, 1);
  header.Stored = header.Stored > 0 ? std::min(header.Stored, header.Bits) : header.Bits;
  // The parts of compressed pixels have no common length.
  header.IsWhole = element.Length == UNKNOWN_LENGTH
    ? stream.Left() > 16 && stream.SkipItems()
    : stream.Left() >= header.GetSize() * static_cast<std::uint64_t>(header.Frames);
  OrientSlice(orientation, header);
  for (std::size_t i = 0; i < places.Groups.size(); ++i)
  {
    OrientSlice(orientations[i].data(), places.Groups[i]);
  }
  return true;
}

bool ReadHeader(const std::string& path, DicomHeader& header, FramePlaces& places)
{
  header = {};
  header.File = path;
  DicomStream stream(path);
  // A deflated file is not a readable slice.
  return ReadMeta(stream, header) &&
    (header.TransferSyntax == DEFLATED || ReadDataSet(stream, header, places));
}
} // namespace

namespace Explore
{
bool DicomHeader::IsPlain() const
{
  const bool isPlain = this->TransferSyntax.empty() || this->TransferSyntax == IMPLICIT_LITTLE ||
    this->TransferSyntax == EXPLICIT_LITTLE || this->TransferSyntax == EXPLICIT_BIG;
  return isPlain && (this->Bits == 8 || this->Bits == 16 || this->Bits == 32);
}

std::uint64_t DicomHeader::GetSize() const
{
  return static_cast<std::uint64_t>(this->Width) * this->Height * this->Samples * this->Bits / 8;
}

bool ReadDicomHeader(const std::string& path, DicomHeader& header)
{
  FramePlaces places;
  return ReadHeader(path, header, places);
}

std::vector<DicomHeader> ReadDicomSlices(const std::string& path)
{
  DicomHeader header;
  FramePlaces places;
  if (!ReadHeader(path, header, places))
  {
    return {};
  }
  const int count = std::min(header.Frames, MOST_FRAMES);
  const auto frames = static_cast<std::size_t>(count);
  std::vector<DicomHeader> slices(frames, header);
  const bool haveGroups = places.Groups.size() >= frames;
  const bool haveOffsets = places.Offsets.size() == frames;
  for (std::size_t i = 0; i < frames; ++i)
  {
    DicomHeader& slice = slices[i];
    slice.Frame = static_cast<int>(i);
    slice.Pixels += header.GetSize() * i;
    if (haveGroups && places.Groups[i].HasPlaces)
    {
      const DicomHeader& own = places.Groups[i];
      std::copy_n(own.Position, 3, slice.Position);
      std::copy_n(own.Row, 3, slice.Row);
      std::copy_n(own.Column, 3, slice.Column);
      std::copy_n(own.Normal, 3, slice.Normal);
      std::copy_n(own.Spacing, 2, slice.Spacing);
      slice.Along = own.Along;
      slice.Slope = own.Slope;
      slice.Intercept = own.Intercept;
      continue;
    }
    if (count == 1)
    {
      continue; // its header has a place, or it is at a scanner's default place
    }
    const double step =
      haveOffsets ? places.Offsets[i] - places.Offsets[0] : places.Step * static_cast<double>(i);
    slice.HasPlaces = haveOffsets || places.Step > 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      slice.Position[axis] += step * slice.Normal[axis];
    }
    slice.Along += step;
  }
  return slices;
}
} // namespace Explore
