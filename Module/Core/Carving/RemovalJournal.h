// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Undo and redo of what was removed, by strokes.
 *
 * Before a stroke first changes a brick, the journal keeps the brick's rows. To undo a stroke, they
 * change places with those of the brick, so that the journal has what a redo needs; and the other
 * way round. Its memory is fixed: if it is used up, the oldest strokes can't be undone any more.
 *
 * Work is done in pieces, so that a tick does a bounded part of it. Only the writer of the bricks
 * may call this, but for the numbers of strokes.
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
  /** A stroke: before each change of a brick, the brick is kept. Not while there is work. */
  void Begin() noexcept;
  bool IsOpen() const noexcept { return this->HasOpen; }
  void Keep(std::uint32_t brick) noexcept;
  /** Counts a volume (mm^3) that was removed, to the open stroke if there is one. */
  void Count(double volume) noexcept;
  void End() noexcept;
  /** Ends an open stroke; none of those so far can be undone or redone. Not while there is work. */
  void Forget() noexcept;
  ///@}

  ///@{
  /** Each ends an open stroke; false if there is nothing to do, or work that is not done. */
  bool StartUndo() noexcept;
  bool StartRedo() noexcept;
  /** All tissue comes back, and there is nothing to undo. */
  bool StartReset() noexcept;
  ///@}
  bool HasWork() const noexcept { return this->Work != Kind::None; }
  /** Does a piece of it: this many bricks at most. */
  void Continue(std::size_t bricks) noexcept;

  ///@{
  /** From any thread: how many strokes can be undone, with an open one, and redone. */
  std::size_t GetUndoable() const noexcept { return this->Undoable.load(); }
  std::size_t GetRedoable() const noexcept { return this->Redoable.load(); }
  ///@}
  /** From any thread: what was counted (mm^3), less what was undone. */
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
  /** Of the numbers of entries, which count on beyond the memory's size. */
  struct Stroke
  {
    std::uint64_t Begin;
    std::uint64_t End;
    double Volume; ///< mm^3
  };

  Stroke& At(std::uint64_t stroke) noexcept { return this->Strokes[stroke % MostStrokes]; }
  void Exchange(Entry& entry) noexcept;
  void Tell() noexcept;
  void AddVolume(double volume) noexcept
  {
    this->Volume.store(this->GetVolume() + volume, std::memory_order_relaxed);
  }

  CarvedBricks& Bricks;
  std::vector<Entry> Entries;
  std::vector<Stroke> Strokes;
  std::vector<std::uint32_t> Stamps; ///< of each brick, that of the last stroke that kept it
  std::uint32_t Stamp = 0;           ///< of the open stroke
  std::uint64_t Head = 0;            ///< the number of the next entry
  ///@{
  /** Strokes from First on can be undone, those from Applied on redone, up to Last. */
  std::uint64_t First = 0;
  std::uint64_t Applied = 0;
  std::uint64_t Last = 0;
  ///@}
  bool HasOpen = false;
  bool IsTooLarge = false; ///< the open stroke, to be undone
  Kind Work = Kind::None;
  std::uint64_t Next = 0; ///< of the work: an entry, or a brick
  std::uint64_t Stop = 0;
  std::atomic<std::size_t> Undoable{ 0 };
  std::atomic<std::size_t> Redoable{ 0 };
  std::atomic<double> Volume{ 0.0 };
};

} // namespace VolumeHaptics

#endif
