// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Reading/Dicom/DicomPixels.h"

#include "VTK/Reading/Dicom/DicomProcess.h"
#include "VTK/Reading/InputError.h"

#include "Core/Platform/HapticFiles.h"
#include "VTK/Base/ArrayMemory.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>

namespace Explore
{
namespace
{
InputError Unreadable(const std::string& path, const DicomHeader& slice, const std::string& fault)
{
  const std::string syntax = NameUnreadSyntax(slice.TransferSyntax);
  if (!syntax.empty())
  {
    return InputError(path,
      "has slices that are compressed as " + syntax + ", which is not supported (" +
        vtksys::SystemTools::GetFilenameName(slice.File) + ")",
      "export the series again without compression");
  }
  return InputError(path,
    "has a slice that cannot be " + fault + " (" +
      vtksys::SystemTools::GetFilenameName(slice.File) + ")",
    "make it readable, or copy or export the series again");
}
/// Converts luminance and colour differences to RGB, the inverse of YBR_FULL in PS3.3, section
/// C.7.6.3.1.2.
void MakeRgb(const DicomHeader& slice, std::string& bytes)
{
  const auto frame = static_cast<std::size_t>(slice.GetSize());
  const std::size_t pixels = frame / 3;
  const std::size_t next = slice.ArePlanes ? pixels : 1;
  const auto clamp = [](double value)
  { return static_cast<char>(std::lround(std::clamp(value, 0.0, 255.0))); };
  for (std::size_t i = 0; i < bytes.size() / 3; ++i)
  {
    char* const at = &bytes[slice.ArePlanes ? i / pixels * frame + i % pixels : 3 * i];
    const double y = static_cast<unsigned char>(at[0]);
    const double b = static_cast<unsigned char>(at[next]) - 128.0;
    const double r = static_cast<unsigned char>(at[2 * next]) - 128.0;
    at[0] = clamp(y + 1.402 * r);
    at[next] = clamp(y - 0.344136 * b - 0.714136 * r);
    at[2 * next] = clamp(y + 1.772 * b);
  }
}

bool IsYbr(const DicomHeader& slice)
{
  return slice.IsYbr && slice.Samples == 3 && slice.Bits == 8;
}

struct ValueRange
{
  double Low = 0.0;
  double High = 0.0;
  bool AreWhole = true;
  int Bits = 0; // bits of floating-point samples; 0: samples are integers
};

/// Returns the range of values that the samples of all slices may have.
ValueRange ComputeValues(const std::vector<DicomHeader>& slices)
{
  ValueRange range;
  for (const DicomHeader& slice : slices)
  {
    range.Bits = std::max(range.Bits, slice.IsFloat ? slice.Bits : 0);
    const double count = std::pow(2.0, slice.Stored);
    for (const double sample :
      { slice.IsSigned ? -0.5 * count : 0.0, (slice.IsSigned ? 0.5 * count : count) - 1.0 })
    {
      const double value = slice.Slope * sample + slice.Intercept;
      range.Low = std::min(range.Low, value);
      range.High = std::max(range.High, value);
    }
    range.AreWhole = range.AreWhole && slice.Slope == std::round(slice.Slope) &&
      slice.Intercept == std::round(slice.Intercept);
  }
  return range;
}

/// Returns the smallest VTK type that can store a range of values.
int ChooseType(const ValueRange& range)
{
  if (range.Bits > 0)
  {
    return range.Bits > 32 ? VTK_DOUBLE : VTK_FLOAT;
  }
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT })
  {
    if (range.AreWhole && range.Low >= vtkDataArray::GetDataTypeMin(type) &&
      range.High <= vtkDataArray::GetDataTypeMax(type))
    {
      return type;
    }
  }
  return VTK_FLOAT;
}

/// Reinterprets 32 or 64 bits as a floating-point number.
double ToReal(std::uint64_t bits, int count)
{
  double real;
  std::memcpy(&real, &bits, sizeof(real));
  if (count == 32)
  {
    float single;
    const auto half = static_cast<std::uint32_t>(bits);
    std::memcpy(&single, &half, sizeof(single));
    real = single;
  }
  return real;
}

/// Returns the bits of the sample at index `at` of a slice.
std::uint64_t ReadBits(const std::string& bytes, std::size_t at, const DicomHeader& slice)
{
  const auto size = static_cast<std::size_t>(slice.Bits / 8);
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < size; ++i)
  {
    const std::size_t byte = at * size + (slice.IsBig ? i : size - 1 - i);
    bits = bits << 8 | static_cast<unsigned char>(bytes[byte]);
  }
  return bits;
}

