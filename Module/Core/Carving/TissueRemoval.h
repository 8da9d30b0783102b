// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Records which tissue a tool has removed from a volume. A tick writes only these data and its own
 * state.
 */
#ifndef TissueRemoval_h
#define TissueRemoval_h

#include "Core/Carving/CarvedBricks.h"
#include "Core/Carving/RemovalJournal.h"
#include "Core/Carving/TissueSnapshot.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace VolumeHaptics
{

enum class RemovalRequest : std::uint8_t
{
  None = 0,
  Undo = 1, ///< undo the last stroke
  Redo = 2,
  Reset = 3 ///< restore all tissue
};

/**
 * The remaining fractions, their journal, and a queue of undo and redo requests from another
 * thread. The ticking thread serves the requests piece by piece.
 */
class TissueRemoval
{
public:
  explicit TissueRemoval(std::uint32_t mostBricks = CarvedBricks::DefaultMost,
    std::size_t mostKept = RemovalJournal::DefaultMost)
    : Bricks(mostBricks)
    , Journal(Bricks, mostKept)
  {
  }
  TissueRemoval(const TissueRemoval&) = delete;
  TissueRemoval& operator=(const TissueRemoval&) = delete;

  /** Queues a request. Returns false if the queue is full. Only one thread may call this. */
  bool Request(RemovalRequest request) noexcept;
  /** Returns the number of unfinished requests. Any thread may call this. */
  std::size_t GetPending() const noexcept
  {
    return this->Head.load(std::memory_order_acquire) - this->Done.load(std::memory_order_acquire);
  }
  /** Returns the number of finished requests. Any thread may call this. */
  std::size_t GetDone() const noexcept { return this->Done.load(std::memory_order_acquire); }
  /**
   * Returns whether a tool could not remove tissue because all bricks were in use. Any thread may
   * call this.
   */
  bool IsUsedUp() const noexcept { return this->UsedUp.load(std::memory_order_relaxed); }

  ///@{
  /**
   * Serves a piece of the oldest request, which may restore tissue. The ticking thread calls this
   * at the beginning of a tick. Returns false if there was no request.
   * @param begun if not null, receives the request that this call began, or None
   */
  bool Serve(RemovalRequest* begun = nullptr) noexcept;
  bool HasWork() const noexcept { return this->GetPending() > 0; }
  void SetUsedUp(bool isUsedUp) noexcept
  {
    this->UsedUp.store(isUsedUp, std::memory_order_relaxed);
  }
  ///@}

  ///@{
  /**
   * Copy all fractions at one tick. One other thread at a time calls BeginSnapshot, which allocates
   * and copies. Then the ticking thread calls TakeSnapshot at the beginning of a tick, before
   * Serve, to complete the copy; from then on, earlier strokes can no longer be undone or redone.
   * TakeSnapshot returns false if no copy was begun, if a request is being served, or if so much
   * has changed that the copy must be begun again (IsSnapshotLate).
   */
  void BeginSnapshot() { this->Snapshot = std::make_unique<TissueSnapshot>(this->Bricks); }
  bool TakeSnapshot() noexcept;
  bool IsSnapshotLate() const noexcept { return this->Snapshot && this->Snapshot->IsLate(); }
  /** Ends the copying. Returns the copied bricks, or none if the copy was not completed. */
  std::vector<BrickTissue> EndSnapshot();
  ///@}

  CarvedBricks Bricks;
  RemovalJournal Journal;

private:
  static constexpr std::size_t MostRequests = 64;
  /** Number of bricks that a tick may exchange (16 KiB). */
  static constexpr std::size_t BricksPerTick = 32;

  std::atomic<RemovalRequest> Requests[MostRequests] = {};
  std::atomic<std::size_t> Head{ 0 }; ///< number of all requests so far
  std::atomic<std::size_t> Done{ 0 }; ///< number of finished requests
  std::atomic<bool> UsedUp{ false };
  std::unique_ptr<TissueSnapshot> Snapshot;
};

} // namespace VolumeHaptics

#endif
