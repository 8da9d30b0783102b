// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/Formats/LargeFile.h"

#include "Core/Platform/HapticFiles.h"
#include "VTK/Base/ByteOrder.h"
#include "VTK/Base/NrrdHeader.h"
#include "VTK/Regions/Formats/FurtherAxes.h"
#include "VTK/Regions/Formats/HeaderText.h"
#include "VTK/Regions/Formats/OpenedFile.h"
#include "VTK/Regions/Formats/RawVolumeFile.h"
#include "VTK/Regions/Formats/WholeSamples.h"

#include "vtkAbstractArray.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"

#include "vtksys/RegularExpression.hxx"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <limits>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace VolumeHaptics
{
namespace
{

const std::map<std::string, int> MetaTypes = { { "met_char", VTK_SIGNED_CHAR },
  { "met_uchar", VTK_UNSIGNED_CHAR }, { "met_short", VTK_SHORT },
  { "met_ushort", VTK_UNSIGNED_SHORT }, { "met_int", VTK_INT }, { "met_uint", VTK_UNSIGNED_INT },
  // In MetaIO, "long" has 4 bytes on all systems.
  { "met_long", VTK_INT }, { "met_ulong", VTK_UNSIGNED_INT }, { "met_long_long", VTK_LONG_LONG },
  { "met_ulong_long", VTK_UNSIGNED_LONG_LONG }, { "met_float", VTK_FLOAT },
  { "met_double", VTK_DOUBLE } };

/** Contents of a MetaImage or NRRD header. */
struct RawHeader
{
  std::vector<double> Size;            ///< number of samples along x, y and z
  std::array<std::int64_t, 3> Steps{}; ///< see RawVolumeFile
  std::vector<FurtherAxis> Further;    ///< axes in addition to x, y and z
  std::vector<double> FurtherSteps;    ///< distance (samples) from one volume to the next along
                                       ///< each of them
  std::vector<double> Spacing;
  std::vector<double> Origin;
  std::vector<double> Axes; ///< nine numbers: the direction of each index axis; empty if not given
  int Type = 0;
  bool IsBig = false;
  bool IsKnown = false; ///< whether the sample type is supported
  bool IsPlain = false; ///< whether the samples are uncompressed, in one file and of one component
  WholeSamples::EncodingType Encoding = WholeSamples::Raw;
  std::string UnknownEncoding;   ///< name of an unsupported encoding; empty otherwise
  std::vector<std::string> Data; ///< files with the samples
  double Skip = 0.0;             ///< bytes before the samples; -1: the samples are at the end of
                                 ///< the file
  std::vector<std::string> Notes;
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

/** Returns the path of a file that a header names relative to itself. */
std::string FindBeside(const std::string& name, const std::string& data)
{
  return data.empty() || data.front() == '/' ? data : GetFolder(MakeAbsolute(name)) + "/" + data;
}

/** Extracts the first three axes from a square matrix with any number of axes. */
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

/** Returns the size (bytes) of the first `lines` lines of a file. */
double CountLineBytes(const std::string& name, double lines)
{
  std::ifstream file = OpenStream(name);
  std::string line;
  double size = 0.0;
  for (; lines >= 1.0 && std::getline(file, line); --lines)
  {
    size += static_cast<double>(line.size()) + 1.0;
  }
  return size;
}

/** Expands a pattern such as "slice%03d.raw 1 40 1" to file names. */
std::vector<std::string> ListNumbered(const std::string& text)
{
  std::istringstream words(text);
  std::string pattern;
  int first = 0;
  int last = -1;
  int step = 1;
  words >> pattern >> first >> last >> step;
  const vtksys::RegularExpression number("^([^%]*)%(0?)([0-9]*)d([^%]*)$");
  vtksys::RegularExpressionMatch parts;
  constexpr int most = 1 << 20;
  if (!number.find(pattern.c_str(), parts) || step <= 0 || last < first ||
    (last - first) / step > most)
  {
    return {};
  }
  std::vector<std::string> names;
  for (int i = first; i <= last; i += step)
  {
    std::ostringstream name;
    name << parts.match(1) << std::setfill(parts.match(2).empty() ? ' ' : '0')
         << std::setw(std::atoi(parts.match(3).substr(0, 2).c_str())) << i << parts.match(4);
    names.push_back(name.str());
  }
  return names;
}

/** Adds an axis in addition to x, y and z. */
void AddFurther(const char* name, double count, double step, RawHeader& header)
{
  const bool isCount = count >= 1.0 && count <= std::numeric_limits<int>::max();
  header.Further.push_back({ name, isCount ? static_cast<std::size_t>(count) : 0 });
  header.FurtherSteps.push_back(step);
}

RawHeader ReadMetaHeader(const HeaderText& text, const std::string& name)
{
  RawHeader header;
  header.Size = text.Numbers({ "DimSize" });
  header.Spacing = text.Numbers({ "ElementSpacing", "ElementSize" });
  header.Origin = text.Numbers({ "Offset", "Origin", "Position" });
  header.Axes = ExtractThreeAxes(
    text.Numbers({ "TransformMatrix", "Orientation", "Rotation" }), header.Size.size());
  double step = 1.0;
  for (std::size_t axis = 0; axis < header.Size.size(); ++axis)
  {
    if (axis > 2)
    {
      AddFurther("volume", header.Size[axis], step, header);
    }
    step *= header.Size[axis];
  }
  header.Size.resize(std::min<std::size_t>(header.Size.size(), 3));
  const double unit = text.GetMetaUnit();
  for (std::vector<double>* const lengths : { &header.Spacing, &header.Origin })
  {
    std::for_each(lengths->begin(), lengths->end(), [unit](double& length) { length *= unit; });
  }
  header.Notes = text.DescribeMeta();
  header.Type = FindMetaType(text.Value({ "ElementType" }));
  header.IsBig = text.IsTrue({ "BinaryDataByteOrderMSB", "ElementByteOrderMSB" });
  const std::string data = text.Value({ "ElementDataFile" });
  header.IsKnown = !data.empty() && data != "LIST" && data.find('%') == std::string::npos &&
    text.IsTrue({ "BinaryData" }, true) &&
    NumberOr(text.Numbers({ "ElementNumberOfChannels" }), 1.0) == 1.0;
  const bool isPacked = text.IsTrue({ "CompressedData" });
  header.IsPlain = header.IsKnown && !isPacked;
  header.Encoding = isPacked ? WholeSamples::Packed : WholeSamples::Raw;
  const bool isHere = LowerCase(data) == "local";
  header.Data = { isHere ? name : FindBeside(name, data) };
  const double behind = isHere ? static_cast<double>(text.GetSize()) : 0.0;
  const double told = NumberOr(text.Numbers({ "HeaderSize" }), 0.0);
  header.Skip = told == 0.0 ? behind : told;
  return header;
}

/** Sets the sizes of a NRRD file's volume, and the steps between its samples. */
void SetNrrdSizes(const NrrdHeader& nrrd, RawHeader& header)
{
  const std::vector<double> sizes = nrrd.GetNumbers("sizes");
  const auto axes = ReadNrrdAxes(nrrd);
  if (!axes || axes->back() >= sizes.size())
  {
    return;
  }
  double step = 1.0;
  for (std::size_t axis = 0; axis < sizes.size(); ++axis)
  {
    const auto* const found = std::find(axes->begin(), axes->end(), axis);
    if (found != axes->end())
    {
      header.Size.push_back(sizes[axis]);
      // Limit the step only to avoid an overflow, since the sizes are checked later.
      header.Steps[static_cast<std::size_t>(found - axes->begin())] =
        static_cast<std::int64_t>(std::min(step, 1e18));
    }
    else
    {
      AddFurther(axis < axes->back() ? "component" : "volume", sizes[axis], step, header);
    }
    step *= sizes[axis];
  }
}

/** Sets the files with the samples of a NRRD file, and their encoding. */
void SetNrrdSamples(const NrrdHeader& nrrd, const std::string& name, RawHeader& header)
{
  const std::string data = nrrd.GetDataFile();
  const bool isListed = data.compare(0, 4, "LIST") == 0;
  const bool isNumbered = data.find('%') != std::string::npos;
  const std::vector<std::string> names = isListed ? nrrd.Files
    : isNumbered                                  ? ListNumbered(data)
                                                  : std::vector<std::string>{ data };
  for (const std::string& one : names)
  {
    header.Data.push_back(one.empty() ? name : FindBeside(name, one));
  }
  const std::string encoding = LowerCase(nrrd.GetField("encoding"));
  const bool isText = encoding == "ascii" || encoding == "text" || encoding == "txt";
  const bool isPacked = encoding == "gzip" || encoding == "gz";
  header.Encoding = isText ? WholeSamples::Text
    : isPacked             ? WholeSamples::Packed
                           : WholeSamples::Raw;
  const bool isRaw = encoding == "raw";
  header.UnknownEncoding = isText || isPacked || isRaw ? std::string() : " (" + encoding + ")";
  const double lines = NumberOr(nrrd.GetNumbers("line skip"), 0.0);
  const double bytes = NumberOr(nrrd.GetNumbers("byte skip"), 0.0);
  header.IsKnown = !header.Data.empty() && header.UnknownEncoding.empty() &&
    (bytes == 0.0 || isRaw) && (lines == 0.0 || !data.empty());
  header.IsPlain = header.IsKnown && isRaw && !isListed && !isNumbered && lines == 0.0 &&
    !FindNrrdSpace(nrrd).IsLeftHanded;
  header.Skip = bytes < 0.0 ? bytes
    : data.empty()          ? bytes + static_cast<double>(nrrd.Size)
    : header.IsKnown        ? bytes + CountLineBytes(header.Data.front(), lines)
                            : 0.0;
}

RawHeader ConvertNrrdHeader(const NrrdHeader& nrrd, const std::string& name)
{
  RawHeader header;
  SetNrrdSizes(nrrd, header);
  const NrrdVector origin = FindNrrdOrigin(nrrd).value_or(NrrdVector{});
  header.Origin.assign(origin.begin(), origin.end());
  if (const auto steps = FindNrrdSteps(nrrd))
  {
    for (const NrrdVector& step : *steps)
    {
      header.Axes.insert(header.Axes.end(), step.begin(), step.end());
      header.Spacing.push_back(std::hypot(step[0], step[1], step[2]));
    }
  }
  else
  {
    const NrrdVector spacings = FindNrrdSpacings(nrrd);
    header.Spacing.assign(spacings.begin(), spacings.end());
  }
  for (const std::string& note : { DescribeNrrdUnits(nrrd), DescribeNrrdGuess(nrrd) })
  {
    header.Notes.insert(header.Notes.end(), note.empty() ? 0 : 1, note);
  }
  const NrrdType type = nrrd.GetType();
  header.Type = ChooseScalarType(type.IsInteger, type.IsSigned, type.Size);
  header.IsBig = nrrd.IsBig();
  SetNrrdSamples(nrrd, name, header);
  return header;
}

bool IsReadable(const RawHeader& header)
{
  return header.IsKnown && header.Type != 0 && header.Size.size() == 3 &&
    std::all_of(header.Size.begin(), header.Size.end(),
      [](double n) { return n >= 1.0 && n <= std::numeric_limits<int>::max(); });
}

/** Returns the number of samples in all files, as a double to avoid an overflow. */
double CountFileSamples(const RawHeader& header)
{
  double count = header.Size[0] * header.Size[1] * header.Size[2];
  for (const FurtherAxis& axis : header.Further)
  {
    count *= static_cast<double>(axis.Count);
  }
  return count;
}

/** Returns the number of bytes before the samples. Throws if the file is too short. */
std::int64_t ComputeSkip(const RawHeader& header)
{
  const std::string& data = header.Data.front();
  double size = 0.0;
  try
  {
    size = static_cast<double>(OpenedFile(data).GetSize());
  }
  catch (const std::runtime_error& error)
  {
    throw std::runtime_error(
      "it speaks of the file " + data + ", which can't be opened: " + error.what());
  }
  const double bytes = CountFileSamples(header) * vtkAbstractArray::GetDataTypeSize(header.Type);
  const double skip = header.Skip < 0.0 ? size - bytes : header.Skip;
  if (skip < 0.0 || size < skip + bytes)
  {
    throw std::runtime_error(DescribeMissingSamples(data));
  }
  return static_cast<std::int64_t>(skip);
}

/** Sets the columns of the direction matrix to the rows of `axes`, if these are valid axes. */
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

/** Returns a function that reads boxes of samples in one file. */
BoxReader ReadInBoxes(const RawHeader& header, RawVolumeFile samples)
{
  samples.Name = MakeAbsolute(header.Data.front());
  samples.HeaderSize = ComputeSkip(header);
  return [samples](const int box[6], void* to)
  {
    samples.Read(box, to);
    return true;
  };
}

/** Returns a function that reads all samples into memory when it is called first. */
BoxReader ReadAtOnce(const RawHeader& header, RawVolumeFile samples)
{
  const auto whole = std::make_shared<WholeSamples>();
  std::size_t contiguous = 1;
  for (std::size_t a = 0; a < 3; ++a)
  {
    whole->Size[a] = static_cast<std::size_t>(header.Size[a]);
    whole->Steps[a] =
      samples.Steps[a] > 0 ? static_cast<std::size_t>(samples.Steps[a]) : contiguous;
    contiguous *= whole->Size[a];
  }
  whole->First = static_cast<std::size_t>(samples.First);
  samples.Steps = {}; // in memory, the samples of the volume are contiguous
  samples.First = 0;
  for (const std::string& name : header.Data)
  {
    whole->Files.push_back(MakeAbsolute(name));
  }
  whole->Encoding = header.Encoding;
  whole->Offset = static_cast<std::size_t>(static_cast<std::int64_t>(header.Skip));
  whole->ScalarType = header.Type;
  whole->Count = CountFileSamples(header);
  whole->Check();
  return [whole, samples](const int box[6], void* to)
  {
    samples.ReadWith([&whole](void* part, std::size_t size, std::int64_t from)
      { whole->Copy(part, size, static_cast<std::size_t>(from)); },
      box, to);
    return true;
  };
}

} // namespace

LargeFile OpenRawHeader(const std::string& name, bool mayBeWhole, int volume)
{
  const OpenedFile isThere(name); // opened only to throw if the file is missing
  const RawHeader header = IsMetaName(name) ? ReadMetaHeader(HeaderText(name), name)
                                            : ConvertNrrdHeader(ReadNrrdHeader(name), name);
  if (!IsReadable(header) || (!header.IsPlain && !mayBeWhole))
  {
    throw std::runtime_error(mayBeWhole
        ? "its samples can't be read: they are encoded in another way" +
          Printable(header.UnknownEncoding) +
          " than raw, gzip or ascii, not three-dimensional, or of another type. Write them again, "
          "with the encoding gzip; with teem: unu save -f nrrd -e gzip."
        : "its samples can't be read region by region: they are compressed, in several files, "
          "mirrored, not three-dimensional, written as text, or of another type. Write them "
          "uncompressed "
          "into one raw file, or read the whole volume into memory.");
  }
  for (const std::string& samples : header.Data)
  {
    // Check for holes only if all samples are read into memory.
    const std::string holes = mayBeWhole ? DetectHoles(samples) : std::string();
    if (!holes.empty())
    {
      throw std::runtime_error(
        samples + " " + holes + ". Check that the copy of that file is complete.");
    }
  }
  LargeFile file;
  for (std::size_t a = 0; a < 3; ++a)
  {
    file.Extent[2 * a + 1] = static_cast<int>(header.Size[a]) - 1;
    file.Spacing[a] = a < header.Spacing.size() ? header.Spacing[a] : 1.0;
    file.Origin[a] = a < header.Origin.size() ? header.Origin[a] : 0.0;
  }
  SetAxes(header.Axes, file.Direction);
  file.ScalarType = header.Type;
  file.Notes = header.Notes;
  RawVolumeFile samples;
  samples.Extent = file.Extent;
  samples.SampleSize = static_cast<std::size_t>(vtkAbstractArray::GetDataTypeSize(header.Type));
  samples.Steps = header.Steps;
  const std::vector<std::size_t> indices = ChooseVolume(header.Further, volume, file);
  double first = 0.0;
  for (std::size_t axis = 0; axis < indices.size(); ++axis)
  {
    first += static_cast<double>(indices[axis]) * header.FurtherSteps[axis];
  }
  // Limit the number to avoid an overflow, since the sizes are checked later.
  samples.First = static_cast<std::int64_t>(std::min(first, 1e18));
  samples.IsSwapped = header.Encoding != WholeSamples::Text && IsOtherByteOrder(header.IsBig);
  file.Read = header.IsPlain ? ReadInBoxes(header, std::move(samples))
                             : ReadAtOnce(header, std::move(samples));
  return file;
}

} // namespace VolumeHaptics