/// Returns the number of bits below the stored bits, which old files may have (HighBit).
int CountBitsBelow(const DicomHeader& slice)
{
  const bool isKnown = !slice.IsFloat && slice.HighBit < slice.Bits;
  return isKnown ? std::max(0, slice.HighBit + 1 - slice.Stored) : 0;
}

/// Returns the sample at index `at` of a slice, without the bits above the stored bits, which may
/// belong to an overlay.
double Sample(const std::string& bytes, std::size_t at, const DicomHeader& slice, int below)
{
  std::uint64_t bits = ReadBits(bytes, at, slice) >> below;
  if (slice.IsFloat)
  {
    return ToReal(bits, slice.Bits);
  }
  const std::uint64_t count = std::uint64_t{ 1 } << slice.Stored;
  bits &= count - 1;
  const bool isNegative = slice.IsSigned && bits >= count / 2;
  return static_cast<double>(bits) - (isNegative ? static_cast<double>(count) : 0.0);
}

template <typename Value>
void Fill(const std::string& bytes, const DicomHeader& slice, Value* values)
{
  const auto samples = static_cast<std::size_t>(slice.Samples);
  const std::size_t pixels = static_cast<std::size_t>(slice.Width) * slice.Height;
  const int below = CountBitsBelow(slice);
  for (std::size_t i = 0; i < samples * pixels; ++i)
  {
    const std::size_t at = slice.ArePlanes ? i % samples * pixels + i / samples : i;
    values[i] = static_cast<Value>(slice.Slope * Sample(bytes, at, slice, below) + slice.Intercept);
  }
}

/// Returns the value of pixels that were not measured, if the file states it. Its two bytes may or
/// may not be signed, independently of the pixels, and may include the unused low bits.
std::optional<double> ReadPadding(const DicomHeader& slice)
{
  if (!slice.Padding)
  {
    return {};
  }
  const int sign = slice.IsSigned && !slice.IsFloat && *slice.Padding >= 0x8000 ? 0x10000 : 0;
  const double sample = *slice.Padding - sign, count = std::pow(2.0, slice.Stored);
  const bool isStored =
    slice.IsSigned ? std::abs(sample + 0.5) < 0.5 * count : sample >= 0.0 && sample < count;
  const int below = isStored ? 0 : CountBitsBelow(slice);
  return slice.Slope * std::floor(std::ldexp(sample, -below)) + slice.Intercept;
}

/// Sets pixels that were not measured to the smallest value of the measured pixels. Returns their
/// number.
template <typename Value>
vtkIdType ReplacePadding(const std::vector<DicomHeader>& slices, vtkIdType count, Value* values)
{
  Value least = std::numeric_limits<Value>::max();
  vtkIdType replaced = 0;
  for (const bool isSearch : { true, false })
  {
    for (std::size_t k = 0; k < slices.size(); ++k)
    {
      const std::optional<double> padding = ReadPadding(slices[k]);
      Value* const first = values + static_cast<vtkIdType>(k) * count;
      for (vtkIdType i = 0; i < count; ++i)
      {
        const bool isPadding = padding && static_cast<double>(first[i]) == *padding;
        if (isSearch)
        {
          least = isPadding ? least : std::min(least, first[i]);
        }
        else if (isPadding)
        {
          first[i] = least;
          ++replaced;
        }
      }
    }
    if (least == std::numeric_limits<Value>::max())
    {
      return 0; // no pixel was measured
    }
  }
  return replaced;
}

/// Sets pixels outside the scanner's field of view to the smallest measured value. The file marks
/// these pixels only by one value, which is below all values that a CT measures and occurs in more
/// than a thousandth of the voxels. Returns the number of pixels.
template <typename Value>
vtkIdType ReplaceBelowAir(vtkIdType count, Value* values)
{
  constexpr double lowest = -1024.0; // HU
  constexpr vtkIdType fewestPart = 1000;
  Value least = std::numeric_limits<Value>::max();
  const Value outside = *std::min_element(values, values + count);
  vtkIdType replaced = 0;
  bool isOne = static_cast<double>(outside) < lowest;
  for (vtkIdType i = 0; i < count && isOne; ++i)
  {
    replaced += values[i] == outside;
    least = values[i] == outside ? least : std::min(least, values[i]);
  }
  isOne = isOne && replaced > count / fewestPart && static_cast<double>(least) >= lowest;
  if (isOne)
  {
    std::replace(values, values + count, outside, least);
  }
  return isOne ? replaced : 0;
}
} // namespace

