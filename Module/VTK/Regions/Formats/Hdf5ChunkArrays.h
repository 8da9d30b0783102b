// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads the arrays in which HDF5 1.10 and later list the chunks of a dataset.
 *
 * The list is a fixed array if no dimension can grow, and an extensible array if one can. Both have
 * an entry for each chunk: its address and, if the dataset has filters, its size and the filters
 * that were left out. Entries are in blocks, and large blocks in pages; parts that were never
 * written are missing.
 */
#ifndef Hdf5ChunkArrays_h
#define Hdf5ChunkArrays_h

#include "VTK/Regions/Formats/Hdf5Object.h"
#include "VTK/Regions/Formats/Hdf5Storage.h"

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace VolumeHaptics
{

class Hdf5ChunkArrays
{
public:
  /** Receives the number of an entry, and its chunk. */
  using Taker = std::function<void(std::uint64_t number, const Hdf5Chunk& chunk)>;

  /** @param chunkSize size of a chunk without filters (bytes) */
  Hdf5ChunkArrays(Hdf5Storage& storage, std::uint64_t chunkSize, Taker take)
    : Storage(storage)
    , ChunkSize(chunkSize)
    , Take(std::move(take))
  {
  }

  ///@{
  /** Passes on all chunks that were written. */
  void ReadFixed(std::uint64_t address);
  void ReadExtensible(std::uint64_t address);
  ///@}

private:
  /** Reads the beginning that both kinds of headers share. */
  Hdf5Block BeginHeader(const char* signature, std::uint64_t address, std::uint64_t size);
  /** Reads a block after its signature and its header's address. */
  Hdf5Block BeginBlock(const char* signature, std::uint64_t address, std::uint64_t size);
  void ReadEntries(Hdf5Block& block, std::uint64_t first, std::uint64_t count);
  void ReadPage(std::uint64_t address, std::uint64_t first, std::uint64_t count);
  void ReadDataBlock(std::uint64_t address, std::uint64_t first, std::uint64_t count,
    const std::vector<char>& written, std::uint64_t firstPage);
  std::uint64_t GetPageSize() const { return std::uint64_t{ 1 } << this->PageBits; }

  Hdf5Storage& Storage;
  const std::uint64_t ChunkSize;
  const Taker Take;
  bool IsFiltered = false;
  std::size_t EntrySize = 0;  ///< bytes
  int PageBits = 0;           ///< a page has 2^PageBits entries
  std::size_t NumberSize = 0; ///< extensible arrays: bytes of an entry's number
};

} // namespace VolumeHaptics

#endif
