// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that a servo without privileges asks RealtimeKit, and that no answer does harm.
 *
 * played_rtkit.py simulates the service on the test's own bus. It was written from rtkit's
 * published interface. The test reads the results from the kernel.
 */

#include "Core/Realtime/RealtimeKit.h"
#include "Core/Realtime/ServoPriority.h"
#include "Rigs/PlayedDevice.h"
#include "Rigs/PlayedRealtimeKit.h"

#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/utsname.h>
#include <unistd.h>

using namespace servotest;
using RealtimeKit::Answer;

namespace
{

using Lines = std::vector<std::string>;

rlim_t HardTimeLimit()
{
  rlimit limit{};
  EXPECT_EQ(getrlimit(RLIMIT_RTTIME, &limit), 0);
  return limit.rlim_max;
}

/// Runs each test in a separate process, so that the test may change its limits and environment.
class RealtimeKitService : public testing::Test
{
protected:
  void SetUp() override
  {
    if (const char* const missing = this->Bus.DetectMissing())
    {
      GTEST_SKIP() << missing;
    }
  }

  Answer Ask() { return this->Ask(ThisThread()); }
  Answer Ask(std::int64_t thread)
  {
    return RealtimeKit::MakeRealTime(thread, RealtimeKit::ReadEnvironment(), this->Stop);
  }

  PlayedBus Bus;
  std::atomic<bool> Stop{ false };
};

} // namespace

TEST_F(RealtimeKitService, GetsItsThreadThePriorityAndTheLimitThatItTold)
{
  PlayedRealtimeKit service({ "--time", "150000", "--priority", "17" });
  ASSERT_TRUE(service.IsThere());
  EXPECT_EQ(this->Ask(), Answer::Granted);
  const Lines expected{ "Get org.freedesktop.RealtimeKit1 RTTimeUSecMax",
    "Get org.freedesktop.RealtimeKit1 MaxRealtimePriority",
    "MakeThreadRealtime " + std::to_string(ThisThread()) + " 17", "granted" };
  EXPECT_EQ(service.ReadCalls(), expected);
  EXPECT_EQ(HardTimeLimit(), 150000U);
  rlimit limit{};
  getrlimit(RLIMIT_RTTIME, &limit);
  EXPECT_LT(limit.rlim_cur, limit.rlim_max) << "SIGXCPU comes before SIGKILL";
}

TEST_F(RealtimeKitService, KeepsALimitThatIsLower)
{
  const rlimit limit{ 40000, 90000 };
  ASSERT_EQ(setrlimit(RLIMIT_RTTIME, &limit), 0);
  PlayedRealtimeKit service;
  EXPECT_EQ(this->Ask(), Answer::Granted);
  EXPECT_EQ(HardTimeLimit(), 90000U);
}

TEST_F(RealtimeKitService, StaysBelowTheKernelsInterruptThreads)
{
  PlayedRealtimeKit service({ "--priority", "90" });
  EXPECT_EQ(this->Ask(), Answer::Granted);
  EXPECT_EQ(
    service.ReadCalls().at(2), "MakeThreadRealtime " + std::to_string(ThisThread()) + " 40");
}

TEST_F(RealtimeKitService, MayRefuse)
{
  PlayedRealtimeKit service({ "--refuse" });
  EXPECT_EQ(this->Ask(), Answer::Refused);
  EXPECT_EQ(service.ReadCalls().back(), "refused");
}

TEST_F(RealtimeKitService, DoesNotGetAThreadOfAnotherProcess)
{
  PlayedRealtimeKit service;
  EXPECT_EQ(this->Ask(getppid()), Answer::Refused);
  EXPECT_EQ(service.ReadCalls().back(), "refused");
}

TEST_F(RealtimeKitService, IsNotAskedIfItsNumbersAreOfNoUse)
{
  const rlim_t before = HardTimeLimit();
  for (const Lines& options : { Lines{ "--time", "1000" }, Lines{ "--time", "-1" },
         Lines{ "--priority", "0" }, Lines{ "--priority", "-5" }, Lines{ "--words" } })
  {
    PlayedRealtimeKit service(options);
    ASSERT_TRUE(service.IsThere());
    EXPECT_EQ(this->Ask(), Answer::Refused);
    const Lines calls = service.ReadCalls();
    EXPECT_EQ(calls.size(), 2U) << "properties, and no call";
    EXPECT_EQ(HardTimeLimit(), before) << "a limit that nothing is given for";
  }
}

TEST_F(RealtimeKitService, MayBeAbsent)
{
  const rlim_t before = HardTimeLimit();
  EXPECT_EQ(this->Ask(), Answer::Absent);
  EXPECT_EQ(HardTimeLimit(), before);
}

TEST_F(RealtimeKitService, IsNotAskedIfTheUserDoesNotWantIt)
{
  PlayedRealtimeKit service;
  setenv("VOLUMEHAPTICS_RTKIT", "off", 1);
  EXPECT_EQ(this->Ask(), Answer::Absent);
  EXPECT_EQ(service.ReadCalls(), Lines());
}

TEST_F(RealtimeKitService, MayEndWhileItIsAsked)
{
  for (const char* const method : { "Get", "MakeThreadRealtime" })
  {
    PlayedRealtimeKit service({ "--die", method });
    ASSERT_TRUE(service.IsThere());
    EXPECT_EQ(this->Ask(), Answer::Refused);
  }
}

TEST_F(RealtimeKitService, NoBusAnswers)
{
  for (const char* const address : { "unix:path=/nonexistent/socket", "", "junk", "unix:" })
  {
    setenv("DBUS_SYSTEM_BUS_ADDRESS", address, 1);
    EXPECT_EQ(this->Ask(), Answer::Absent) << address;
  }
}