void DicomPixels::Unpack(const std::string& path, const DicomHeader& slice)
{
  if (this->File == slice.File)
  {
    return;
  }
  this->File.clear();
  this->Unpacked = slice;
  DicomAnswer answer;
  if (slice.IsDeflated)
  {
    const std::uint64_t size = slice.GetSizeOfAll();
    if (!AskDicom(DicomRequest::Stored, slice.File, size, answer, this->Bytes) ||
      this->Bytes.size() != size)
    {
      throw Unreadable(path, slice, "unpacked");
    }
    this->File = slice.File;
    return;
  }
  constexpr std::uint64_t most = 8; // bytes per sample, because GDCM may widen samples
  const std::uint64_t samples = static_cast<std::uint64_t>(slice.Width) * slice.Height *
    slice.Samples * static_cast<std::uint64_t>(slice.Frames);
  if (!AskDicom(DicomRequest::Unpacked, slice.File, most * samples, answer, this->Bytes))
  {
    throw Unreadable(path, slice, "unpacked");
  }
  this->Unpacked.Bits = static_cast<int>(answer.Bits);
  this->Unpacked.Stored = static_cast<int>(answer.StoredBits);
  this->Unpacked.Samples = static_cast<int>(answer.Samples);
  this->Unpacked.ArePlanes = answer.ArePlanes != 0;
  this->Unpacked.IsBig = false;
  this->Unpacked.IsYbr = answer.IsYbr != 0;
  const int bits = this->Unpacked.Bits;
  if ((bits != 8 && bits != 16 && bits != 32) || this->Unpacked.Samples != slice.Samples ||
    this->Bytes.size() != this->Unpacked.GetSize() * static_cast<std::uint64_t>(slice.Frames))
  {
    throw Unreadable(path, slice, "decompressed to the size in its header");
  }
  if (IsYbr(this->Unpacked))
  {
    MakeRgb(this->Unpacked, this->Bytes);
  }
  this->File = slice.File;
}

std::string DicomPixels::Read(const std::string& path, DicomHeader& slice)
{
  // Expand 1-bit samples to a byte each. Their frames may begin in the middle of a byte.
  const auto pixels = static_cast<std::size_t>(slice.Width) * slice.Height * slice.Samples;
  const std::size_t firstBit = slice.Bits == 1 ? pixels * slice.Frame : 0;
  const auto spread = [&](const std::string& bits, std::size_t first)
  {
    std::string bytes(pixels, '\0');
    for (std::size_t i = 0; i < pixels; ++i)
    {
      bytes[i] = static_cast<char>(bits[(first + i) / 8] >> (first + i) % 8 & 1);
    }
    slice.Bits = slice.Stored = 8;
    return bytes;
  };
  if (slice.IsDeflated)
  {
    this->Unpack(path, slice);
    std::string bytes = slice.Bits == 1
      ? spread(this->Bytes, firstBit)
      : this->Bytes.substr(
          slice.GetSize() * static_cast<std::size_t>(slice.Frame), slice.GetSize());
    if (IsYbr(slice))
    {
      MakeRgb(slice, bytes);
    }
    return bytes;
  }
  if (!slice.IsPlain())
  {
    this->Unpack(path, slice);
    slice.Bits = this->Unpacked.Bits;
    slice.Stored = this->Unpacked.Stored;
    slice.HighBit = -1;
    slice.ArePlanes = this->Unpacked.ArePlanes;
    slice.IsBig = false;
    const std::size_t size = slice.GetSize();
    return this->Bytes.substr(size * static_cast<std::size_t>(slice.Frame), size);
  }
  std::string bytes(slice.Bits == 1 ? (firstBit % 8 + pixels + 7) / 8 : slice.GetSize(), '\0');
  std::ifstream file = VolumeHaptics::OpenStream(slice.File);
  file.seekg(static_cast<std::streamoff>(slice.Pixels + firstBit / 8));
  if (!file.read(&bytes[0], static_cast<std::streamsize>(bytes.size())))
  {
    throw Unreadable(path, slice, "read");
  }
  if (slice.Bits == 1)
  {
    return spread(bytes, firstBit % 8);
  }
  if (IsYbr(slice))
  {
    MakeRgb(slice, bytes);
  }
  return bytes;
}

