// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests in simulated time how host and device take turns. As on a serial line, the device answers
 * all packets in order: each answer arrives a round after its packet, and a round after the
 * previous answer. The device has the faults that libnifalcon/libnifalcon (commit f7c727a) handles:
 * an answer that arrives only after the next packet was sent (isFirmwareLoaded() in
 * src/core/FalconFirmware.cpp), and a missing answer.
 */

#include "Devices/Falcon/FalconTurns.h"

#include <gtest/gtest.h>

#include <deque>
#include <random>

using namespace VolumeHaptics;

namespace
{
constexpr std::int64_t Microsecond = 1000;
constexpr std::int64_t Round = 1000 * Microsecond;

class FalconTakesTurns : public testing::Test
{
protected:
  /** Advances the time by 10 us. The servo writes a force every `period`. */
  void Step(std::int64_t period)
  {
    this->Now += 10 * Microsecond;
    int reports = 0;
    while (!this->Line.empty() && this->Line.front().Time <= this->Now)
    {
      this->Answered = this->Line.front().Packet;
      this->Line.pop_front();
      ++reports;
    }
    if (reports > 0)
    {
      this->Turns.Answered(this->Now, reports);
    }
    this->Misses += this->Turns.CheckMissed(this->Now, false) ? 1 : 0;
    this->IsWoken = this->IsWoken || this->Now % period == 0;
    if (this->IsWoken && this->Turns.MaySend(this->Now))
    {
      this->IsWoken = false;
      this->Send();
    }
  }
  void Send()
  {
    this->Behind = this->Packet - this->Answered;
    this->Turns.Sent(this->Now);
    ++this->Packet;
    const std::int64_t before = this->Line.empty() ? this->Now : this->Line.back().Time;
    if (this->Held > 0)
    {
      this->Line.push_back({ this->Held, before + Round });
      this->Held = 0;
    }
    if (this->IsLate)
    {
      this->Held = this->Packet;
    }
    else if (!this->IsSilent)
    {
      const std::int64_t last = this->Line.empty() ? this->Now : this->Line.back().Time;
      this->Line.push_back({ this->Packet, last + Round });
    }
    this->IsLate = this->IsSilent = false;
  }
  void Run(std::int64_t period, int packets)
  {
    for (const int end = this->Packet + packets; this->Packet < end;)
    {
      this->Step(period);
    }
  }

  struct Answer
  {
    int Packet;
    std::int64_t Time;
  };
  FalconTurns Turns;
  std::deque<Answer> Line;
  std::int64_t Now = 0;
  int Packet = 0;
  int Answered = 0;
  int Behind = 0; ///< number of missing answers when the last packet was sent
  int Held = 0;
  int Misses = 0;
  bool IsWoken = false;
  bool IsLate = false;
  bool IsSilent = false;
};

class FalconTakesTurnsAt
  : public FalconTakesTurns
  , public testing::WithParamInterface<int>
{
protected:
  std::int64_t GetPeriod() const { return this->GetParam() * Microsecond; }
};
} // namespace

TEST_P(FalconTakesTurnsAt, OneAfterTheOther)
{
  this->Run(this->GetPeriod(), 1000);
  EXPECT_EQ(this->Behind, 0);
  EXPECT_EQ(this->Misses, 0);
}

TEST_P(FalconTakesTurnsAt, ALateAnswerLeavesNoneBehind)
{
  for (int again = 0; again < 20; ++again)
  {
    this->Run(this->GetPeriod(), 10 + again);
    this->IsLate = true;
    this->Run(this->GetPeriod(), 2);
    EXPECT_EQ(this->Misses, again + 1);
    // While an answer is missing, only one more packet is sent.
    this->Run(this->GetPeriod(), 1);
    for (int i = 0; i < 20; ++i)
    {
      this->Run(this->GetPeriod(), 1);
      EXPECT_EQ(this->Behind, 0) << i;
    }
  }
}

TEST_P(FalconTakesTurnsAt, AnAnswerThatNeverComesCostsATime)
{
  for (int again = 0; again < 20; ++again)
  {
    this->Run(this->GetPeriod(), 10 + again);
    this->IsSilent = true;
    this->Run(this->GetPeriod(), 3);
    EXPECT_EQ(this->Misses, again + 1);
    const std::int64_t before = this->Now;
    this->Run(this->GetPeriod(), 5);
    EXPECT_EQ(this->Behind, 0);
    EXPECT_LT(
      this->Now - before, 3 * FalconTurns::SilentTime + 8 * std::max(Round, this->GetPeriod()));
  }
}

TEST_P(FalconTakesTurnsAt, WhateverComesTheyEndInStep)
{
  std::mt19937 random(5);
  for (int again = 0; again < 1000; ++again)
  {
    int faults = 0;
    for (int i = 0; i < 8; ++i)
    {
      // Make at most two consecutive faults. After more faults, the host can't distinguish a late
      // answer from a lost one.
      const auto fault = random() % 5;
      faults = fault < 2 && faults < 2 ? faults + 1 : 0;
      this->IsLate = faults > 0 && fault == 0;
      this->IsSilent = faults > 0 && fault == 1;
      this->Run(this->GetPeriod(), 1);
    }
    this->Run(this->GetPeriod(), 5);
    EXPECT_EQ(this->Behind, 0) << again;
  }
}

INSTANTIATE_TEST_SUITE_P(, FalconTakesTurnsAt, testing::Values(250, 500, 1000, 1500, 3000));

TEST(FalconTurns, AStuckTransferIsMissedAgainAndAgain)
{
  FalconTurns turns;
  turns.Sent(0);
  int misses = 0;
  for (std::int64_t now = 0; now < 10 * FalconTurns::AnswerTime + 1; now += Round)
  {
    EXPECT_GE(turns.GetDeadline() + Round, now);
    misses += turns.CheckMissed(now, true) ? 1 : 0;
  }
  EXPECT_EQ(misses, 10);
}

TEST(FalconTurns, AFailedTransferIsNotWaitedFor)
{
  FalconTurns turns;
  turns.Sent(0);
  EXPECT_FALSE(turns.MaySend(1));
  turns.Abandon();
  EXPECT_TRUE(turns.MaySend(1));
  EXPECT_FALSE(turns.CheckMissed(1, false));
  turns.Answered(2, 1); // an answer without an unanswered packet
  EXPECT_TRUE(turns.MaySend(2));
}
