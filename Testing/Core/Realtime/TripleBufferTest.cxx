// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that the latest value passes completely from one thread to another.
 */

#include "Core/Realtime/TripleBuffer.h"
#include "SealedValue.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

using servotest::SealedReader;
using servotest::SealedValue;
using VolumeHaptics::TripleBuffer;

TEST(TripleBuffer, StartsWithTheDefaultAndNothingNew)
{
  TripleBuffer<int> buffer;
  EXPECT_FALSE(buffer.Update());
  EXPECT_EQ(buffer.Read(), 0);
}

TEST(TripleBuffer, HandsOverEachValueOnce)
{
  TripleBuffer<int> buffer;
  for (int i = 1; i < 20; ++i)
  {
    buffer.Write(i);
    EXPECT_TRUE(buffer.Update());
    EXPECT_EQ(buffer.Read(), i);
    EXPECT_FALSE(buffer.Update());
    EXPECT_EQ(buffer.Read(), i) << "the value stays readable";
  }
}

TEST(TripleBuffer, TheLatestWins)
{
  TripleBuffer<int> buffer;
  for (int burst = 1; burst < 12; ++burst)
  {
    for (int i = 1; i <= burst; ++i)
    {
      buffer.Write(100 * burst + i);
    }
    ASSERT_TRUE(buffer.Update());
    EXPECT_EQ(buffer.Read(), 101 * burst);
    EXPECT_FALSE(buffer.Update());
  }
}

TEST(TripleBuffer, WritingDoesNotDisturbWhatIsRead)
{
  TripleBuffer<int> buffer;
  buffer.Write(1);
  ASSERT_TRUE(buffer.Update());
  for (int i = 2; i < 10; ++i)
  {
    buffer.Write(i);
    EXPECT_EQ(buffer.Read(), 1);
  }
}

TEST(TripleBuffer, ValuesAreWholeAndInOrderAcrossThreads)
{
  constexpr std::uint64_t last = 200000;
  TripleBuffer<SealedValue> buffer;
  std::thread writer(
    [&buffer]
    {
      for (std::uint64_t i = 1; i <= last; ++i)
      {
        buffer.Write(SealedValue(i));
      }
    });
  SealedReader reader;
  while (reader.Last < last)
  {
    if (!buffer.Update())
    {
      std::this_thread::yield();
      continue;
    }
    reader.Take(buffer.Read());
  }
  writer.join();
  EXPECT_EQ(reader.Torn, 0U);
  EXPECT_EQ(reader.Backward, 0U);
  EXPECT_FALSE(buffer.Update());
}
