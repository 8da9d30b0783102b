// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Undo and redo of removed tissue, by strokes.
 *
 * Before a stroke first changes a brick, the journal stores the brick's rows. To undo a stroke, it
 * swaps them with the rows in the brick, so that the journal then has the rows that a redo needs,
 * and the reverse. The memory is fixed: when it is used up, the oldest strokes can't be undone any
 * more.
 *
 * Work is done in pieces, so that a tick does a bounded part of it. Only the writer of the bricks
 * may call it, except for the numbers of strokes.
 */
#ifndef RemovalJournal_h
#define RemovalJournal_h

#include "Core/Carving/CarvedBricks.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace VolumeHaptics
{

class RemovalJournal
{
public:
  static constexpr std::size_t DefaultMost = 8192; ///< bricks, 4 MiB
  static constexpr std::size_t MostStrokes = 256;

  /** Borrows the bricks. */
  explicit RemovalJournal(CarvedBricks& bricks, std::size_t most = DefaultMost);

  ///@{
  /**
   * Begins a stroke: from now on each brick is stored before it first changes. Not while work is
   * pending.
   */
  void Begin() noexcept;
  bool IsOpen() const noexcept { return this->HasOpen; }
  void Keep(std::uint32_t brick) noexcept;
  /** Adds a removed volume (mm^3) to the total and, if a stroke is open, to the stroke. */
  void Count(double volume) noexcept;
  void End() noexcept;
  /**
   * Ends an open stroke. No stroke so far can then be undone or redone. Not while work is pending.
   */
  void Forget() noexcept;
  ///@}

  ///@{
  /**
   * Begins to undo, redo or restore. Each function ends an open stroke; returns false if there is
   * nothing to do or if work is pending.
   */
  bool StartUndo() noexcept;
  bool StartRedo() noexcept;
  /** Restores all tissue, with nothing to undo afterwards. */
  bool StartReset() noexcept;
  ///@}
  bool HasWork() const noexcept { return this->Work != Kind::None; }
  /** Does a piece of the pending work, on at most this many bricks. */
  void Continue(std::size_t bricks) noexcept;

  ///@{
  /**
   * Return the numbers of strokes that can be undone (including an open stroke) and redone. From
   * any thread.
   */
  std::size_t GetUndoable() const noexcept { return this->Undoable.load(); }
  std::size_t GetRedoable() const noexcept { return this->Redoable.load(); }
  ///@}
  /** Returns the removed volume (mm^3), less what was undone. From any thread. */
  double GetVolume() const noexcept { return this->Volume.load(std::memory_order_relaxed); }
  std::size_t GetMemorySize() const noexcept; ///< bytes

private:
  enum class Kind : std::uint8_t
  {
    None,
    Undo,
    Redo,
    Reset
  };
  struct Entry
  {
    std::uint32_t Brick;
    std::uint64_t Rows[CarvedBricks::Rows];
  };
  /** A stroke. Begin and end are numbers of entries, which grow beyond the memory's size. */
  struct Stroke
  {
    std::uint64_t Begin;
    std::uint64_t End;
    double Volume; ///< mm^3
  };

  Stroke& At(std::uint64_t stroke) noexcept { return this->Strokes[stroke % MostStrokes]; }
  void Exchange(Entry& entry) noexcept;
  void Report() noexcept;
  void AddVolume(double volume) noexcept
  {
    this->Volume.store(this->GetVolume() + volume, std::memory_order_relaxed);
  }

  CarvedBricks& Bricks;
  std::vector<Entry> Entries;
  std::vector<Stroke> Strokes;
  std::vector<std::uint32_t> Stamps; ///< per brick: stamp of the last stroke that stored it
  std::uint32_t Stamp = 0;           ///< the stamp of the open stroke
  std::uint64_t Head = 0;            ///< the number of the next entry
  ///@{
  /** Strokes from First on can be undone, those from Applied on redone, up to Last. */
  std::uint64_t First = 0;
  std::uint64_t Applied = 0;
  std::uint64_t Last = 0;
  ///@}
  bool HasOpen = false;
  bool IsTooLarge = false; ///< the open stroke is too large to be undone
  Kind Work = Kind::None;
  std::uint64_t Next = 0; ///< the next entry, or brick, of the work
  std::uint64_t Stop = 0;
  std::atomic<std::size_t> Undoable{ 0 };
  std::atomic<std::size_t> Redoable{ 0 };
  std::atomic<double> Volume{ 0.0 };
};

} // namespace VolumeHaptics

#endif
