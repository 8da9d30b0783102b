// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Volume/DicomPixels.h"

#include "Applications/Explorer/Errors/InputError.h"
#include "Applications/Explorer/Volume/DicomUnpacking.h"

#include <vtksys/FStream.hxx>
#include <vtksys/SystemTools.hxx>

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
  return bytes;
}
} // namespace Explore