double MeasureSlices(const std::vector<DicomHeader>& slices)
{
  const DicomHeader& first = slices.front();
  return static_cast<double>(first.Width) * first.Height * first.Samples *
    vtkDataArray::GetDataTypeSize(ChooseType(ComputeValues(slices)));
}

void CorrectHighBit(const std::string& path, std::vector<std::vector<DicomHeader>>& phases,
  std::vector<std::string>& notes)
{
  bool areUsed = false, areAllLow = true;
  const auto check = [&](DicomPixels& pixels, DicomHeader slice)
  {
    const bool isAsked = CountBitsBelow(slice) > 0;
    const std::string bytes = isAsked ? pixels.Read(path, slice) : std::string();
    const int unused = slice.Bits - slice.Stored, below = CountBitsBelow(slice);
    for (std::size_t i = 0; below > 0 && i < bytes.size() / (slice.Bits / 8); ++i)
    {
      const std::uint64_t bits = ReadBits(bytes, i, slice), above = bits >> slice.Stored;
      const bool isNegative = slice.IsSigned && (bits >> (slice.Stored - 1) & 1) != 0;
      areUsed = areUsed || (bits & ((std::uint64_t{ 1 } << below) - 1)) != 0;
      areAllLow =
        areAllLow && (above == 0 || (isNegative && above == (std::uint64_t{ 1 } << unused) - 1));
    }
  };
  DicomPixels pixels;
  for (const std::vector<DicomHeader>& slices : phases)
  {
    std::for_each(
      slices.begin(), slices.end(), [&](const DicomHeader& slice) { check(pixels, slice); });
  }
  for (std::vector<DicomHeader>& slices : phases)
  {
    for (DicomHeader& slice : slices)
    {
      slice.HighBit =
        areUsed && areAllLow ? std::min(slice.HighBit, slice.Stored - 1) : slice.HighBit;
    }
  }
  if (areUsed)
  {
    notes.emplace_back(areAllLow
        ? "the samples are in the low bits, not where HighBit says: they are taken from there"
        : "the bits below the samples, which may be an overlay, are left out");
  }
}

vtkSmartPointer<vtkImageData> ReadSlices(
  const std::string& path, const std::vector<DicomHeader>& slices, std::vector<std::string>& notes)
{
  const DicomHeader& first = slices.front();
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(first.Width, first.Height, static_cast<int>(slices.size()));
  VolumeHaptics::AllocateScalars(image, ChooseType(ComputeValues(slices)), first.Samples);
  image->GetPointData()->GetScalars()->SetName("DICOM");
  DicomPixels pixels;
  for (std::size_t k = 0; k < slices.size(); ++k)
  {
    DicomHeader slice = slices[k];
    const std::string bytes = pixels.Read(path, slice);
    void* const values = image->GetScalarPointer(0, 0, static_cast<int>(k));
    switch (image->GetScalarType())
    {
      vtkTemplateMacro(Fill(bytes, slice, static_cast<VTK_TT*>(values)));
    }
  }
  const bool isPadded = first.Samples == 1 &&
    std::any_of(slices.begin(), slices.end(),
      [](const DicomHeader& slice) { return slice.Padding.has_value(); });
  vtkIdType replaced = 0;
  void* const values = image->GetScalarPointer();
  switch (isPadded ? image->GetScalarType() : VTK_VOID)
  {
    vtkTemplateMacro(replaced = ReplacePadding(slices, vtkIdType{ first.Width } * first.Height,
                       static_cast<VTK_TT*>(values)));
    default:
      break;
  }
  vtkIdType below = 0;
  switch (first.Modality == "CT" && first.Samples == 1 ? image->GetScalarType() : VTK_VOID)
  {
    vtkTemplateMacro(
      below = ReplaceBelowAir(image->GetNumberOfPoints(), static_cast<VTK_TT*>(values)));
    default:
      break;
  }
  if (below > 0)
  {
    notes.push_back(std::to_string(below) +
      " pixels have one value below -1024: they are outside the field of view, and get the "
      "smallest value");
  }
  if (replaced > 0)
  {
    notes.push_back(std::to_string(replaced) +
      " pixels were not measured, according to the files: they are outside, with the smallest "
      "value");
  }
  return image;
}
} // namespace Explore
