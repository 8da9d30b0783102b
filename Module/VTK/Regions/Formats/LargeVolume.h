// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A volume that is read only in boxes.
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
 * Fills the samples of a box, x fastest. On failure returns false, or throws an exception with the
 * reason.
 */
using BoxReader = std::function<bool(const int extent[6], void* samples)>;

/** Describes how the samples of a volume are read. Never changes, so that threads can share it. */
struct LargeVolume
{
  BoxExtent Extent;
  int ScalarType = VTK_SHORT;
  std::size_t SampleSize = sizeof(short); ///< bytes of all values
  int ValuesPerSample = 1;                ///< number of values in a sample
  std::string Name;                       ///< name for messages, such as "the file Bone.raw"
  BoxReader Read;
  /** Whether the volume's user, before it ends, waits for a read that is under way. */
  bool IsAwaited = true;
  /**
   * Size of what is read at once, in samples along x, y and z; zeros if boxes may have any size.
   */
  std::array<std::int64_t, 3> ChunkSize{};
  /**
   * Whether the volume is known to have no noise, and its outside value is known, so that no survey
   * is needed.
   */
  bool IsSmooth = false;
  bool AreLabels = false; ///< no label counts as outside
  double BorderValue = 0.0;
};

/** Returns the number of samples of an extent, as a double: the product may exceed all integers. */
double CountSamples(const BoxExtent& extent);

/** Returns a box of a width (samples) in the middle of an extent, or as much of it as fits. */
BoxExtent ComputeMiddle(const BoxExtent& whole, int width);

/**
 * Reads a box of the volume without throwing. Returns false, with the box and the reason in
 * `error`, on failure.
 */
bool ReadSamples(
  const LargeVolume& volume, const BoxExtent& box, void* samples, std::string& error);

} // namespace VolumeHaptics

#endif
