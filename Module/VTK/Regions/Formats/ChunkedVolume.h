// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads boxes of samples that are stored in chunks, as in HDF5 and Zarr.
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

/** Position of a chunk: its indices along x, y and z. */
using ChunkPlace = std::array<std::int64_t, 3>;

struct ChunkedVolume
{
  /**
   * Function that loads all bytes of a chunk (x fastest), including the bytes beyond the volume's
   * border. Returns false if the chunk was never written. Throws std::runtime_error. Must be safe
   * on several threads at once.
   */
  using Loader = std::function<bool(const ChunkPlace& place, std::vector<char>& bytes)>;

  BoxExtent Extent;
  std::array<std::int64_t, 3> ChunkSize{}; ///< samples, along x, y and z
  std::size_t SampleSize = 0;              ///< bytes per sample
  bool IsSwapped = false;                  ///< whether the byte order differs from this computer's
  std::vector<char> FillValue;             ///< bytes of a sample in a missing chunk
  Loader Load;

  /** Reads a box, chunk by chunk. Passes on exceptions of the loader. */
  void Read(const int box[6], void* samples) const;

private:
  void CopyRows(const int box[6], const ChunkPlace& place, const char* chunk, char* samples) const;
};

} // namespace VolumeHaptics

#endif
