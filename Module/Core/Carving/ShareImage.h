// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Shares as a plain image, a byte for each sample, x first: to save and load what was removed, and
 * to show it.
 */
#ifndef ShareImage_h
#define ShareImage_h

#include "Core/Carving/CarvedBricks.h"
#include "Core/Carving/ShareSnapshot.h"

#include <cstdint>
#include <vector>

namespace VolumeHaptics
{

/** A box of a volume's samples. */
struct ShareBox
{
  std::int64_t First[3];
  std::int64_t Size[3];
};

/** Writes the shares of a box; from any thread. */
void WriteShares(const CarvedBricks& bricks, const ShareBox& box, std::uint8_t* to) noexcept;

/**
 * Writes those of one brick to the image of a box, which other bricks are left out of: for a reader
 * that follows changes. Where the brick is beyond the box, nothing is written.
 */
void WriteBrick(
  const CarvedBricks& bricks, std::uint32_t brick, const ShareBox& box, std::uint8_t* to) noexcept;

/**
 * Takes all shares from an image, by the writer: tissue comes back where the image has all of it.
 * False, and nothing is changed, if there are not enough bricks, or indices are below 0.
 */
bool ReadShares(CarvedBricks& bricks, const ShareBox& box, const std::uint8_t* from) noexcept;

/**
 * The bricks of another volume, whose samples are a box of the volume of these bricks: what is
 * beyond the box is left out, and the box may reach beyond the volume.
 */
std::vector<BrickShares> MoveShares(const std::vector<BrickShares>& bricks, const ShareBox& box);

} // namespace VolumeHaptics

#endif
