// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads boxes of samples from a raw file.
 */
#ifndef RawVolumeFile_h
#define RawVolumeFile_h

#include "VTK/Regions/Formats/LargeVolume.h"

#include <array>
#include <cstdint>
#include <functional>
#include <string>

namespace VolumeHaptics
{

/** A file that contains samples, x fastest and z slowest, after a header. */
struct RawVolumeFile
{
  std::string Name;
  BoxExtent Extent;
  std::size_t SampleSize = 0;  ///< size of a sample (bytes)
  vtkTypeInt64 HeaderSize = 0; ///< number of bytes before the first sample
  bool IsSwapped = false;      ///< whether its byte order differs from this computer's
  /**
   * Distances between neighbours along x, y and z, in samples of the file; zeros if the volume is
   * contiguous.
   */
  std::array<std::int64_t, 3> Steps{};
  /** Number of samples before the first one of the volume, such as those of other channels. */
  std::int64_t First = 0;

  /** Reads bytes at an offset from the end of the header. */
  using ByteReader = std::function<void(void* to, std::size_t size, std::int64_t from)>;
  /** Reads a box as Read() does, but gets the bytes from a function. */
  void ReadWith(const ByteReader& read, const int box[6], void* samples) const;

  /**
   * Reads a box, row by row. Opens the file for each box, so that it may be replaced or grow
   * between two boxes, and several threads may read at once. Throws std::runtime_error.
   */
  void Read(const int box[6], void* samples) const;
};

/** Reverses the bytes of each sample. `size` is the total size of all samples (bytes). */
void SwapBytes(char* samples, std::size_t size, std::size_t sampleSize);

} // namespace VolumeHaptics

#endif
