// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The remaining fractions as a plain image, a byte for each sample, x first: to save, load and show
 * removed tissue.
 */
#ifndef TissueImage_h
#define TissueImage_h

#include "Core/Carving/CarvedBricks.h"
#include "Core/Carving/TissueSnapshot.h"

#include <cstdint>
#include <vector>

namespace VolumeHaptics
{

/** A box of a volume's samples. */
struct TissueBox
{
  std::int64_t First[3];
  std::int64_t Size[3];
};

/** Writes the fractions of a box to an image; from any thread. */
void WriteTissue(const CarvedBricks& bricks, const TissueBox& box, std::uint8_t* to) noexcept;

/**
 * Writes the fractions of one brick to the image of a box, for a reader that follows changes. A
 * brick outside the box changes nothing.
 */
void WriteBrick(
  const CarvedBricks& bricks, std::uint32_t brick, const TissueBox& box, std::uint8_t* to) noexcept;

/**
 * Called by the writer: sets all fractions from an image; tissue comes back where the image has all
 * of it. If there are not enough bricks, or indices are below 0, returns false and changes nothing.
 */
bool ReadTissue(CarvedBricks& bricks, const TissueBox& box, const std::uint8_t* from) noexcept;

/**
 * Converts bricks of a volume to bricks of another volume whose samples are a box of the first
 * volume. Leaves out what is outside the box; the box may reach beyond the first volume.
 */
std::vector<BrickTissue> MoveTissue(const std::vector<BrickTissue>& bricks, const TissueBox& box);

} // namespace VolumeHaptics

#endif
