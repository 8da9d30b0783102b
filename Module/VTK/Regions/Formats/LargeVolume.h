// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A volume of which only boxes are read.
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

/** Fills the samples of a box, x fastest. False, or an exception whose text tells why, if not. */
using BoxReader = std::function<bool(const int extent[6], void* samples)>;

/** How the samples of a volume are read. Never changes, so that threads share it. */
struct LargeVolume
{
  BoxExtent Extent;
  int ScalarType = VTK_SHORT;
  std::size_t SampleSize = sizeof(short); ///< bytes of all values
  int ValuesPerSample = 1;                ///< values of this type that a sample has
  std::string Name;                       ///< for messages, such as "the file Bone.raw"
  BoxReader Read;
  /** Whether its user waits for a read that is under way before it ends. */
  bool IsAwaited = true;
  /** Of what is read at once, in samples along x, y and z; zeros if boxes of any size are. */
  std::array<std::int64_t, 3> ChunkSize{};
  /** Whether it is known to be without noise, and the value outside: then nothing is surveyed. */
  bool IsSmooth = false;
  bool AreLabels = false; ///< none of which is taken for outside
  double BorderValue = 0.0;
};

/** The number of samples of an extent, as a double: the product may exceed all integers. */
double CountSamples(const BoxExtent& extent);

/** A box of a width (samples) in the middle of an extent, or as much of it as there is. */
BoxExtent FindMiddle(const BoxExtent& whole, int width);

/**
 * Reads a box of the volume; no exception leaves this. False, with the box and the reason in
 * `error`, if that fails.
 */
bool ReadSamples(
  const LargeVolume& volume, const BoxExtent& box, void* samples, std::string& error);

} // namespace VolumeHaptics

#endif
