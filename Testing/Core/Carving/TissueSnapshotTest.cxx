// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests copies of the fractions at one tick, in one thread. RemovalHandOffTest tests them with two
 * threads.
 */

#include "Core/Carving/TissueRemoval.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

using namespace VolumeHaptics;

namespace
{
using KeptTissue = std::map<std::uint64_t, std::array<std::uint64_t, CarvedBricks::Rows>>;

void ChangeKept(TissueRemoval& removal, std::uint64_t key, std::uint64_t fractions)
{
  const std::uint32_t brick = removal.Bricks.FindOrAdd(key);
  ASSERT_NE(brick, CarvedBricks::None);
  removal.Journal.Keep(brick);
  removal.Bricks.SetRow(brick, static_cast<int>(key % CarvedBricks::Rows), fractions);
  removal.Bricks.MarkChanged(brick);
}

KeptTissue ReadKept(const CarvedBricks& bricks)
{
  KeptTissue all;
  for (std::uint32_t brick = 0; brick < bricks.GetCount(); ++brick)
  {
    for (int row = 0; row < CarvedBricks::Rows; ++row)
    {
      all[bricks.GetKey(brick)][static_cast<std::size_t>(row)] = bricks.GetRow(brick, row);
    }
  }
  return all;
}

KeptTissue EndKept(TissueRemoval& removal)
{
  KeptTissue all;
  for (const BrickTissue& brick : removal.EndSnapshot())
  {
    all[brick.Key] = brick.Rows;
  }
  return all;
}
} // namespace

TEST(TissueSnapshot, HasWhatWasRemovedUntilItIsTaken)
{
  TissueRemoval removal;
  std::mt19937_64 engine(5);
  for (std::uint64_t i = 0; i < 400; ++i)
  {
    ChangeKept(removal, engine() % 300, i);
  }
  EXPECT_FALSE(removal.TakeSnapshot()) << "none was begun";
  removal.BeginSnapshot();
  for (std::uint64_t i = 0; i < 100; ++i)
  {
    ChangeKept(removal, engine() % 400, i);
  }
  const KeptTissue expected = ReadKept(removal.Bricks);
  EXPECT_TRUE(removal.TakeSnapshot());
  EXPECT_FALSE(removal.TakeSnapshot()) << "it is complete";
  ChangeKept(removal, 7, 0);
  EXPECT_EQ(EndKept(removal), expected);
  EXPECT_TRUE(EndKept(removal).empty()) << "it has ended";
}

TEST(TissueSnapshot, HasWholeBricksInTheirOrder)
{
  TissueRemoval removal;
  ChangeKept(removal, 3, 0);
  ChangeKept(removal, 4, CarvedBricks::WholeRow);
  removal.BeginSnapshot();
  ASSERT_TRUE(removal.TakeSnapshot());
  const std::vector<BrickTissue> fractions = removal.EndSnapshot();
  ASSERT_EQ(fractions.size(), 2u);
  EXPECT_EQ(fractions[0].Key, 3u);
  EXPECT_EQ(fractions[1].Key, 4u);
  const std::vector<BrickTissue> used = CopyBricks(removal.Bricks);
  ASSERT_EQ(used.size(), 1u);
  EXPECT_EQ(used[0].Key, 3u);
  EXPECT_FALSE(removal.Bricks.IsWhole());
}

TEST(TissueSnapshot, EndsTheStrokesThatCanBeUndone)
{
  TissueRemoval removal;
  for (std::uint64_t key = 0; key < 3; ++key)
  {
    removal.Journal.Begin();
    ChangeKept(removal, key, 5);
  }
  removal.Journal.End();
  ASSERT_TRUE(removal.Request(RemovalRequest::Undo));
  removal.BeginSnapshot();
  RemovalRequest begun = RemovalRequest::None;
  ASSERT_TRUE(removal.Serve(&begun));
  EXPECT_EQ(begun, RemovalRequest::Undo);
  removal.Journal.Begin();
  ChangeKept(removal, 9, 8);
  ASSERT_TRUE(removal.TakeSnapshot());
  EXPECT_EQ(removal.Journal.GetUndoable(), 0u);
  EXPECT_EQ(removal.Journal.GetRedoable(), 0u);
  EXPECT_FALSE(removal.Journal.IsOpen());
  const KeptTissue before = EndKept(removal);
  removal.Journal.Begin();
  ChangeKept(removal, 10, 8);
  EXPECT_TRUE(removal.Request(RemovalRequest::Undo));
  EXPECT_TRUE(removal.Request(RemovalRequest::Undo));
  while (removal.Serve(&begun))
  {
  }
  removal.BeginSnapshot();
  ASSERT_TRUE(removal.TakeSnapshot());
  KeptTissue after = EndKept(removal);
  for (const std::uint64_t row : after[10])
  {
    EXPECT_EQ(row, CarvedBricks::WholeRow);
  }
  after.erase(10);
  EXPECT_EQ(after, before) << "only the stroke after it is undone";
}

TEST(TissueSnapshot, WaitsForTheEndOfARequest)
{
  TissueRemoval removal;
  removal.Journal.Begin();
  for (std::uint64_t key = 0; key < 100; ++key)
  {
    ChangeKept(removal, key, 1);
  }
  removal.Journal.End();
  ASSERT_TRUE(removal.Request(RemovalRequest::Undo));
  ASSERT_TRUE(removal.Serve());
  removal.BeginSnapshot();
  int refused = 0;
  for (; !removal.TakeSnapshot(); ++refused)
  {
    ASSERT_TRUE(removal.Serve());
  }
  EXPECT_GT(refused, 0);
  EXPECT_EQ(EndKept(removal), ReadKept(removal.Bricks));
  EXPECT_TRUE(removal.Bricks.IsWhole()) << "all tissue is back";
}

TEST(TissueSnapshot, ThatIsTooLateIsBegunAgain)
{
  TissueRemoval removal;
  removal.BeginSnapshot();
  for (std::uint64_t key = 0; key <= TissueSnapshot::MostLate; ++key)
  {
    ChangeKept(removal, key, 1);
  }
  EXPECT_FALSE(removal.IsSnapshotLate());
  EXPECT_FALSE(removal.TakeSnapshot());
  EXPECT_TRUE(removal.IsSnapshotLate());
  EXPECT_TRUE(EndKept(removal).empty());
  removal.BeginSnapshot();
  EXPECT_TRUE(removal.TakeSnapshot());
  EXPECT_EQ(EndKept(removal), ReadKept(removal.Bricks));
}
