// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads boxes of samples that lie in chunks, as HDF5 and Zarr store them.
 */
#ifndef ChunkedVolume_h
#define ChunkedVolume_h

#include "VTK/Regions/Formats/LargeVolume.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace VolumeHaptics
{

/** The place of a chunk among all chunks, along x, y and z. */
using ChunkPlace = std::array<std::int64_t, 3>;

struct ChunkedVolume
{
  /**
   * Gives all bytes of a chunk, x fastest, also those beyond the volume; false if it was never
   * written. Throws std::runtime_error. Several threads may call it at once.
   */
  using Loader = std::function<bool(const ChunkPlace& place, std::vector<char>& bytes)>;

  BoxExtent Extent;
  std::array<std::int64_t, 3> ChunkSize{}; ///< samples, along x, y and z
  std::size_t SampleSize = 0;              ///< bytes
  bool IsSwapped = false;                  ///< whether its byte order is not that of this computer
  std::vector<char> FillValue;             ///< the bytes of a sample of a chunk that is missing
  Loader Load;

  /** Reads a box, chunk by chunk. Throws what the loader throws. */
  void Read(const int box[6], void* samples) const;

private:
  void CopyRows(const int box[6], const ChunkPlace& place, const char* chunk, char* samples) const;
};

} // namespace VolumeHaptics

#endif
