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

/** A file with a header and uncompressed samples, x fastest and z slowest. */
struct RawVolumeFile
{
  std::string Name;
  BoxExtent Extent;
  std::size_t SampleSize = 0;  ///< bytes per sample
  vtkTypeInt64 HeaderSize = 0; ///< bytes before the first sample
  bool IsSwapped = false;      ///< whether the byte order differs from this computer's
  /**
   * Distances (samples in the file) between neighbours along x, y and z; zeros if the volume is
   * contiguous.
   */
  std::array<std::int64_t, 3> Steps{};
  /** Number of samples before the volume's first one, such as samples of other channels. */
  std::int64_t First = 0;

  /** Function that reads bytes at an offset from the end of the header. */
  using ByteReader = std::function<void(void* to, std::size_t size, std::int64_t from)>;
  /** Reads a box like Read(), but through a function. */
  void ReadWith(const ByteReader& read, const int box[6], void* samples) const;

  /**
   * Reads a box, row by row. Opens the file for each box, so the file may be replaced or grow
   * between two boxes, and several threads may read at once. Throws std::runtime_error.
   */
  void Read(const int box[6], void* samples) const;
};

/** Reverses the bytes of each sample. `size` (bytes) is that of all samples together. */
void SwapBytes(char* samples, std::size_t size, std::size_t sampleSize);

} // namespace VolumeHaptics

#endif
