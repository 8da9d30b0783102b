// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads the trees of an HDF5 file: the links of groups, and the chunks of datasets.
 */
#ifndef Hdf5Trees_h
#define Hdf5Trees_h

#include "VTK/Regions/Formats/Hdf5Object.h"
#include "VTK/Regions/Formats/Hdf5Storage.h"

#include <cstdint>
#include <vector>

namespace VolumeHaptics
{

/** How a dataset lists its chunks. */
struct Hdf5ChunkIndex
{
  /** Types of messages of version 4; earlier messages use a B-tree of version 1. */
  enum IndexType
  {
    Tree = 0,
    Single = 1,
    Implicit = 2,
    FixedArray = 3,
    ExtensibleArray = 4,
    NewTree = 5
  };

  int Type = Tree;
  std::uint64_t Address = 0;
  Hdf5Chunk Chunk; ///< chunk of Single, without its address
};

class Hdf5Trees
{
public:
  explicit Hdf5Trees(Hdf5Storage& storage)
    : Storage(storage)
  {
  }

  /** Adds the links of a group, from its B-tree and the heap with their names. */
  void ReadLinks(std::uint64_t tree, std::uint64_t heap, Hdf5Object& object);
  /** Adds the chunks of a dataset. Its other messages must have been read. */
  void ReadChunks(const Hdf5ChunkIndex& index, Hdf5Object& object);

private:
  void ReadLinkNode(std::uint64_t address, int level, Hdf5Block& names, Hdf5Object& object);
  void ReadChunkNode(std::uint64_t address, int level, Hdf5Object& object);
  /** Reads an array of chunks. `size` is the size of a chunk without filters (bytes). */
  void ReadChunkArray(const Hdf5ChunkIndex& index, std::uint64_t size, Hdf5Object& object);
  void AddChunk(const std::vector<std::uint64_t>& first, Hdf5Chunk chunk, Hdf5Object& object) const;

  Hdf5Storage& Storage;
};

} // namespace VolumeHaptics

#endif
