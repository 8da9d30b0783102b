// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Ends or stops an application that presses with a Falcon, in every possible way. The guard must
 * send zero force, and the force must stay zero: at once if the system reports the end, otherwise
 * after 50 ms of silence, which are 25 of the driver's idle rounds.
 */

#include "GuardProcesses.h"
#include "Rigs/FalconRig.h"

#include <algorithm>
#include <csignal>
#include <fstream>
#include <functional>
#include <iostream>
#include <random>
#include <utility>

#include <sched.h>

#if !defined(CLONE_NEWTIME)
#define CLONE_NEWTIME 0x80
#endif

using namespace emulated;

namespace
{
/**
 * Largest number of rounds with force after the end: 25 for 50 ms, and 25 more for a busy machine.
 */
constexpr long MostRounds = 50;

class FalconGuard : public FalconTest
{
protected:
  /** Moves the hand until the device presses at the centre of the workspace. */
  void BringToPress()
  {
    ASSERT_TRUE(Eventually([&] { return this->Falcon.GetPackets() > 10; }));
    if (!this->IsHomed) // a homed device presses as soon as its grip is out
    {
      this->LeadTo({ 0.0, 0.0, 0.1735 });
      this->LeadTo({ 0.0, 0.0, 0.08 });
      this->IsHomed = true;
    }
    // Move the grip to the rest position first: the force begins when the hand is far enough out,
    // and could prevent the hand from arriving.
    this->Falcon.SetAim(Rest);
    ASSERT_TRUE(this->Presses());
    this->Falcon.SetHeld(true);
    this->LeadTo(Middle);
    ASSERT_TRUE(this->Presses());
  }
  bool Presses()
  {
    return Eventually([&] { return AreClose(this->Falcon.GetForce(), { 0.0, 0.0, 2.0 }, 0.05); });
  }
  void MarkEnd()
  {
    this->End = this->Falcon.GetPackets();
    this->EndTime = std::chrono::steady_clock::now();
  }
  void ExpectZeroSoon(const char* way)
  {
    EXPECT_EQ(this->Falcon.GetCommands(), Numbers{});
    const auto last = this->Falcon.GetLastPush();
    const std::chrono::duration<double, std::milli> time = last.second - this->EndTime;
    std::cout << way << ": the last force came " << last.first - this->End << " rounds, "
              << time.count() << " ms after the end\n";
    EXPECT_LE(last.first - this->End, MostRounds);
  }
  bool LetsGo()
  {
    return Eventually([&] { return !this->Usb.IsClaimed(); });
  }
  bool IsHomed = false;
  long End = 0; ///< number of packets when the application ended
  std::chrono::steady_clock::time_point EndTime;
};

class FalconGuardOutlives
  : public FalconGuard
  , public testing::WithParamInterface<const char*>
{
};
} // namespace

TEST_P(FalconGuardOutlives, AnApplicationThatEnds)
{
  GuardedProgram application(this->GetParam());
  ASSERT_NO_FATAL_FAILURE(this->BringToPress());
  application.Tell();
  EXPECT_NE(application.Wait(), 2);
  this->MarkEnd();
  EXPECT_TRUE(this->LetsGo());
  this->ExpectZeroSoon(this->GetParam());
}
INSTANTIATE_TEST_SUITE_P(, FalconGuardOutlives,
  testing::Values("abort", "crash", "exception", "quick_exit", "_exit", "fork"),
  [](const auto& info) { return std::string(info.param); });

TEST_F(FalconGuard, OutlivesAnApplicationThatIsKilled)
{
  GuardedProgram application("");
  ASSERT_NO_FATAL_FAILURE(this->BringToPress());
  application.Signal(SIGKILL);
  EXPECT_EQ(application.Wait(), -SIGKILL);
  this->MarkEnd();
  EXPECT_TRUE(this->LetsGo());
  this->ExpectZeroSoon("SIGKILL");
}

/**
 * Kills applications one after another at random times: before the guard starts, during homing, or
 * under force (half of them).
 */
class FalconGuardKills
  : public FalconGuard
  , public testing::WithParamInterface<std::pair<const char*, int>>
{
};

