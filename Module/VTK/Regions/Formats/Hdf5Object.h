// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A group or a dataset of an HDF5 file.
 */
#ifndef Hdf5Object_h
#define Hdf5Object_h

#include "VTK/Regions/Formats/Hdf5Types.h"

#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

namespace VolumeHaptics
{

/** Position of a chunk's bytes in the file. */
struct Hdf5Chunk
{
  std::uint64_t Address = 0;
  std::uint64_t Size = 0;    ///< bytes
  std::uint64_t Skipped = 0; ///< a bit for each filter that was not applied
};

/** An object of the file: a group or a dataset. */
struct Hdf5Object
{
  enum LayoutType
  {
    NoData, ///< this object is a group
    Contiguous,
    Chunked,
    Elsewhere ///< within the header, or in other files
  };

  std::map<std::string, Hdf5Attribute> Attributes;
  std::map<std::string, std::uint64_t> Links; ///< addresses of the headers of a group's members
  /** Whether it has links stored in a way that is not read here. */
  bool HasOtherLinks = false;

  LayoutType Layout = NoData;
  Hdf5Type Type;
  /** Size of a dimension that may grow without limit. */
  static constexpr std::uint64_t Endless = ~std::uint64_t{ 0 };
  std::vector<std::uint64_t> Shape;
  std::vector<std::uint64_t> MostShape; ///< shape to which it may grow
  std::vector<char> FillValue;          ///< bytes of a sample that was never written; may be empty
  bool IsAllocated = true;              ///< for Contiguous
  std::uint64_t Address = 0;            ///< for Contiguous: position in the file (bytes)
  std::vector<std::uint64_t> ChunkShape;
  std::vector<Hdf5Filter> Filters; ///< in the order in which they were applied
  /**
   * Chunks by their number among all chunks of the last three dimensions, the last one fastest;
   * only chunks that are first along the earlier dimensions.
   */
  std::unordered_map<std::uint64_t, Hdf5Chunk> Chunks;
};

} // namespace VolumeHaptics

#endif
