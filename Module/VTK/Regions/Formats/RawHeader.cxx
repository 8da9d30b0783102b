// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/Formats/RawHeader.h"

#include "VTK/Base/ByteOrder.h"
#include "VTK/Base/HapticFiles.h"
#include "VTK/Base/NrrdHeader.h"
#include "VTK/Regions/Formats/HeaderText.h"
#include "VTK/Regions/Formats/OpenedFile.h"
#include "VTK/Regions/Formats/RawVolumeFile.h"

#include "vtkAbstractArray.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

namespace VolumeHaptics
{
namespace
{

const std::map<std::string, int> MetaTypes = { { "met_char", VTK_SIGNED_CHAR },
  { "met_uchar", VTK_UNSIGNED_CHAR }, { "met_short", VTK_SHORT },
  { "met_ushort", VTK_UNSIGNED_SHORT }, { "met_int", VTK_INT }, { "met_uint", VTK_UNSIGNED_INT },
  // MetaIO's "long" has 4 bytes on all systems.
  { "met_long", VTK_INT }, { "met_ulong", VTK_UNSIGNED_INT }, { "met_long_long", VTK_LONG_LONG },
  { "met_ulong_long", VTK_UNSIGNED_LONG_LONG }, { "met_float", VTK_FLOAT },
  { "met_double", VTK_DOUBLE } };

/** The fields of a header of either format. */
struct RawHeader
{
  std::vector<double> Size; ///< samples along each axis
  std::vector<double> Spacing;
  std::vector<double> Origin;
  std::vector<double> Axes; ///< nine numbers: the direction of each index axis; empty if not given
  int Type = 0;
  bool IsBig = false;
  bool IsPlain = false; ///< whether it is uncompressed, in one file, and has one component
  std::string Data;     ///< the file with the samples
  double Skip = 0.0;    ///< bytes before the samples; -1: all but the samples
};

std::string LowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

bool IsMetaName(const std::string& name)
{
  const std::string ending = LowerCase(name.substr(std::max<std::size_t>(name.size(), 4) - 4));
  return ending == ".mhd" || ending == ".mha";
}

int FindMetaType(const std::string& name)
{
  const auto found = MetaTypes.find(LowerCase(name));
  return found == MetaTypes.end() ? 0 : found->second;
}

double NumberOr(const std::vector<double>& numbers, double other)
{
  return numbers.empty() ? other : numbers.front();
}

/** Returns the name of a file that a header names. */
std::string FindBeside(const std::string& name, const std::string& data)
{
  return data.empty() || data.front() == '/' ? data : GetFolder(MakeAbsolute(name)) + "/" + data;
}

bool IsTrue(const std::string& word)
{
  return LowerCase(word) == "true";
}

/** Returns the nine numbers of the first three axes, from a matrix of any number of axes. */
std::vector<double> ExtractThreeAxes(const std::vector<double>& matrix, std::size_t axes)
{
  if (axes < 3 || matrix.size() != axes * axes)
  {
    return {};
  }
  std::vector<double> three;
  for (std::size_t row = 0; row < 3; ++row)
  {
    const auto first = matrix.begin() + static_cast<std::ptrdiff_t>(row * axes);
    three.insert(three.end(), first, first + 3);
  }
  return three;
}

RawHeader ReadMetaHeader(const HeaderText& text, const std::string& name)
{
  RawHeader header;
  header.Size = text.Numbers({ "DimSize" });
  header.Spacing = text.Numbers({ "ElementSpacing", "ElementSize" });
  header.Origin = text.Numbers({ "Offset", "Origin", "Position" });
  header.Axes = ExtractThreeAxes(
    text.Numbers({ "TransformMatrix", "Orientation", "Rotation" }), header.Size.size());
  header.Type = FindMetaType(text.Value({ "ElementType" }));
  header.IsBig = IsTrue(text.Value({ "BinaryDataByteOrderMSB", "ElementByteOrderMSB" }));
  const std::string data = text.Value({ "ElementDataFile" });
  header.IsPlain = !data.empty() && data != "LIST" && data.find('%') == std::string::npos &&
    !IsTrue(text.Value({ "CompressedData" })) &&
    LowerCase(text.Value({ "BinaryData" })) != "false" &&
    NumberOr(text.Numbers({ "ElementNumberOfChannels" }), 1.0) == 1.0;
  const bool isHere = LowerCase(data) == "local";
  header.Data = isHere ? name : FindBeside(name, data);
  const double behind = isHere ? static_cast<double>(text.GetSize()) : 0.0;
  const double told = NumberOr(text.Numbers({ "HeaderSize" }), 0.0);
  header.Skip = told == 0.0 ? behind : told;
  return header;
}

RawHeader ConvertNrrdHeader(const NrrdHeader& nrrd, const std::string& name)
{
  RawHeader header;
  header.Size = nrrd.GetNumbers("sizes");
  header.Spacing = nrrd.GetNumbers("spacings");
  const NrrdVector origin = FindNrrdOrigin(nrrd).value_or(NrrdVector{});
  header.Origin.assign(origin.begin(), origin.end());
  if (const auto steps = FindNrrdSteps(nrrd))
  {
    header.Spacing.clear();
    for (const NrrdVector& step : *steps)
    {
      header.Axes.insert(header.Axes.end(), step.begin(), step.end());
      header.Spacing.push_back(std::hypot(step[0], step[1], step[2]));
    }
  }
  const NrrdType type = nrrd.GetType();
  header.Type = ChooseScalarType(type.IsInteger, type.IsSigned, type.Size);
  header.IsBig = nrrd.IsBig();
  const std::string data = nrrd.GetDataFile();
  header.IsPlain = nrrd.GetField("encoding") == "raw" && data.find('%') == std::string::npos &&
    data != "LIST" && !FindNrrdSpace(nrrd).IsLeftHanded && nrrd.GetField("line skip").empty();
  header.Data = data.empty() ? name : FindBeside(name, data);
  header.Skip = NumberOr(nrrd.GetNumbers("byte skip"), 0.0);
  if (data.empty() && header.Skip >= 0.0)
  {
    header.Skip += static_cast<double>(nrrd.Size);
  }
  return header;
}

bool IsReadable(const RawHeader& header)
{
  return header.IsPlain && header.Type != 0 && header.Size.size() >= 3 &&
    std::all_of(header.Size.begin(), header.Size.end(),
      [](double n) { return n >= 1.0 && n <= std::numeric_limits<int>::max(); });
}

/** Computes the number of bytes as a double, which can't overflow. */
double CountBytes(const RawHeader& header)
{
  return header.Size[0] * header.Size[1] * header.Size[2] *
    vtkAbstractArray::GetDataTypeSize(header.Type);
}

/** Checks that axes after the third one, such as time, are one sample long; throws otherwise. */
void CheckFurtherAxes(const RawHeader& header)
{
  if (std::any_of(
        header.Size.begin() + 3, header.Size.end(), [](double count) { return count != 1.0; }))
  {
    throw std::runtime_error("it has " + std::to_string(header.Size.size()) +
      " axes, so that it holds several volumes. Write each of them into a file of its own; "
      "volumehaptics-explore takes their folder.");
  }
}

/** Computes the number of bytes before the samples. Throws if the file is too short. */
std::int64_t ComputeSkip(const RawHeader& header)
{
  double size = 0.0;
  try
  {
    size = static_cast<double>(OpenedFile(header.Data).GetSize());
  }
  catch (const std::runtime_error& error)
  {
    throw std::runtime_error(
      "it speaks of the file " + header.Data + ", which can't be opened: " + error.what());
  }
  const double bytes = CountBytes(header);
  const double skip = header.Skip < 0.0 ? size - bytes : header.Skip;
  if (skip < 0.0 || size < skip + bytes)
  {
    throw std::runtime_error("it speaks of more samples than " + header.Data +
      " has. Check that the copy of that file is complete.");
  }
  return static_cast<std::int64_t>(skip);
}

/** Makes the rows of `axes` the columns of the direction, unless they are no axes. */
void SetAxes(const std::vector<double>& axes, std::array<double, 9>& direction)
{
  if (axes.size() != 9)
  {
    return;
  }
  double unit[9];
  for (int c = 0; c < 3; ++c)
  {
    double axis[3] = { axes[3 * c], axes[3 * c + 1], axes[3 * c + 2] };
    vtkMath::Normalize(axis);
    for (int row = 0; row < 3; ++row)
    {
      unit[3 * row + c] = axis[row];
    }
  }
  constexpr double flattest = 1e-6;
  if (std::abs(vtkMatrix3x3::Determinant(unit)) >= flattest)
  {
    std::copy_n(unit, 9, direction.begin());
  }
}

} // namespace

LargeFile OpenRawHeader(const std::string& name)
{
  const OpenedFile isThere(name); // throws if the file is missing
  const RawHeader header = IsMetaName(name) ? ReadMetaHeader(HeaderText(name), name)
                                            : ConvertNrrdHeader(ReadNrrdHeader(name), name);
  if (!IsReadable(header))
  {
    throw std::runtime_error(
      "its samples can't be read region by region: they are compressed, in several files, "
      "mirrored, not three-dimensional, written as text, or of another type. Write them "
      "uncompressed "
      "into one raw file, or read the whole volume into memory.");
  }
  CheckFurtherAxes(header);
  LargeFile file;
  for (std::size_t a = 0; a < 3; ++a)
  {
    file.Extent[2 * a + 1] = static_cast<int>(header.Size[a]) - 1;
    file.Spacing[a] = a < header.Spacing.size() ? header.Spacing[a] : 1.0;
    file.Origin[a] = a < header.Origin.size() ? header.Origin[a] : 0.0;
  }
  SetAxes(header.Axes, file.Direction);
  file.ScalarType = header.Type;
  const RawVolumeFile samples{ MakeAbsolute(header.Data), file.Extent,
    static_cast<std::size_t>(vtkAbstractArray::GetDataTypeSize(header.Type)), ComputeSkip(header),
    IsOtherByteOrder(header.IsBig) };
  file.Read = [samples](const int box[6], void* to)
  {
    samples.Read(box, to);
    return true;
  };
  return file;
}

} // namespace VolumeHaptics
