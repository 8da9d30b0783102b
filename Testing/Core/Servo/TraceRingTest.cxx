// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that every value passes from one thread to another in order, and that values without room
 * are counted.
 */

#include "Core/Servo/TraceRing.h"
#include "Core/Realtime/SealedValue.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <thread>

using servotest::SealedReader;
using servotest::SealedValue;
using VolumeHaptics::TraceRing;

TEST(TraceRing, RoundsItsCapacityUpToAPowerOfTwo)
{
  EXPECT_EQ(TraceRing<int>(1).GetCapacity(), 1U);
  EXPECT_EQ(TraceRing<int>(2).GetCapacity(), 2U);
  EXPECT_EQ(TraceRing<int>(5).GetCapacity(), 8U);
  EXPECT_EQ(TraceRing<int>(64).GetCapacity(), 64U);
}

TEST(TraceRing, OfMegabytesBeginsWithALargePage)
{
  constexpr std::uintptr_t largePage = 2097152; // bytes
  const TraceRing<std::array<char, 1024>> ring(4096);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(ring.GetMemory()) % largePage, 0U);
  EXPECT_EQ(ring.GetMemorySize(), 4U << 20);
}

TEST(TraceRing, KeepsTheOrderAcrossManyWraps)
{
  TraceRing<int> ring(8);
  int in = 0;
  int out = 0;
  int value = -1;
  for (int round = 0; round < 100; ++round)
  {
    for (int i = 0; i < 1 + round % 8; ++i)
    {
      ASSERT_TRUE(ring.Push(in++));
    }
    while (ring.Pop(value))
    {
      EXPECT_EQ(value, out++);
    }
  }
  EXPECT_EQ(in, out);
  EXPECT_GT(in, 400);
  EXPECT_EQ(ring.GetLost(), 0U);
}

TEST(TraceRing, CountsWhatFindsItFullAndKeepsWhatIsIn)
{
  TraceRing<int> ring(4);
  int value = -1;
  EXPECT_FALSE(ring.Pop(value));
  EXPECT_EQ(value, -1);
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_TRUE(ring.Push(i));
  }
  for (int i = 4; i < 7; ++i)
  {
    EXPECT_FALSE(ring.Push(i));
  }
  EXPECT_EQ(ring.GetLost(), 3U);
  EXPECT_TRUE(ring.Pop(value));
  EXPECT_EQ(value, 0);
  EXPECT_TRUE(ring.Push(7)) << "one has been taken out";
  EXPECT_FALSE(ring.Push(8));
  EXPECT_EQ(ring.GetLost(), 4U);
  for (const int expected : { 1, 2, 3, 7 })
  {
    ASSERT_TRUE(ring.Pop(value));
    EXPECT_EQ(value, expected);
  }
  EXPECT_FALSE(ring.Pop(value));
}

TEST(TraceRing, AcrossThreadsNothingIsTornSwappedOrUncounted)
{
  constexpr std::uint64_t last = 200000;
  TraceRing<SealedValue> ring(64);
  std::thread producer(
    [&ring]
    {
      for (std::uint64_t i = 1; i <= last; ++i)
      {
        // Push the last value until it arrives, so that the consumer knows when to stop.
        while (!ring.Push(SealedValue(i)) && i == last)
        {
          std::this_thread::yield();
        }
        if (i % 32 == 0)
        {
          std::this_thread::yield();
        }
      }
    });
  SealedReader reader;
  SealedValue value;
  while (reader.Last < last)
  {
    if (!ring.Pop(value))
    {
      std::this_thread::yield();
      continue;
    }
    reader.Take(value);
  }
  producer.join();
  EXPECT_EQ(reader.Torn, 0U);
  EXPECT_EQ(reader.Backward, 0U);
  EXPECT_LE(reader.Taken, last);
  // The ring also counts failed attempts to push the last value as lost.
  EXPECT_GE(reader.Taken + ring.GetLost(), last);
}
