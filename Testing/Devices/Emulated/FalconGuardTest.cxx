// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * An application that presses with a Falcon dies, or is stopped, in every way: the guard sends
 * zero, and it stays. An end that the system tells counts at once; silence counts after 50 ms,
 * which are 25 of the driver's idle rounds.
 */

#include "GuardProcesses.h"
#include "Rigs/FalconRig.h"

#include <csignal>
#include <iostream>

using namespace emulated;

namespace
{
/** Rounds with force after the end: those of 50 ms, and as many for a busy machine. */
constexpr long MostRounds = 50;

class FalconGuard : public FalconTest
{
protected:
  /** Until it presses, in the middle of the workspace. */
  void BringToPress()
  {
    ASSERT_TRUE(Eventually([&] { return this->Falcon.GetPackets() > 10; }));
    this->LeadTo({ 0.0, 0.0, 0.1735 });
    this->LeadTo({ 0.0, 0.0, 0.08 });
    // It presses as soon as it is out far enough, which may keep it from arriving.
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
  long End = 0; ///< packets at the end of the application
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
