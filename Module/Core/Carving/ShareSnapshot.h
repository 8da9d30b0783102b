// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A copy of all shares at one tick, of which the thread that ticks copies only the last changes.
 */
#ifndef ShareSnapshot_h
#define ShareSnapshot_h

#include "Core/Carving/CarvedBricks.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace VolumeHaptics
{

/** The shares of a brick. */
struct BrickShares
{
  std::uint64_t Key;
  std::array<std::uint64_t, CarvedBricks::Rows> Rows;
};

/** The bricks that are not whole. From any thread, but of different moments if they change. */
std::vector<BrickShares> CopyBricks(const CarvedBricks& bricks);
/** By the writer: false, if there is no room for all of them. */
bool WriteBricks(const std::vector<BrickShares>& shares, CarvedBricks& bricks) noexcept;

class ShareSnapshot
{
public:
  /** Bricks that may change until the tick at which the snapshot is completed: 1 MiB. */
  static constexpr std::size_t MostLate = 2048;

  /** Copies all bricks, while they may change. Borrows them. Allocates. */
  explicit ShareSnapshot(CarvedBricks& bricks);
  ~ShareSnapshot();
  ShareSnapshot(const ShareSnapshot&) = delete;
  ShareSnapshot& operator=(const ShareSnapshot&) = delete;

  /**
   * Called by the writer of the bricks: copies those that have changed meanwhile. False if they are
   * too many, or it is complete already.
   */
  bool Complete() noexcept;
  /** From any thread: whether too many had changed. */
  bool IsLate() const noexcept { return this->State.load(std::memory_order_acquire) == Late; }
  /**
   * All bricks, in their order: whole ones, too, as they take of the room for others. Empty if it
   * is not complete.
   */
  std::vector<BrickShares> Collect() const;

private:
  enum Stage : std::uint8_t
  {
    Open,
    Done,
    Late
  };

  CarvedBricks& Bricks;
  const int Follower;
  std::vector<BrickShares> Copies; ///< by the number of the brick
  struct Change
  {
    std::uint32_t Brick;
    BrickShares Shares;
  };
  std::vector<Change> Changes;
  std::size_t Count = 0; ///< of the changes
  std::atomic<Stage> State{ Open };
};

} // namespace VolumeHaptics

#endif
