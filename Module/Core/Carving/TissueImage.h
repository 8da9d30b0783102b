// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Converts remaining fractions to a plain image and back, to save, load and display them. The image
 * has one byte per sample, x fastest.
 */
#ifndef TissueImage_h
#define TissueImage_h

#include "Core/Carving/CarvedBricks.h"
#include "Core/Carving/TissueSnapshot.h"

#include <cstdint>
#include <vector>

namespace VolumeHaptics
{

/** A box of samples in a volume: its first index and its size along each axis. */
struct TissueBox
{
  std::int64_t First[3];
  std::int64_t Size[3];
};

/** Writes the fractions in a box to an image. Any thread may call this. */
void WriteTissue(const CarvedBricks& bricks, const TissueBox& box, std::uint8_t* to) noexcept;

/**
 * Writes one brick's fractions to the image of a box. A thread that follows changes calls this for
 * each changed brick. Writes nothing if the brick is outside the box.
 */
void WriteBrick(
  const CarvedBricks& bricks, std::uint32_t brick, const TissueBox& box, std::uint8_t* to) noexcept;

/**
 * Sets all fractions from an image, and restores tissue where the image has all of it. Returns
 * false and changes nothing if there are not enough bricks or if an index is negative. Only the
 * writer may call this.
 */
bool ReadTissue(CarvedBricks& bricks, const TissueBox& box, const std::uint8_t* from) noexcept;

/**
 * Converts the bricks of a volume to the bricks of a second volume, whose samples are a box of the
 * first one. Drops all tissue outside the box. The box may reach beyond the first volume.
 */
std::vector<BrickTissue> MoveTissue(const std::vector<BrickTissue>& bricks, const TissueBox& box);

} // namespace VolumeHaptics

#endif