TEST_P(FalconGuardKills, EndInZeroEachTime)
{
  std::mt19937 random(static_cast<unsigned>(std::hash<std::string>()(this->GetParam().first)));
  long most = 0;
  for (int i = 0; i < this->GetParam().second; ++i)
  {
    SCOPED_TRACE(i);
    const bool mustPress = random() % 2 == 0;
    const long start = this->Falcon.GetPackets();
    const long rounds = static_cast<long>(random() % 60);
    GuardedProgram application("");
    if (mustPress)
    {
      ASSERT_TRUE(Eventually([&] { return this->Falcon.GetPackets() > start; }));
      ASSERT_NO_FATAL_FAILURE(this->BringToPress());
      const long pressed = this->Falcon.GetPackets();
      ASSERT_TRUE(Eventually([&] { return this->Falcon.GetPackets() >= pressed + rounds; }));
    }
    else if (rounds > 5) // after fewer rounds, the application is killed at its start
    {
      ASSERT_TRUE(Eventually([&] { return this->Falcon.GetPackets() >= start + rounds; }));
    }
    application.Signal(SIGKILL);
    ASSERT_EQ(application.Wait(), -SIGKILL);
    this->MarkEnd();
    ASSERT_TRUE(Eventually([] { return FindGuard() == 0; })) << "the guard ends, too";
    ASSERT_TRUE(this->LetsGo());
    ASSERT_EQ(this->Falcon.GetCommands(), Numbers{});
    const long late = this->Falcon.GetLastPush().first - this->End;
    most = mustPress ? std::max(most, late) : most;
    ASSERT_LE(late, MostRounds);
  }
  std::cout << this->GetParam().second << " killed; the last force came at most " << most
            << " rounds after the end\n";
}
INSTANTIATE_TEST_SUITE_P(, FalconGuardKills,
  testing::Values(std::pair("Few", 20), std::pair("Many0", 100), std::pair("Many1", 100),
    std::pair("Many2", 100), std::pair("Many3", 100), std::pair("Many4", 100),
    std::pair("Many5", 100), std::pair("Many6", 100), std::pair("Many7", 100),
    std::pair("Many8", 100), std::pair("Many9", 100)),
  [](const auto& info) { return std::string(info.param.first); });

/// The guard must use the application's clock. With another clock, it would detect too late that
/// the application has stopped.
class FalconGuardsClock
  : public FalconGuard
  , public testing::WithParamInterface<int>
{
};

TEST_P(FalconGuardsClock, IsThatOfTheApplication)
{
  // A time namespace affects only child processes. Creating one needs privileges, and some kernels
  // don't support it.
  std::ofstream offsets;
  if (unshare(CLONE_NEWTIME) == 0)
  {
    offsets.open("/proc/self/timens_offsets");
    offsets << "monotonic " << this->GetParam() << " 0\n" << std::flush;
  }
  if (!offsets.is_open() || !offsets)
  {
    GTEST_SKIP() << "no time namespaces here";
  }
  EXPECT_FALSE(this->Open());
  EXPECT_TRUE(Has(this->Error, "another clock")) << this->Error;
  EXPECT_TRUE(Has(this->Error, "time namespace")) << this->Error;
  EXPECT_EQ(FindGuard(), 0);
  EXPECT_FALSE(this->Usb.IsClaimed());
}
INSTANTIATE_TEST_SUITE_P(, FalconGuardsClock, testing::Values(-100, 100),
  [](const auto& info) { return info.param < 0 ? "Behind" : "Ahead"; });

TEST_F(FalconGuard, OutlivesAnApplicationThatBecomesAnotherProgram)
{
  GuardedProgram application("exec");
  ASSERT_NO_FATAL_FAILURE(this->BringToPress());
  application.Tell();
  EXPECT_TRUE(Eventually([&] { return application.GetProgram() == "sleep"; }));
  this->MarkEnd();
  EXPECT_TRUE(this->LetsGo());
  this->ExpectZeroSoon("exec");
}

TEST_F(FalconGuard, WatchesAnApplicationThatIsStopped)
{
  GuardedProgram application("");
  ASSERT_NO_FATAL_FAILURE(this->BringToPress());
  for (int again = 0; again < 3; ++again)
  {
    application.Signal(SIGSTOP);
    this->MarkEnd();
    EXPECT_TRUE(Eventually([&] { return this->Falcon.GetPackets() > this->End + 2 * MostRounds; }));
    this->ExpectZeroSoon("SIGSTOP");
    this->Falcon.DrainLargestCommand();
    EXPECT_TRUE(Eventually([&] { return this->Falcon.GetPackets() > this->End + 4 * MostRounds; }));
    EXPECT_EQ(this->Falcon.DrainLargestCommand(), 0.0) << "it stays, and is renewed";
    application.Signal(SIGCONT);
    EXPECT_TRUE(this->Presses()) << "the application goes on, and so does its force";
  }
}
