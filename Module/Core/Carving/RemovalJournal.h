// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Undo and redo of removed tissue, stroke by stroke.
 *
 * Before a stroke first changes a brick, the journal stores the brick's rows. To undo a stroke, it
 * exchanges the stored rows with the brick's rows; then it holds the rows that a redo needs. A redo
 * exchanges them again. The memory is fixed: when it is used up, the oldest strokes can no longer
 * be undone.
 *
 * Work is done in pieces, so that each tick does a bounded part of it. Only the writer of the
 * bricks may change the journal, but any thread may read the numbers of strokes.
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
  static constexpr std::size_t DefaultMost = 8192; ///< default limit of stored bricks (4 MiB)
  static constexpr std::size_t MostStrokes = 256;

  /** Stores a reference to the bricks. */
  explicit RemovalJournal(CarvedBricks& bricks, std::size_t most = DefaultMost);

  ///@{
  /**
   * Begins a stroke: from now on each brick is stored before it first changes. Must not be called
   * while work is pending.
   */
  void Begin() noexcept;
  bool IsOpen() const noexcept { return this->HasOpen; }
  void Keep(std::uint32_t brick) noexcept;
  /** Adds a removed volume (mm^3) to the total and, if a stroke is open, to the stroke. */
  void Count(double volume) noexcept;
  void End() noexcept;
  /**
   * Ends an open stroke, and discards all strokes, so that none can be undone or redone. Must not
   * be called while work is pending.
   */
  void Forget() noexcept;
  ///@}

  ///@{
  /**
   * Start undoing, redoing or restoring. Each function ends an open stroke. Returns false if there
   * is nothing to do or if other work is pending.
   */
  bool StartUndo() noexcept;
  bool StartRedo() noexcept;
  /** Begins to restore all tissue. Afterwards no stroke can be undone. */
  bool StartReset() noexcept;
  ///@}
  bool HasWork() const noexcept { return this->Work != Kind::None; }
  /** Processes at most `bricks` bricks of the pending work. */
  void Continue(std::size_t bricks) noexcept;

  ///@{
  /**
   * Return the numbers of strokes that can be undone (an open stroke counts) and redone. Any thread
   * may call these functions.
   */
  std::size_t GetUndoable() const noexcept { return this->Undoable.load(); }
  std::size_t GetRedoable() const noexcept { return this->Redoable.load(); }
  ///@}
  /** Returns the removed volume (mm^3), without undone strokes. Any thread may call this. */
  double GetVolume() const noexcept { return this->Volume.load(std::memory_order_relaxed); }
  /** Returns the memory use (bytes). */
  std::size_t GetMemorySize() const noexcept;

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
  /**
   * A stroke and its entries. Begin and End count all entries ever made, so they may exceed the
   * memory's size.
   */
  struct Stroke
  {
    std::uint64_t Begin;
    std::uint64_t End;
    double Volume; ///< removed volume (mm^3)
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
  /** For each brick, the stamp of the last stroke that stored it. */
  std::vector<std::uint32_t> Stamps;
  std::uint32_t Stamp = 0; ///< stamp of the open stroke
  std::uint64_t Head = 0;  ///< number of the next entry
  ///@{
  /** Strokes First to Applied - 1 can be undone; strokes Applied to Last - 1 can be redone. */
  std::uint64_t First = 0;
  std::uint64_t Applied = 0;
  std::uint64_t Last = 0;
  ///@}
  bool HasOpen = false;
  bool IsTooLarge = false; ///< whether the open stroke is too large to be undone
  Kind Work = Kind::None;
  std::uint64_t Next = 0; ///< next entry or brick of the pending work
  std::uint64_t Stop = 0;
  std::atomic<std::size_t> Undoable{ 0 };
  std::atomic<std::size_t> Redoable{ 0 };
  std::atomic<double> Volume{ 0.0 };
};

} // namespace VolumeHaptics

#endif
