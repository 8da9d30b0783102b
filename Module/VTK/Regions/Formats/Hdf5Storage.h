// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads the blocks of an HDF5 file, and knows the sizes of the numbers in them.
 */
#ifndef Hdf5Storage_h
#define Hdf5Storage_h

#include "VTK/Regions/Formats/Hdf5Block.h"
#include "VTK/Regions/Formats/OpenedFile.h"

#include <cstdint>
#include <string>

namespace VolumeHaptics
{

/** Reads blocks by their addresses. Every fault is a std::runtime_error with its cure. */
class Hdf5Storage
{
public:
  /** Largest allowed size of a block (bytes). */
  static constexpr std::uint64_t MostBytes = std::uint64_t{ 1 } << 26;

  explicit Hdf5Storage(const std::string& name);

  Hdf5Block ReadBlock(std::uint64_t address, std::uint64_t size);
  /** Returns the address of the root's header. */
  std::uint64_t GetRoot() const { return this->Root; }
  /** Returns where addresses count from (bytes from the beginning of the file). */
  std::uint64_t GetBase() const { return this->Base; }
  /** Returns the size of the file (bytes). */
  std::uint64_t GetFileSize() const { return this->FileSize; }

  ///@{
  /** Read the next number of a block, of the size that addresses or lengths have in this file. */
  std::uint64_t Offset(Hdf5Block& block) const { return block.Number(this->OffsetSize); }
  std::uint64_t Length(Hdf5Block& block) const { return block.Number(this->LengthSize); }
  std::size_t GetOffsetSize() const { return this->OffsetSize; }
  std::size_t GetLengthSize() const { return this->LengthSize; }
  ///@}
  /** Whether an address points to something. */
  bool IsAddress(std::uint64_t address) const;

private:
  bool ReadSuperblock(std::uint64_t at);

  const OpenedFile File;
  const std::uint64_t FileSize;
  std::uint64_t BytesInAll = 0; ///< number of bytes read so far
  std::uint64_t Base = 0;
  std::size_t OffsetSize = 8;
  std::size_t LengthSize = 8;
  std::uint64_t Root = 0;
};

} // namespace VolumeHaptics

#endif
