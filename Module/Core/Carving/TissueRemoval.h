// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file The tissue that a tool has removed from a volume. A tick writes to nothing else but its own
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
  Undo = 1, ///< undoes the last stroke
  Redo = 2,
  Reset = 3 ///< restores all tissue
};

/**
 * The remaining fractions, their journal, and the undo and redo requests of another thread, which
 * the thread that ticks carries out piece by piece.
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

  /** Queues a request; returns false if too many requests wait. Called by one thread. */
  bool Request(RemovalRequest request) noexcept;
  /** Returns the number of requests that wait or are being carried out. From any thread. */
  std::size_t GetPending() const noexcept
  {
    return this->Head.load(std::memory_order_acquire) - this->Done.load(std::memory_order_acquire);
  }
  /** Returns whether tissue could not be removed because all bricks are in use. From any thread. */
  bool IsUsedUp() const noexcept { return this->UsedUp.load(std::memory_order_relaxed); }

  ///@{
  /**
   * Called by the thread that ticks, at the beginning of a tick: carries out a piece of a request,
   * which may bring tissue back. Returns false if there was no request.
   * @param begun if not null, receives the request that this call began, or None
   */
  bool Serve(RemovalRequest* begun = nullptr) noexcept;
  /** Returns whether the next Serve has something to do. */
  bool HasWork() const noexcept { return this->GetPending() > 0; }
  void SetUsedUp(bool isUsedUp) noexcept
  {
    this->UsedUp.store(isUsedUp, std::memory_order_relaxed);
  }
  ///@}

  ///@{
  /**
   * Copies all fractions at one tick. One other thread at a time begins the copy, which allocates;
   * then the thread that ticks completes it with TakeSnapshot, at the beginning of a tick and
   * before Serve. TakeSnapshot returns false if it can't complete a copy now: none was begun, or a
   * request is being carried out, or so much has changed that the copy has to be begun again
   * (IsSnapshotLate). From then on, earlier strokes can no longer be undone or redone.
   */
  void BeginSnapshot() { this->Snapshot = std::make_unique<TissueSnapshot>(this->Bricks); }
  bool TakeSnapshot() noexcept;
  bool IsSnapshotLate() const noexcept { return this->Snapshot && this->Snapshot->IsLate(); }
  /** Ends the copying and returns the copied bricks; none if the copy was not completed. */
  std::vector<BrickTissue> EndSnapshot();
  ///@}

  CarvedBricks Bricks;
  RemovalJournal Journal;

private:
  static constexpr std::size_t MostRequests = 64;
  /** The number of bricks that a tick exchanges: 16 KiB. */
  static constexpr std::size_t BricksPerTick = 32;

  std::atomic<RemovalRequest> Requests[MostRequests] = {};
  std::atomic<std::size_t> Head{ 0 }; ///< the number of requests so far
  std::atomic<std::size_t> Done{ 0 }; ///< the number of requests carried out
  std::atomic<bool> UsedUp{ false };
  std::unique_ptr<TissueSnapshot> Snapshot;
};

} // namespace VolumeHaptics

#endif
