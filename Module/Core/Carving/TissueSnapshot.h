// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A copy of all remaining fractions at one tick. Another thread copies all bricks, so that the
 * ticking thread has to copy only the bricks that have changed since.
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

/** The fractions of one brick. */
struct BrickTissue
{
  std::uint64_t Key;
  std::array<std::uint64_t, CarvedBricks::Rows> Rows;
};

/**
 * Returns the bricks from which tissue was removed. Any thread may call this. If bricks change
 * during the call, the copies are from different moments.
 */
std::vector<BrickTissue> CopyBricks(const CarvedBricks& bricks);
/**
 * Stores bricks. Returns false if there is no room for all of them. Only the writer may call this.
 */
bool WriteBricks(const std::vector<BrickTissue>& fractions, CarvedBricks& bricks) noexcept;

class TissueSnapshot
{
public:
  /** Limit of the bricks that may change before the snapshot is completed (1 MiB). */
  static constexpr std::size_t MostLate = 2048;

  /**
   * Copies all bricks, which may change during the call, and keeps a reference to them. Allocates.
   */
  explicit TissueSnapshot(CarvedBricks& bricks);
  ~TissueSnapshot();
  TissueSnapshot(const TissueSnapshot&) = delete;
  TissueSnapshot& operator=(const TissueSnapshot&) = delete;

  /**
   * Called by the writer of the bricks: copies the bricks that have changed since the construction.
   * Returns false if too many bricks have changed, or if the snapshot is complete already.
   */
  bool Complete() noexcept;
  /**
   * Returns whether Complete() failed because too many bricks had changed. Any thread may call
   * this.
   */
  bool IsLate() const noexcept { return this->State.load(std::memory_order_acquire) == Late; }
  /**
   * Returns all bricks in the order of their numbers. Includes bricks that are whole again, because
   * they take up room, too. Returns none if the snapshot is not complete.
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
  std::vector<BrickTissue> Copies; ///< copies of the bricks, by number
  struct Change
  {
    std::uint32_t Brick;
    BrickTissue Fractions;
  };
  std::vector<Change> Changes;
  std::size_t Count = 0; ///< number of changes in Changes
  std::atomic<Stage> State{ Open };
};

} // namespace VolumeHaptics

#endif
