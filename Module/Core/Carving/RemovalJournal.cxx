// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Carving/RemovalJournal.h"

#include <algorithm>

namespace VolumeHaptics
{

RemovalJournal::RemovalJournal(CarvedBricks& bricks, std::size_t most)
  : Bricks(bricks)
  , Entries(std::max<std::size_t>(most, 1))
  , Strokes(MostStrokes)
  , Stamps(bricks.GetMost())
{
}

void RemovalJournal::Begin() noexcept
{
  this->End();
  // Undone strokes can no longer be redone.
  this->Last = this->Applied;
  this->Head = this->Last > this->First ? this->At(this->Last - 1).End : this->Head;
  if (this->Last - this->First == MostStrokes)
  {
    ++this->First;
  }
  this->At(this->Last) = { this->Head, this->Head, 0.0 };
  this->HasOpen = true;
  this->IsTooLarge = false;
  if (++this->Stamp == 0)
  {
    std::fill(this->Stamps.begin(), this->Stamps.end(), 0);
    this->Stamp = 1;
  }
  this->Report();
}

void RemovalJournal::Keep(std::uint32_t brick) noexcept
{
  if (!this->HasOpen || this->IsTooLarge || this->Stamps[brick] == this->Stamp)
  {
    return;
  }
  this->Stamps[brick] = this->Stamp;
  while (this->Head - this->At(this->First).Begin == this->Entries.size())
  {
    if (this->First == this->Last)
    {
      this->IsTooLarge = true;
      this->Report();
      return;
    }
    ++this->First;
    this->Report();
  }
  const bool isFirst = this->Head == this->At(this->Last).Begin;
  Entry& entry = this->Entries[this->Head++ % this->Entries.size()];
  entry.Brick = brick;
  for (int row = 0; row < CarvedBricks::Rows; ++row)
  {
    entry.Rows[row] = this->Bricks.GetRow(brick, row);
  }
  if (isFirst)
  {
    this->Report();
  }
}

void RemovalJournal::Count(double volume) noexcept
{
  if (this->HasOpen)
  {
    this->At(this->Last).Volume += volume;
  }
  this->AddVolume(volume);
}

void RemovalJournal::End() noexcept
{
  if (!this->HasOpen)
  {
    return;
  }
  this->HasOpen = false;
  Stroke& stroke = this->At(this->Last);
  if (this->IsTooLarge)
  {
    // The entries of this stroke no longer fit, so this stroke and all earlier ones are lost.
    this->Head = stroke.Begin;
    return;
  }
  stroke.End = this->Head;
  if (stroke.End > stroke.Begin)
  {
    this->Applied = ++this->Last;
    this->Report();
  }
}

void RemovalJournal::Forget() noexcept
{
  this->End();
  this->First = this->Applied = this->Last;
  this->Report();
}

bool RemovalJournal::StartUndo() noexcept
{
  this->End();
  if (this->HasWork() || this->Applied == this->First)
  {
    return false;
  }
  const Stroke& stroke = this->At(this->Applied - 1);
  this->Work = Kind::Undo;
  this->Next = stroke.Begin;
  this->Stop = stroke.End;
  return true;
}

bool RemovalJournal::StartRedo() noexcept
{
  this->End();
  if (this->HasWork() || this->Applied == this->Last)
  {
    return false;
  }
  const Stroke& stroke = this->At(this->Applied);
  this->Work = Kind::Redo;
  this->Next = stroke.Begin;
  this->Stop = stroke.End;
  return true;
}

bool RemovalJournal::StartReset() noexcept
{
  this->End();
  if (this->HasWork() || this->Bricks.IsEmpty())
  {
    return false;
  }
  this->Forget();
  this->Work = Kind::Reset;
  this->Next = 0;
  this->Stop = this->Bricks.GetCount();
  return true;
}

void RemovalJournal::Exchange(Entry& entry) noexcept
{
  for (int row = 0; row < CarvedBricks::Rows; ++row)
  {
    const std::uint64_t shares = this->Bricks.GetRow(entry.Brick, row);
    this->Bricks.SetRow(entry.Brick, row, entry.Rows[row]);
    entry.Rows[row] = shares;
  }
  this->Bricks.MarkChanged(entry.Brick);
}

void RemovalJournal::Continue(std::size_t bricks) noexcept
{
  if (!this->HasWork())
  {
    return;
  }
  const std::uint64_t end = std::min<std::uint64_t>(this->Stop, this->Next + bricks);
  for (; this->Next < end; ++this->Next)
  {
    if (this->Work != Kind::Reset)
    {
      this->Exchange(this->Entries[this->Next % this->Entries.size()]);
      continue;
    }
    const auto brick = static_cast<std::uint32_t>(this->Next);
    for (int row = 0; row < CarvedBricks::Rows; ++row)
    {
      this->Bricks.SetRow(brick, row, CarvedBricks::WholeRow);
    }
    this->Bricks.MarkChanged(brick);
  }
  if (this->Next == this->Stop)
  {
    switch (this->Work)
    {
      case Kind::Undo:
        --this->Applied;
        this->AddVolume(-this->At(this->Applied).Volume);
        break;
      case Kind::Redo:
        this->AddVolume(this->At(this->Applied).Volume);
        ++this->Applied;
        break;
      case Kind::Reset:
        this->Volume.store(0.0, std::memory_order_relaxed);
        break;
      case Kind::None:
        break;
    }
    this->Work = Kind::None;
    this->Report();
  }
}

void RemovalJournal::Report() noexcept
{
  const bool hasOne = this->HasOpen && !this->IsTooLarge && this->Head > this->At(this->Last).Begin;
  this->Undoable.store(static_cast<std::size_t>(this->Applied - this->First) + (hasOne ? 1 : 0));
  this->Redoable.store(static_cast<std::size_t>(this->Last - this->Applied));
}

std::size_t RemovalJournal::GetMemorySize() const noexcept
{
  return sizeof(*this) + this->Entries.capacity() * sizeof(Entry) +
    this->Strokes.capacity() * sizeof(Stroke) + this->Stamps.capacity() * sizeof(std::uint32_t);
}

} // namespace VolumeHaptics
