// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A volume that is only read in boxes.
 */
#ifndef LargeVolume_h
#define LargeVolume_h

#include "vtkType.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace VolumeHaptics
{

using BoxExtent = std::array<int, 6>;

/**
 * Fills memory with the samples of a box, x fastest. On failure, returns false, or throws an
 * exception with the reason.
 */
using BoxReader = std::function<bool(const int extent[6], void* samples)>;

/**
 * Describes a volume and how its samples are read. It never changes, so that threads can share it.
 */
struct LargeVolume
{
  BoxExtent Extent;
  int ScalarType = VTK_SHORT;
  std::size_t SampleSize = sizeof(short); ///< size of all values of a sample (bytes)
  int ValuesPerSample = 1;                ///< number of values in a sample
  std::string Name;                       ///< name for messages, such as "the file Bone.raw"
  BoxReader Read;
  /** Whether the user of the volume waits, before ending, for a read that is under way. */
  bool IsAwaited = true;
  /**
   * Size of the boxes that are best read at once, in samples along x, y and z; zeros if any size
   * will do.
   */
  std::array<std::int64_t, 3> ChunkSize{};
  /**
   * Whether the volume has no noise and its outside value is known, so that no survey is needed.
   */
  bool IsSmooth = false;
  bool AreLabels = false; ///< whether samples are labels; then none counts as outside
  double BorderValue = 0.0;
};

/**
 * Returns the number of samples of an extent. It is a double, because the product may overflow
 * 64-bit integers.
 */
double CountSamples(const BoxExtent& extent);

/**
 * Returns a box in the middle of an extent: `width` samples wide, or less where the extent is
 * narrower.
 */
BoxExtent ComputeMiddle(const BoxExtent& whole, int width);

/**
 * Reads a box of the volume without throwing. On failure, returns false, with the box and the
 * reason in `error`.
 */
bool ReadSamples(
  const LargeVolume& volume, const BoxExtent& box, void* samples, std::string& error);

} // namespace VolumeHaptics

#endif