TEST_F(RealtimeKitService, TheBusMayEndWhileTheServiceIsAsked)
{
  PlayedRealtimeKit service({ "--silent", "MakeThreadRealtime" });
  ASSERT_TRUE(service.IsThere());
  std::atomic<Answer> answer{ Answer::Granted };
  std::thread asking([&] { answer = this->Ask(); });
  service.ReadCall();
  service.ReadCall();
  EXPECT_EQ(service.ReadCall().rfind("MakeThreadRealtime", 0), 0U);
  this->Bus.Kill();
  asking.join();
  EXPECT_EQ(answer.load(), Answer::Refused);
}

// If the request were not stopped, the client would read the next property after the refusal.
TEST_F(RealtimeKitService, IsAskedNothingMoreAfterAStop)
{
  PlayedRealtimeKit service({ "--silent", "Get" });
  ASSERT_TRUE(service.IsThere());
  std::thread asking([&] { EXPECT_EQ(this->Ask(), Answer::Refused); });
  EXPECT_NE(service.ReadCall(), "");
  this->Stop = true;
  asking.join();
  EXPECT_EQ(service.ReadCalls(), Lines());
}

TEST_F(RealtimeKitService, GivesALoopWithoutPrivilegesItsPriority)
{
  ASSERT_TRUE(AllowPriority(0));
  PlayedRealtimeKit service;
  ASSERT_TRUE(service.IsThere());
  PlayedDevice device;
  ServoLoop loop(device, 1000.0);
  EXPECT_EQ(loop.GetRealTimePriority(), RealTimeGrant::Unknown);
  std::thread asking([&] { loop.AskRealtimeKit(); });
  std::atomic<std::int64_t> thread{ 0 };
  std::thread running(
    [&]
    {
      DropPrivileges();
      thread = ThisThread();
      loop.Run();
    });
  asking.join();
  EXPECT_EQ(loop.GetRealTimePriority(), RealTimeGrant::RealtimeKit);
  EXPECT_EQ(
    service.ReadCalls().at(2), "MakeThreadRealtime " + std::to_string(thread.load()) + " 20");
  loop.RequestStop();
  running.join();
}

TEST_F(RealtimeKitService, IsMissedByALoopWithoutPrivileges)
{
  ASSERT_TRUE(AllowPriority(0));
  ServoPriority priority;
  std::thread(
    [&]
    {
      DropPrivileges();
      priority.Raise();
    })
    .join();
  EXPECT_EQ(priority.GetGrant(), RealTimeGrant::Asked);
  priority.AskRealtimeKit();
  EXPECT_EQ(priority.GetGrant(), RealTimeGrant::NoService);
}

TEST_F(RealtimeKitService, IsAskedAsTheEnvironmentWasWhenTheServoWasMade)
{
  ASSERT_TRUE(AllowPriority(0));
  PlayedRealtimeKit service;
  ASSERT_TRUE(service.IsThere());
  setenv("VOLUMEHAPTICS_RTKIT", "off", 1);
  ServoPriority priority;
  unsetenv("VOLUMEHAPTICS_RTKIT");
  std::thread(
    [&]
    {
      DropPrivileges();
      priority.Raise();
    })
    .join();
  priority.AskRealtimeKit();
  EXPECT_EQ(priority.GetGrant(), RealTimeGrant::NoService);
  EXPECT_EQ(service.ReadCalls(), Lines());
}

TEST(ServoPriority, DoesNotWaitForALoopThatNeverBegins)
{
  ServoPriority priority;
  std::thread asking([&] { priority.AskRealtimeKit(); });
  priority.RequestStop();
  asking.join();
  EXPECT_EQ(priority.GetGrant(), RealTimeGrant::Unknown);
}

TEST(ServoPriority, TakesWhatNeedsNoPrivilege)
{
  ASSERT_TRUE(AllowPriority(0));
  std::thread(
    []
    {
      DropPrivileges();
      EXPECT_FALSE(ServoPriority::RaiseThread());
      EXPECT_EQ(prctl(PR_GET_TIMERSLACK), 1);
      int policy = -1;
      sched_param parameters{};
      EXPECT_EQ(pthread_getschedparam(pthread_self(), &policy, &parameters), 0);
      EXPECT_EQ(policy, SCHED_OTHER);
      // The slice is the fifth number of struct sched_attr (linux/sched/types.h), 24 bytes from the
      // beginning.
      std::uint64_t attributes[6] = {};
      ASSERT_EQ(syscall(SYS_sched_getattr, 0, attributes, sizeof(attributes), 0), 0);
      utsname kernel{};
      uname(&kernel);
      int version = 0;
      int patch = 0;
      ASSERT_EQ(std::sscanf(kernel.release, "%d.%d", &version, &patch), 2);
      if (version > 6 || (version == 6 && patch >= 12))
      {
        EXPECT_EQ(attributes[3], 100000U);
      }
    })
    .join();
}

TEST(ServoPriority, TakesTheClassThatTheUsersLimitAllows)
{
  if (!AllowPriority(7))
  {
    GTEST_SKIP() << "this user can't raise the limit";
  }
  std::thread(
    []
    {
      DropPrivileges();
      int policy = -1;
      sched_param parameters{};
      parameters.sched_priority = 1;
      if (pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) != 0)
      {
        GTEST_SKIP() << "this system gives real-time classes to no one";
      }
      EXPECT_TRUE(ServoPriority::RaiseThread());
      EXPECT_EQ(pthread_getschedparam(pthread_self(), &policy, &parameters), 0);
      EXPECT_EQ(policy, SCHED_FIFO);
      EXPECT_EQ(parameters.sched_priority, 7);
    })
    .join();
}
