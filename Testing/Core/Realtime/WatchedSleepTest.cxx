// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that a sleeper whose processor does not wake it up is woken up on another processor, and
 * that nothing else of the sleeper changes. The tests read from the kernel on which processors a
 * thread runs and may run.
 */

#include "Core/Realtime/WatchedSleep.h"
#include "Core/Realtime/ServoClock.h"
#include "Rigs/Processors.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <sched.h>
#include <thread>

using namespace VolumeHaptics;

namespace
{

constexpr std::int64_t Second = 1000000000;

cpu_set_t GetProcessors()
{
  cpu_set_t processors;
  EXPECT_EQ(sched_getaffinity(0, sizeof(processors), &processors), 0);
  return processors;
}

bool MayRunOn(const cpu_set_t& processors)
{
  const cpu_set_t now = GetProcessors();
  return CPU_EQUAL(&now, &processors);
}

/// Runs the watching thread until the object is destroyed. The thread starts on the given
/// processor, or on any processor (-1).
class Watcher
{
public:
  explicit Watcher(WatchedSleep& sleep, int processor = -1)
    : Sleep(sleep)
    , Thread(
        [this, processor]
        {
          if (processor >= 0)
          {
            const cpu_set_t one = Only(processor);
            EXPECT_EQ(sched_setaffinity(0, sizeof(one), &one), 0);
          }
          this->Sleep.Watch();
        })
  {
  }
  ~Watcher()
  {
    this->Sleep.RequestStop();
    this->Thread.join();
  }

  static cpu_set_t Only(int processor)
  {
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(processor, &one);
    return one;
  }

private:
  WatchedSleep& Sleep;
  std::thread Thread;
};

/// Tests that need two processors, and a kernel that lets a thread choose its processor.
class WatchedSleepElsewhere : public testing::Test
{
protected:
  void SetUp() override
  {
    if (!devicetest::MayChooseProcessor(this->Before))
    {
      GTEST_SKIP() << "This process can't choose among processors.";
    }
  }
  void TearDown() override { sched_setaffinity(0, sizeof(this->Before), &this->Before); }

  cpu_set_t Before{};
};

} // namespace

TEST_F(WatchedSleepElsewhere, EndsOnAnotherProcessor)
{
  WatchedSleep sleep(ServoClock::Millisecond);
  constexpr int times = 20;
  int changes = 0;
  {
    const Watcher watcher(sleep);
    for (int i = 0; i < times; ++i)
    {
      const int processor = sched_getcpu();
      const std::int64_t planned = ServoClock::Now() + 5 * ServoClock::Millisecond;
      sleep.SleepUntil(planned, planned + 30 * Second); // 30 s late, like a lost timer
      const std::int64_t end = ServoClock::Now();
      ASSERT_TRUE(MayRunOn(this->Before));
      ASSERT_GE(end, planned);
      ASSERT_LT(end, planned + 20 * Second);
      changes += sched_getcpu() == processor ? 0 : 1;
    }
  }
  // It is enough if half of the rescues succeed: on a busy machine, the kernel may move the thread,
  // or the thread may fall asleep late.
  EXPECT_GE(sleep.GetRescues(), static_cast<std::uint64_t>(times / 2));
  EXPECT_GE(changes, times / 2);
}

TEST_F(WatchedSleepElsewhere, IsNotShortenedByAHastyWatcher)
{
  WatchedSleep sleep(2); // the watcher waits for only 1 of 2 ns
  {
    const Watcher watcher(sleep);
    for (int i = 0; i < 3000; ++i)
    {
      const std::int64_t planned = ServoClock::Now() + 20000 + 100 * (i % 1000);
      sleep.SleepUntil(planned);
      ASSERT_GE(ServoClock::Now(), planned);
    }
  }
  EXPECT_TRUE(MayRunOn(this->Before));
}

TEST_F(WatchedSleepElsewhere, LeavesABoundThreadWhereItIs)
{
  const int processor = sched_getcpu();
  const cpu_set_t one = Watcher::Only(processor);
  ASSERT_EQ(sched_setaffinity(0, sizeof(one), &one), 0);
  int other = 0;
  while (other == processor || !CPU_ISSET(other, &this->Before))
  {
    ++other;
  }
  WatchedSleep sleep(ServoClock::Millisecond);
  const Watcher watcher(sleep, other);
  const std::int64_t planned = ServoClock::Now() + 20 * ServoClock::Millisecond;
  const std::int64_t alarm = planned + 100 * ServoClock::Millisecond;
  sleep.SleepUntil(planned, alarm);
  EXPECT_GE(ServoClock::Now(), alarm);
  EXPECT_EQ(sleep.GetRescues(), 0u);
  EXPECT_TRUE(MayRunOn(one));
}

TEST(WatchedSleep, EndsByItselfWithoutAWatcher)
{
  WatchedSleep sleep(ServoClock::Millisecond);
  const std::int64_t planned = ServoClock::Now() + 2 * ServoClock::Millisecond;
  sleep.SleepUntil(planned);
  EXPECT_GE(ServoClock::Now(), planned);
  sleep.SleepUntil(planned - Second); // a time in the past
  EXPECT_LT(ServoClock::Now(), planned + 60 * Second);
}

TEST(WatchedSleep, DoesNotHoldTheWatcherUp)
{
  WatchedSleep sleep(ServoClock::Millisecond);
  std::atomic<bool> isOver{ false };
  std::thread sleeper(
    [&]
    {
      sleep.SleepUntil(ServoClock::Now() + 2 * Second);
      isOver.store(true);
    });
  {
    const Watcher watcher(sleep);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  EXPECT_FALSE(isOver.load());
  sleeper.join();
}
