// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/Formats/Hdf5Storage.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

/**
 * Limit on the bytes of all blocks of a file: a damaged tree may lead to the same blocks for ever.
 */
constexpr std::uint64_t MostBytesInAll = std::uint64_t{ 1 } << 30;

} // namespace

Hdf5Storage::Hdf5Storage(const std::string& name)
  : File(name)
  , FileSize(static_cast<std::uint64_t>(this->File.GetSize()))
{
  // Other data may precede the superblock, which begins at 0, 512, 1024, 2048 and so on.
  for (std::uint64_t at = 0; at < this->FileSize; at = at == 0 ? 512 : 2 * at)
  {
    if (this->ReadSuperblock(at))
    {
      return;
    }
  }
  throw std::runtime_error("it is no HDF5 file. Check what it really is.");
}

bool Hdf5Storage::ReadSuperblock(std::uint64_t at)
{
  this->Base = 0;
  Hdf5Block block = this->ReadBlock(at, std::min<std::uint64_t>(128, this->FileSize - at));
  if (block.GetLeft() < 32 || !block.Begins("\x89HDF\r\n\x1a\n"))
  {
    return false;
  }
  const int version = block.Byte();
  if (version > 3)
  {
    throw std::runtime_error("its HDF5 format is newer than what is read here. Convert it with "
                             "h5repack --high=2 IN OUT.");
  }
  const bool isOld = version < 2;
  block.Skip(isOld ? 4 : 0);
  this->OffsetSize = static_cast<std::size_t>(block.Byte());
  this->LengthSize = static_cast<std::size_t>(block.Byte());
  if (this->OffsetSize < 2 || this->OffsetSize > 8 || this->LengthSize < 2 || this->LengthSize > 8)
  {
    Hdf5Block::ThrowDamaged();
  }
  block.Skip(isOld ? (version == 0 ? 9 : 13) : 1);
  const std::uint64_t base = this->Offset(block);
  this->Offset(block); // address of the free space, or of the extension
  this->Offset(block); // end of the file
  if (isOld)
  {
    this->Offset(block); // address of the driver's information
    this->Offset(block); // offset of the root's name
  }
  this->Root = this->Offset(block);
  this->Base = base;
  return true;
}

bool Hdf5Storage::IsAddress(std::uint64_t address) const
{
  const std::size_t bits = 8 * this->OffsetSize;
  const std::uint64_t undefined =
    bits == 64 ? ~std::uint64_t{ 0 } : (std::uint64_t{ 1 } << bits) - 1;
  return address != undefined;
}

Hdf5Block Hdf5Storage::ReadBlock(std::uint64_t address, std::uint64_t size)
{
  const std::uint64_t at = address + this->Base;
  this->BytesInAll += std::min(size, MostBytes) + 64;
  if (at < address || at > this->FileSize || size > this->FileSize - at || size > MostBytes ||
    this->BytesInAll > MostBytesInAll)
  {
    Hdf5Block::ThrowDamaged();
  }
  std::vector<unsigned char> bytes(static_cast<std::size_t>(size));
  this->File.Read(bytes.data(), bytes.size(), static_cast<std::int64_t>(at));
  return Hdf5Block(std::move(bytes));
}

} // namespace VolumeHaptics
