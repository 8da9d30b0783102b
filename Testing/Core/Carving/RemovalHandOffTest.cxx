// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Removes tissue in one thread, while another thread follows the removal without a lock, and
 * requests undo and redo. The test also runs under the thread sanitizer.
 */

#include "Core/Carving/TissueRemoval.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <map>
#include <random>
#include <thread>

using namespace VolumeHaptics;

namespace
{
using Rows = std::array<std::uint64_t, CarvedBricks::Rows>;

Rows CopyRows(const CarvedBricks& bricks, std::uint32_t brick)
{
  Rows rows;
  for (int row = 0; row < CarvedBricks::Rows; ++row)
  {
    rows[row] = bricks.GetRow(brick, row);
  }
  return rows;
}

/// The rows of each brick as the reader has last seen them, by the brick's key.
using Mirror = std::map<std::uint64_t, Rows>;

void Follow(CarvedBricks& bricks, int follower, Mirror& mirror)
{
  bricks.DrainChanged(
    follower, [&](std::uint32_t brick) { mirror[bricks.GetKey(brick)] = CopyRows(bricks, brick); });
}
} // namespace

TEST(RemovalHandOff, AReaderMissesNoChange)
{
  TissueRemoval removal(500, 300);
  std::atomic<bool> isDone{ false };
  std::thread servo(
    [&]()
    {
      std::mt19937_64 engine(2);
      for (int tick = 0; tick < 4000; ++tick)
      {
        if (removal.Serve())
        {
          continue;
        }
        if (tick % 50 == 0)
        {
          removal.Journal.Begin();
        }
        const std::uint32_t brick = removal.Bricks.FindOrAdd(engine() % 600);
        if (brick == CarvedBricks::None)
        {
          removal.SetUsedUp(true);
          continue;
        }
        removal.Journal.Keep(brick);
        for (int n = 0; n < 8; ++n)
        {
          const auto row = static_cast<int>(engine() % CarvedBricks::Rows);
          removal.Bricks.SetRow(brick, row, removal.Bricks.GetRow(brick, row) & engine());
        }
        removal.Bricks.MarkChanged(brick);
      }
      isDone = true;
    });
  Mirror mirror;
  Mirror late;
  const int first = removal.Bricks.AddFollower();
  int second = -1;
  std::mt19937_64 engine(3);
  int asked = 0;
  while (!isDone)
  {
    Follow(removal.Bricks, first, mirror);
    if (second < 0 && removal.Bricks.GetCount() > 50)
    {
      second = removal.Bricks.AddFollower();
    }
    // Any thread may read a fraction.
    const std::uint8_t fraction =
      removal.Bricks.GetFraction(static_cast<std::int64_t>(engine() % 4000), 0, 0);
    EXPECT_LE(fraction, CarvedBricks::Whole);
    EXPECT_LE(removal.Journal.GetUndoable(), RemovalJournal::MostStrokes);
    const auto dice = engine() % 1000;
    if (dice < 3)
    {
      asked += removal.Request(static_cast<RemovalRequest>(dice + 1)) ? 1 : 0;
    }
  }
  servo.join();
  EXPECT_GT(removal.Bricks.GetCount(), 100u);
  Follow(removal.Bricks, first, mirror);
  second = second < 0 ? removal.Bricks.AddFollower() : second;
  Follow(removal.Bricks, second, late);
  EXPECT_EQ(late, mirror);
  EXPECT_EQ(mirror.size(), removal.Bricks.GetCount());
  for (std::uint32_t brick = 0; brick < removal.Bricks.GetCount(); ++brick)
  {
    ASSERT_EQ(mirror[removal.Bricks.GetKey(brick)], CopyRows(removal.Bricks, brick));
  }
  EXPECT_TRUE(!removal.IsUsedUp() || removal.Bricks.GetCount() == removal.Bricks.GetMost());
}

/// A snapshot that the servo completes shows one tick, although another thread copies most of it.
TEST(RemovalHandOff, ASnapshotIsOfOneTick)
{
  TissueRemoval removal(500, 300);
  std::atomic<bool> isWanted{ false };
  std::atomic<bool> isTaken{ false };
  std::atomic<bool> isDone{ false };
  Mirror expected;
  std::thread servo(
    [&]()
    {
      std::mt19937_64 engine(7);
      while (!isDone)
      {
        if (isWanted.exchange(false) && removal.TakeSnapshot())
        {
          for (std::uint32_t brick = 0; brick < removal.Bricks.GetCount(); ++brick)
          {
            expected[removal.Bricks.GetKey(brick)] = CopyRows(removal.Bricks, brick);
          }
          isTaken = true;
        }
        const std::uint32_t brick = removal.Bricks.FindOrAdd(engine() % 500);
        removal.Journal.Keep(brick);
        for (int row = 0; row < CarvedBricks::Rows; ++row)
        {
          removal.Bricks.SetRow(brick, row, removal.Bricks.GetRow(brick, row) - engine() % 3);
        }
        removal.Bricks.MarkChanged(brick);
      }
    });
  while (removal.Bricks.GetCount() < 100)
  {
    std::this_thread::yield();
  }
  removal.BeginSnapshot();
  isWanted = true;
  while (!isTaken)
  {
    std::this_thread::yield();
  }
  std::map<std::uint64_t, Rows> taken;
  for (const BrickTissue& brick : removal.EndSnapshot())
  {
    Rows& rows = taken[brick.Key];
    std::copy(brick.Rows.begin(), brick.Rows.end(), rows.begin());
  }
  isDone = true;
  servo.join();
  EXPECT_GE(taken.size(), 100u);
  EXPECT_EQ(taken, expected);
}
