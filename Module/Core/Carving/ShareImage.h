// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Shares as a plain image, a byte for each sample, x first: to save, load and show removed tissue.
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
 * Writes the shares of one brick to the image of a box; other bricks stay as they are. For a reader
 * that follows changes. A brick outside the box changes nothing.
 */
void WriteBrick(
  const CarvedBricks& bricks, std::uint32_t brick, const ShareBox& box, std::uint8_t* to) noexcept;

/**
 * Called by the writer: sets all shares from an image; tissue comes back where the image has all of
 * it. False, without a change, if there are not enough bricks, or indices are below 0.
 */
bool ReadShares(CarvedBricks& bricks, const ShareBox& box, const std::uint8_t* from) noexcept;

/**
 * The bricks of another volume, whose samples are a box of this volume: leaves out what is outside
 * the box; the box may reach beyond the volume.
 */
std::vector<BrickShares> MoveShares(const std::vector<BrickShares>& bricks, const ShareBox& box);

} // namespace VolumeHaptics

#endif
