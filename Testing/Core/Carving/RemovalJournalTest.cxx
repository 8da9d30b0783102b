// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Compares undo, redo and reset with copies of all fractions after each stroke.
 */

#include "Core/Carving/TissueRemoval.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <vector>

using namespace VolumeHaptics;

namespace
{
using Shares = std::map<std::uint64_t, std::vector<std::uint64_t>>;

/// Returns all bricks from which something was removed.
Shares ReadBricks(const CarvedBricks& bricks)
{
  Shares shares;
  for (std::uint32_t brick = 0; brick < bricks.GetCount(); ++brick)
  {
    std::vector<std::uint64_t> rows;
    bool isWhole = true;
    for (int row = 0; row < CarvedBricks::Rows; ++row)
    {
      rows.push_back(bricks.GetRow(brick, row));
      isWhole = isWhole && rows.back() == CarvedBricks::WholeRow;
    }
    if (!isWhole)
    {
      shares[bricks.GetKey(brick)] = rows;
    }
  }
  return shares;
}

/// Makes random changes to random bricks.
class Strokes
{
public:
  explicit Strokes(TissueRemoval& removal)
    : Removal(removal)
  {
  }

  void Do(std::uint64_t bricks)
  {
    this->Removal.Journal.Begin();
    for (std::uint64_t n = 0; n < bricks; ++n)
    {
      this->Change(this->Engine() % 200);
    }
    this->Removal.Journal.End();
  }
  void Change(std::uint64_t key)
  {
    const std::uint32_t brick = this->Removal.Bricks.FindOrAdd(key);
    this->Removal.Journal.Keep(brick);
    const auto row = static_cast<int>(this->Engine() % CarvedBricks::Rows);
    this->Removal.Bricks.SetRow(brick, row, this->Engine());
    this->Removal.Bricks.MarkChanged(brick);
  }
  bool Serve(RemovalRequest request)
  {
    const Shares before = ReadBricks(this->Removal.Bricks);
    EXPECT_TRUE(this->Removal.Request(request));
    int ticks = 0;
    while (this->Removal.Serve())
    {
      ++ticks;
    }
    EXPECT_LE(ticks, 200 / 32 + 1);
    EXPECT_GE(ticks, 1);
    EXPECT_EQ(this->Removal.GetPending(), 0u);
    return ReadBricks(this->Removal.Bricks) != before;
  }

  std::mt19937_64 Engine{ 8 };

private:
  TissueRemoval& Removal;
};
} // namespace

TEST(RemovalJournal, UndoesAndRedoesToTheBit)
{
  TissueRemoval removal(256, 4000);
  Strokes strokes(removal);
  std::vector<Shares> history = { {} };
  std::size_t at = 0;
  for (int n = 0; n < 400; ++n)
  {
    const auto dice = strokes.Engine() % 5;
    if (dice < 2)
    {
      history.resize(at + 1);
      strokes.Do(1 + strokes.Engine() % 100);
      history.push_back(ReadBricks(removal.Bricks));
      ++at;
    }
    else if (dice < 4)
    {
      const bool canUndo = removal.Journal.GetUndoable() > 0;
      EXPECT_EQ(strokes.Serve(RemovalRequest::Undo), canUndo);
      at -= canUndo ? 1 : 0;
    }
    else
    {
      const bool canRedo = removal.Journal.GetRedoable() > 0;
      EXPECT_EQ(canRedo, at + 1 < history.size());
      EXPECT_EQ(strokes.Serve(RemovalRequest::Redo), canRedo);
      at += canRedo ? 1 : 0;
    }
    ASSERT_EQ(ReadBricks(removal.Bricks), history[at]);
  }
}

TEST(RemovalJournal, ForgetsTheOldestStrokesFirst)
{
  TissueRemoval removal(256, 100);
  Strokes strokes(removal);
  std::vector<Shares> history;
  for (int n = 0; n < 10; ++n)
  {
    history.push_back(ReadBricks(removal.Bricks));
    removal.Journal.Begin();
    for (std::uint64_t key = 0; key < 30; ++key)
    {
      strokes.Change(key);
    }
    removal.Journal.End();
  }
  EXPECT_EQ(removal.Journal.GetUndoable(), 3u) << "three times 30 bricks";
  for (std::size_t n = 1; n <= 3; ++n)
  {
    EXPECT_TRUE(strokes.Serve(RemovalRequest::Undo));
    EXPECT_EQ(ReadBricks(removal.Bricks), history[10 - n]);
  }
  EXPECT_FALSE(strokes.Serve(RemovalRequest::Undo));
  EXPECT_EQ(ReadBricks(removal.Bricks), history[7]);
}

