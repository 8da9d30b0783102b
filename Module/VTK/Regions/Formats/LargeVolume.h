// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A volume that is only read box by box.
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
 * Function that fills memory with the samples of a box, x fastest. On failure, it returns false or
 * throws an exception with the reason.
 */
using BoxReader = std::function<bool(const int extent[6], void* samples)>;

/** Describes a volume and how to read its samples. It is immutable, so threads can share it. */
struct LargeVolume
{
  BoxExtent Extent;
  int ScalarType = VTK_SHORT;
  std::size_t SampleSize = sizeof(short); ///< bytes per sample, including all of its values
  int ValuesPerSample = 1;                ///< number of components
  std::string Name;                       ///< name in messages, such as "the file Bone.raw"
  BoxReader Read;
  /** Whether the destructor of the volume's user waits for a read in progress. */
  bool IsAwaited = true;
  /**
   * Box size (samples along x, y and z) that is most efficient to read; zeros if any size will do.
   */
  std::array<std::int64_t, 3> ChunkSize{};
  /** Whether the noise is zero and the outside value is known, so that no survey is needed. */
  bool IsSmooth = false;
  bool AreLabels = false; ///< whether samples are labels, none of which is outside
  double BorderValue = 0.0;
};

/**
 * Returns the number of samples in an extent, as a double because the product may overflow 64-bit
 * integers.
 */
double CountSamples(const BoxExtent& extent);

/**
 * Returns the central box of an extent, `width` samples wide, or less where the extent is narrower.
 */
BoxExtent ComputeMiddle(const BoxExtent& whole, int width);

/**
 * Reads a box of the volume and never throws. On failure, returns false, with the box and the
 * reason in `error`.
 */
bool ReadSamples(
  const LargeVolume& volume, const BoxExtent& box, void* samples, std::string& error);

} // namespace VolumeHaptics

#endif
