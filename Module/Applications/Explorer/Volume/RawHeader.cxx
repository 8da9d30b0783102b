// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Volume/RawHeader.h"

#include "Applications/Explorer/Errors/InputError.h"
#include "Applications/Explorer/Volume/HeaderText.h"
#include "Applications/Explorer/Volume/VolumeOrientation.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace
{
using Explore::HeaderText;
using Explore::InputError;
using Files = vtksys::SystemTools;

const std::map<std::string, int> TYPES = { { "met_char", VTK_SIGNED_CHAR },
  { "met_uchar", VTK_UNSIGNED_CHAR }, { "met_short", VTK_SHORT },
  { "met_ushort", VTK_UNSIGNED_SHORT }, { "met_int", VTK_INT }, { "met_uint", VTK_UNSIGNED_INT },
  { "met_long_long", VTK_LONG_LONG }, { "met_ulong_long", VTK_UNSIGNED_LONG_LONG },
  { "met_float", VTK_FLOAT }, { "met_double", VTK_DOUBLE }, { "signed char", VTK_SIGNED_CHAR },
  { "int8", VTK_SIGNED_CHAR }, { "int8_t", VTK_SIGNED_CHAR }, { "uchar", VTK_UNSIGNED_CHAR },
  { "unsigned char", VTK_UNSIGNED_CHAR }, { "uint8", VTK_UNSIGNED_CHAR },
  { "uint8_t", VTK_UNSIGNED_CHAR }, { "short", VTK_SHORT }, { "int16", VTK_SHORT },
  { "int16_t", VTK_SHORT }, { "ushort", VTK_UNSIGNED_SHORT },
  { "unsigned short", VTK_UNSIGNED_SHORT }, { "uint16", VTK_UNSIGNED_SHORT },
  { "uint16_t", VTK_UNSIGNED_SHORT }, { "int", VTK_INT }, { "int32", VTK_INT },
  { "int32_t", VTK_INT }, { "uint", VTK_UNSIGNED_INT }, { "unsigned int", VTK_UNSIGNED_INT },
  { "uint32", VTK_UNSIGNED_INT }, { "uint32_t", VTK_UNSIGNED_INT }, { "int64", VTK_LONG_LONG },
  { "int64_t", VTK_LONG_LONG }, { "uint64", VTK_UNSIGNED_LONG_LONG },
  { "uint64_t", VTK_UNSIGNED_LONG_LONG }, { "float", VTK_FLOAT }, { "double", VTK_DOUBLE } };

/// What a header says about raw samples.
struct RawHeader
{
  std::vector<double> Size; // of the volume, voxels
  std::vector<double> Spacing;
  std::vector<double> Origin;
  int Type = 0;
  bool IsBig = false;
  bool IsPlain = false; // neither compressed nor in several files, and of one component
  std::string Data;     // the file
  double Skip = -1.0;   // bytes before the samples; -1: all but the samples
};

bool IsMeta(const std::string& path)
{
  const std::string ending = Files::LowerCase(Files::GetFilenameLastExtension(path));
  return ending == ".mhd" || ending == ".mha";
}

int TypeOf(const std::string& name)
{
  const auto found = TYPES.find(Files::LowerCase(name));
  return found == TYPES.end() ? 0 : found->second;
}

double NumberOr(const std::vector<double>& numbers, double other)
{
  return numbers.empty() ? other : numbers.front();
}

std::string Beside(const std::string& path, const std::string& data)
{
  return Files::CollapseFullPath(data, Files::GetFilenamePath(Files::CollapseFullPath(path)));
}

bool IsTrue(const std::string& word)
{
  return Files::LowerCase(word) == "true";
}

RawHeader ReadMetaHeader(const std::string& path)
{
  const HeaderText text(path, '=');
  RawHeader header;
  header.Size = text.Numbers({ "DimSize" });
  header.Spacing = text.Numbers({ "ElementSpacing", "ElementSize" });
  header.Origin = text.Numbers({ "Offset", "Origin", "Position" });
  header.Type = TypeOf(text.Value({ "ElementType" }));
  header.IsBig = IsTrue(text.Value({ "BinaryDataByteOrderMSB", "ElementByteOrderMSB" }));
  const std::string data = text.Value({ "ElementDataFile" });
  header.IsPlain = !data.empty() && data != "LIST" && data.find('%') == std::string::npos &&
    !IsTrue(text.Value({ "CompressedData" })) &&
    NumberOr(text.Numbers({ "ElementNumberOfChannels" }), 1.0) == 1.0;
  header.Data = Files::LowerCase(data) == "local" ? path : Beside(path, data);
  header.Skip = header.Data == path ? -1.0 : NumberOr(text.Numbers({ "HeaderSize" }), 0.0);
  return header;
}

RawHeader ReadNrrdHeader(const std::string& path)
{
  const HeaderText text(path, ':');
  RawHeader header;
  header.Size = text.Numbers({ "sizes" });
  header.Spacing = text.Numbers({ "spacings" });
  const std::vector<double> directions = text.Numbers({ "space directions" });
  const bool hasDirections = header.Spacing.empty() && directions.size() == 9;
  for (std::size_t c = 0; hasDirections && c < 3; ++c)
  {
    header.Spacing.push_back(
      std::hypot(directions[3 * c], directions[3 * c + 1], directions[3 * c + 2]));
  }
  header.Origin = text.Numbers({ "space origin" });
  header.Type = TypeOf(text.Value({ "type" }));
  header.IsBig = text.Value({ "endian" }) == "big";
  const std::string data = text.Value({ "data file", "datafile" });
  const std::string space = text.Value({ "space" });
  const bool isMirrored =
    space == "left-anterior-superior" || space == "LAS" || space == "3D-left-handed";
  header.IsPlain = text.Value({ "encoding" }) == "raw" && data.find('%') == std::string::npos &&
    data != "LIST" && !isMirrored && text.Value({ "line skip", "lineskip" }).empty();
  header.Data = data.empty() ? path : Beside(path, data);
  header.Skip = data.empty() ? -1.0 : NumberOr(text.Numbers({ "byte skip", "byteskip" }), 0.0);
  return header;
}

RawHeader ReadRawHeader(const std::string& path)
{
  RawHeader header = IsMeta(path) ? ReadMetaHeader(path) : ReadNrrdHeader(path);
  header.Spacing.resize(header.Size.size(), 1.0);
  header.Origin.resize(header.Size.size(), 0.0);
  return header;
}

double SampleBytes(const RawHeader& header)
{
  const bool isVolume = header.Size.size() == 3 &&
    std::all_of(header.Size.begin(), header.Size.end(),
      [](double n) { return n >= 1.0 && n <= std::numeric_limits<int>::max(); });
  return isVolume && header.IsPlain && header.Type != 0
    ? header.Size[0] * header.Size[1] * header.Size[2] * vtkDataArray::GetDataTypeSize(header.Type)
    : 0.0;
}
} // namespace