TEST(RemovalJournal, AStrokeThatIsLargerThanItCannotBeUndone)
{
  TissueRemoval removal(256, 20);
  Strokes strokes(removal);
  strokes.Do(5);
  removal.Journal.Begin();
  for (std::uint64_t key = 0; key < 30; ++key)
  {
    strokes.Change(key);
  }
  removal.Journal.End();
  EXPECT_EQ(removal.Journal.GetUndoable(), 0u);
  EXPECT_FALSE(strokes.Serve(RemovalRequest::Undo));
  const Shares before = ReadBricks(removal.Bricks);
  strokes.Do(5);
  EXPECT_EQ(removal.Journal.GetUndoable(), 1u);
  EXPECT_TRUE(strokes.Serve(RemovalRequest::Undo));
  EXPECT_EQ(ReadBricks(removal.Bricks), before);
}

TEST(RemovalJournal, KeepsSoManyStrokes)
{
  TissueRemoval removal(256, 4000);
  Strokes strokes(removal);
  std::vector<Shares> history;
  for (int n = 0; n < 300; ++n)
  {
    history.push_back(ReadBricks(removal.Bricks));
    strokes.Do(1);
  }
  EXPECT_EQ(removal.Journal.GetUndoable(), RemovalJournal::MostStrokes);
  for (std::size_t n = 1; n <= RemovalJournal::MostStrokes; ++n)
  {
    EXPECT_TRUE(strokes.Serve(RemovalRequest::Undo));
    ASSERT_EQ(ReadBricks(removal.Bricks), history[300 - n]);
  }
  EXPECT_FALSE(strokes.Serve(RemovalRequest::Undo));
}

TEST(RemovalJournal, AResetBringsAllTissueBack)
{
  TissueRemoval removal(256, 4000);
  Strokes strokes(removal);
  EXPECT_FALSE(strokes.Serve(RemovalRequest::Reset)) << "there is nothing to bring back";
  strokes.Do(150);
  strokes.Do(150);
  EXPECT_TRUE(strokes.Serve(RemovalRequest::Undo));
  EXPECT_TRUE(strokes.Serve(RemovalRequest::Reset));
  EXPECT_TRUE(ReadBricks(removal.Bricks).empty());
  EXPECT_EQ(removal.Journal.GetUndoable(), 0u);
  EXPECT_EQ(removal.Journal.GetRedoable(), 0u);
  strokes.Do(10);
  EXPECT_TRUE(strokes.Serve(RemovalRequest::Undo));
  EXPECT_TRUE(ReadBricks(removal.Bricks).empty());
}

TEST(RemovalJournal, AnOpenStrokeIsUndoneAsAWhole)
{
  TissueRemoval removal(256, 4000);
  Strokes strokes(removal);
  removal.Journal.Begin();
  strokes.Change(3);
  strokes.Change(5);
  EXPECT_TRUE(removal.Journal.IsOpen());
  EXPECT_TRUE(strokes.Serve(RemovalRequest::Undo));
  EXPECT_TRUE(ReadBricks(removal.Bricks).empty());
  EXPECT_FALSE(removal.Journal.IsOpen());
}

TEST(RemovalJournal, RequestsWaitInTheirOrder)
{
  TissueRemoval removal(256, 4000);
  Strokes strokes(removal);
  strokes.Do(40);
  const Shares first = ReadBricks(removal.Bricks);
  strokes.Do(40);
  using Request = RemovalRequest;
  for (const Request request : { Request::Undo, Request::Undo, Request::Redo })
  {
    EXPECT_TRUE(removal.Request(request));
  }
  EXPECT_EQ(removal.GetPending(), 3u);
  while (removal.Serve())
  {
  }
  EXPECT_EQ(ReadBricks(removal.Bricks), first);
  int accepted = 0;
  while (removal.Request(Request::Redo))
  {
    ASSERT_LT(++accepted, 1000) << "there is an end to those that wait";
  }
  EXPECT_GE(accepted, 16);
}
