// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Carving/TissueSnapshot.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

void CopyBrick(const CarvedBricks& bricks, std::uint32_t brick, BrickTissue& to) noexcept
{
  to.Key = bricks.GetKey(brick);
  for (int row = 0; row < CarvedBricks::Rows; ++row)
  {
    to.Rows[static_cast<std::size_t>(row)] = bricks.GetRow(brick, row);
  }
}

} // namespace

std::vector<BrickTissue> CopyBricks(const CarvedBricks& bricks)
{
  std::vector<BrickTissue> all;
  const std::uint32_t count = bricks.GetCount();
  for (std::uint32_t brick = 0; brick < count; ++brick)
  {
    if (!bricks.IsWhole(brick))
    {
      all.emplace_back();
      CopyBrick(bricks, brick, all.back());
    }
  }
  return all;
}

bool WriteBricks(const std::vector<BrickTissue>& fractions, CarvedBricks& bricks) noexcept
{
  return std::all_of(fractions.begin(), fractions.end(),
    [&bricks](const BrickTissue& from)
    {
      const std::uint32_t brick = bricks.FindOrAdd(from.Key);
      if (brick == CarvedBricks::None)
      {
        return false;
      }
      for (int row = 0; row < CarvedBricks::Rows; ++row)
      {
        bricks.SetRow(brick, row, from.Rows[static_cast<std::size_t>(row)]);
      }
      bricks.MarkChanged(brick);
      return true;
    });
}

TissueSnapshot::TissueSnapshot(CarvedBricks& bricks)
  : Bricks(bricks)
  , Follower(bricks.AddFollower())
  , Changes(MostLate)
{
  if (this->Follower < 0)
  {
    this->State.store(Late);
    return;
  }
  bricks.DrainChanged(this->Follower,
    [&](std::uint32_t brick)
    {
      if (brick >= this->Copies.size())
      {
        this->Copies.resize(brick + 1);
      }
      CopyBrick(bricks, brick, this->Copies[brick]);
    });
}

TissueSnapshot::~TissueSnapshot()
{
  if (this->Follower >= 0)
  {
    this->Bricks.RemoveFollower(this->Follower);
  }
}

bool TissueSnapshot::Complete() noexcept
{
  if (this->State.load(std::memory_order_relaxed) != Open)
  {
    return false;
  }
  bool isLate = false;
  this->Bricks.DrainChanged(this->Follower,
    [&](std::uint32_t brick)
    {
      isLate = this->Count == this->Changes.size();
      if (!isLate)
      {
        Change& change = this->Changes[this->Count++];
        change.Brick = brick;
        CopyBrick(this->Bricks, brick, change.Fractions);
      }
    });
  this->State.store(isLate ? Late : Done, std::memory_order_release);
  return !isLate;
}

std::vector<BrickTissue> TissueSnapshot::Collect() const
{
  std::vector<BrickTissue> all;
  if (this->State.load(std::memory_order_acquire) != Done)
  {
    return all;
  }
  all = this->Copies;
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    const Change& change = this->Changes[i];
    all.resize(std::max<std::size_t>(all.size(), change.Brick + std::size_t{ 1 }));
    all[change.Brick] = change.Fractions;
  }
  return all;
}

} // namespace VolumeHaptics
