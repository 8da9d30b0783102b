// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Volume/DicomPixels.h"

#include "Applications/Explorer/Errors/InputError.h"
#include "Applications/Explorer/Volume/DicomUnpacking.h"

#include <vtksys/FStream.hxx>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>

namespace Explore
{
namespace
{
InputError Unreadable(const std::string& path, const DicomHeader& slice, const std::string& fault)
{
  return InputError(path,
    "has a slice that cannot be " + fault + " (" +
      vtksys::SystemTools::GetFilenameName(slice.File) + ")",
    "make it readable, or copy or export the series again");
}
/// From luminance and differences to RGB: the inverse of PS3.3, section C.7.6.3.1.2, YBR_FULL.
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
} // namespace

void DicomPixels::Unpack(const std::string& path, const DicomHeader& slice)
{
  if (this->File == slice.File)
  {
    return;
  }
  this->File.clear();
  this->Unpacked = slice;
  if (!UnpackDicom(this->Unpacked, this->Bytes))
  {
    throw Unreadable(path, slice, "unpacked");
  }
  const int bits = this->Unpacked.Bits;
  if ((bits != 8 && bits != 16 && bits != 32) || this->Unpacked.Samples != slice.Samples ||
    this->Bytes.size() != this->Unpacked.GetSize() * static_cast<std::uint64_t>(slice.Frames))
  {
    throw Unreadable(path, slice, "unpacked to the size that its header tells");
  }
  if (IsYbr(this->Unpacked))
  {
    MakeRgb(this->Unpacked, this->Bytes);
  }
  this->File = slice.File;
}

std::string DicomPixels::Read(const std::string& path, DicomHeader& slice)
{
  if (!slice.IsPlain())
  {
    this->Unpack(path, slice);
    slice.Bits = this->Unpacked.Bits;
    slice.Stored = this->Unpacked.Stored;
    slice.ArePlanes = this->Unpacked.ArePlanes;
    slice.IsBig = false;
    const std::size_t size = slice.GetSize();
    return this->Bytes.substr(size * static_cast<std::size_t>(slice.Frame), size);
  }
  std::string bytes(slice.GetSize(), '\0');
  vtksys::ifstream file(slice.File.c_str(), std::ios::binary);
  file.seekg(static_cast<std::streamoff>(slice.Pixels));
  if (!file.read(&bytes[0], static_cast<std::streamsize>(bytes.size())))
  {
    throw Unreadable(path, slice, "read");
  }
  if (IsYbr(slice))
  {
    MakeRgb(slice, bytes);
  }
  return bytes;
}
} // namespace Explore
