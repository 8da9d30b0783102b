// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A copy of all remaining fractions at one tick; the thread that ticks copies only the last
 * changes.
 */
#ifndef TissueSnapshot_h
#define TissueSnapshot_h

#include "Core/Carving/CarvedBricks.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace VolumeHaptics
{

/** The fractions of a brick. */
struct BrickTissue
{
  std::uint64_t Key;
  std::array<std::uint64_t, CarvedBricks::Rows> Rows;
};

/**
 * Returns the bricks that are not whole. From any thread; if bricks change meanwhile, the copies
 * are from different moments.
 */
std::vector<BrickTissue> CopyBricks(const CarvedBricks& bricks);
/** Called by the writer: stores bricks; returns false if there is no room for all of them. */
bool WriteBricks(const std::vector<BrickTissue>& fractions, CarvedBricks& bricks) noexcept;

class TissueSnapshot
{
public:
  /** The limit of bricks that change until the tick that completes the snapshot: 1 MiB. */
  static constexpr std::size_t MostLate = 2048;

  /** Copies all bricks, while they may change. Borrows the bricks. Allocates. */
  explicit TissueSnapshot(CarvedBricks& bricks);
  ~TissueSnapshot();
  TissueSnapshot(const TissueSnapshot&) = delete;
  TissueSnapshot& operator=(const TissueSnapshot&) = delete;

  /**
   * Called by the writer of the bricks: copies the bricks that have changed since the construction.
   * Returns false if too many bricks have changed, or if the snapshot is complete already.
   */
  bool Complete() noexcept;
  /** Returns whether too many bricks had changed. From any thread. */
  bool IsLate() const noexcept { return this->State.load(std::memory_order_acquire) == Late; }
  /**
   * Returns all bricks, in the order of their numbers, including whole bricks, since these take up
   * room, too. Empty if the snapshot is not complete.
   */
  std::vector<BrickTissue> Collect() const;

private:
  enum Stage : std::uint8_t
  {
    Open,
    Done,
    Late
  };

  CarvedBricks& Bricks;
  const int Follower;
  std::vector<BrickTissue> Copies; ///< the copies, by the brick's number
  struct Change
  {
    std::uint32_t Brick;
    BrickTissue Fractions;
  };
  std::vector<Change> Changes;
  std::size_t Count = 0; ///< number of changes
  std::atomic<Stage> State{ Open };
};

} // namespace VolumeHaptics

#endif