namespace Explore
{
bool HasRawHeader(const std::string& path)
{
  const std::string ending = Files::LowerCase(Files::GetFilenameLastExtension(path));
  return ending == ".mhd" || ending == ".mha" || ending == ".nrrd" || ending == ".nhdr";
}

double FindRawSize(const std::string& path)
{
  return SampleBytes(ReadRawHeader(path));
}

std::vector<std::string> OpenRawHeader(const std::string& path, vtkHapticRegionSource* source)
{
  const RawHeader header = ReadRawHeader(path);
  const double bytes = SampleBytes(header);
  if (bytes <= 0.0)
  {
    throw InputError(path,
      "has samples that can't be read region by region: they are compressed, in several files, "
      "mirrored, not three-dimensional, or of another type",
      "write them uncompressed into one raw file, or leave --large out");
  }
  const auto size = static_cast<double>(Files::FileLength(header.Data));
  const double skip = header.Skip < 0.0 ? size - bytes : header.Skip;
  if (!Files::FileExists(header.Data, true) || skip < 0.0 || size < skip + bytes)
  {
    throw InputError(path,
      Files::FileExists(header.Data, true)
        ? "speaks of more samples than " + header.Data + " has"
        : "speaks of the file " + header.Data + ", which is not there",
      "copy the file of samples beside the header, and check that it is complete");
  }
  // Its place, as that of an image of one voxel would be.
  vtkNew<vtkImageData> place;
  place->SetOrigin(header.Origin.data());
  place->SetSpacing(header.Spacing.data());
  std::vector<std::string> notes;
  if (IsMeta(path))
  {
    ApplyMetaImageOrientation(path, place);
  }
  else
  {
    const std::string note = ApplyNrrdOrientation(path, place);
    notes.insert(notes.end(), note.empty() ? 0 : 1, note);
  }
  source->SetFileName(header.Data.c_str());
  source->SetHeaderSize(static_cast<vtkTypeInt64>(skip));
  source->SetWholeExtent(0, static_cast<int>(header.Size[0]) - 1, 0,
    static_cast<int>(header.Size[1]) - 1, 0, static_cast<int>(header.Size[2]) - 1);
  source->SetScalarType(header.Type);
  source->SetByteOrder(header.IsBig ? vtkHapticRegionSource::BIG : vtkHapticRegionSource::LITTLE);
  source->SetOrigin(place->GetOrigin());
  source->SetSpacing(place->GetSpacing());
  source->SetDirection(place->GetDirectionMatrix()->GetData());
  return notes;
}
} // namespace Explore
