// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Carving/CarvedBricks.h"

#include <algorithm>

namespace VolumeHaptics
{

CarvedBricks::CarvedBricks(std::uint32_t most)
  : Most(std::max<std::uint32_t>(most, 1))
{
  int bits = 1;
  while ((std::uint64_t{ 1 } << bits) < 2 * std::uint64_t{ this->Most })
  {
    ++bits;
  }
  const std::size_t slots = std::size_t{ 1 } << bits;
  this->SlotMask = slots - 1;
  this->SlotShift = 64 - bits;
  this->Slots.reset(new std::atomic<std::uint32_t>[slots]);
  std::for_each(this->Slots.get(), this->Slots.get() + slots,
    [](auto& slot) { slot.store(None, std::memory_order_relaxed); });
  this->Keys.reset(new std::uint64_t[this->Most]());
  const std::size_t rows = std::size_t{ this->Most } * Rows;
  this->Fractions.reset(new std::atomic<std::uint64_t>[rows]);
  std::for_each(this->Fractions.get(), this->Fractions.get() + rows,
    [](auto& row) { row.store(WholeRow, std::memory_order_relaxed); });
  const std::size_t words = this->Most / BricksOfWord + 1;
  this->Changed.reset(new std::atomic<std::uint64_t>[words]);
  std::for_each(this->Changed.get(), this->Changed.get() + words,
    [](auto& word) { word.store(0, std::memory_order_relaxed); });
}

std::uint8_t CarvedBricks::GetFraction(
  std::int64_t i, std::int64_t j, std::int64_t k) const noexcept
{
  const std::uint32_t brick = this->Find(KeyOf({ i >> Shift, j >> Shift, k >> Shift }));
  if (brick == None)
  {
    return Whole;
  }
  const auto row = static_cast<int>((j & (Side - 1)) + Side * (k & (Side - 1)));
  return static_cast<std::uint8_t>(this->GetRow(brick, row) >> (8 * (i & (Side - 1))));
}

bool CarvedBricks::HasBricks(const std::int64_t* low, const std::int64_t* high) const noexcept
{
  for (std::int64_t z = low[2] >> Shift; z <= high[2] >> Shift; ++z)
  {
    for (std::int64_t y = low[1] >> Shift; y <= high[1] >> Shift; ++y)
    {
      for (std::int64_t x = low[0] >> Shift; x <= high[0] >> Shift; ++x)
      {
        if (this->Find(KeyOf({ x, y, z })) != None)
        {
          return true;
        }
      }
    }
  }
  return false;
}

bool CarvedBricks::IsWhole(std::uint32_t brick) const noexcept
{
  auto* const begin = this->Fractions.get() + RowAt(brick, 0);
  return std::all_of(begin, begin + Rows,
    [](const auto& row) { return row.load(std::memory_order_relaxed) == WholeRow; });
}

bool CarvedBricks::IsWhole() const noexcept
{
  const std::uint32_t count = this->GetCount();
  std::uint32_t brick = 0;
  while (brick < count && this->IsWhole(brick))
  {
    ++brick;
  }
  return brick == count;
}

std::uint32_t CarvedBricks::FindOrAdd(std::uint64_t key) noexcept
{
  std::uint64_t slot = this->SlotOf(key);
  for (;; slot = (slot + 1) & this->SlotMask)
  {
    const std::uint32_t brick = this->Slots[slot].load(std::memory_order_relaxed);
    if (brick == None)
    {
      break;
    }
    if (this->Keys[brick] == key)
    {
      return brick;
    }
  }
  const std::uint32_t brick = this->Count.load(std::memory_order_relaxed);
  if (brick == this->Most)
  {
    return None;
  }
  this->Keys[brick] = key;
  this->Slots[slot].store(brick, std::memory_order_release);
  this->Count.store(brick + 1, std::memory_order_release);
  return brick;
}

int CarvedBricks::AddFollower(int keptFree) noexcept
{
  std::uint32_t all = this->Followers.load(std::memory_order_relaxed);
  int follower = 0;
  do
  {
    int free = 0;
    for (int i = MostFollowers - 1; i >= 0; --i)
    {
      const bool isFree = (all >> i & 1) == 0;
      follower = isFree ? i : follower;
      free += isFree ? 1 : 0;
    }
    if (free <= keptFree)
    {
      return -1;
    }
  } while (!this->Followers.compare_exchange_weak(
    all, all | 1U << follower, std::memory_order_acq_rel, std::memory_order_relaxed));
  // Marks the bricks that exist now. Bricks that are added later are marked when they are written.
  const std::uint32_t count = this->GetCount();
  for (std::uint32_t brick = 0; brick < count; ++brick)
  {
    this->Changed[brick / BricksOfWord].fetch_or(
      std::uint64_t{ 1 } << (MostFollowers * (brick % BricksOfWord) + follower),
      std::memory_order_acquire);
  }
  return follower;
}

std::size_t CarvedBricks::GetMemorySize() const noexcept
{
  const std::size_t bricks = this->Most;
  return sizeof(*this) + (this->SlotMask + 1) * sizeof(std::uint32_t) +
    bricks * (Rows + 1) * sizeof(std::uint64_t) +
    (bricks / BricksOfWord + 1) * sizeof(std::uint64_t);
}

} // namespace VolumeHaptics
