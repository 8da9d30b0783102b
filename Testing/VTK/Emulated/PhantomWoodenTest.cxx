// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests an application in which a hand presses an emulated WoodenHaptics onto the phantom's face.
 */

#include "Emulators/EmulatedHid.h"
#include "Emulators/WoodenModel.h"
#include "OverflowRig.h"

using namespace emulated;

namespace
{
volatile std::sig_atomic_t HasOverflowed = 0;

class PhantomWooden : public testing::Test
{
protected:
  /**
   * Moves the hand to a position (m) beyond the skin, which is at x = 0 of the arm; negative
   * positions are in front of the face.
   */
  bool LeadTo(double beyond)
  {
    this->Arm.SetGoal({ -beyond, 0.0, 0.0 });
    return Eventually([&] { return std::abs(this->Arm.GetTip()[0] + beyond) < 0.5 * Slack; });
  }
  void CalibrateAndPress()
  {
    ASSERT_TRUE(this->Hand.WaitFor(vtkHapticDevice::HOMING)) << this->Device->GetStatusText();
    ASSERT_TRUE(this->Hand.Wait([&] { return this->Hand.Says("rest pose"); }));
    this->Device->Home();
    // A device that returns after a loss keeps its fault until it is armed.
    ASSERT_TRUE(this->Hand.Wait(
      [&]
      {
        return this->Device->GetStatus() == vtkHapticDevice::READY ||
          this->Hand.Says("is back. Arm() again");
      }))
      << this->Device->GetStatusText();
    this->Device->Arm();
    EXPECT_TRUE(this->Log.Errors.empty());
    const auto isFelt = [&]
    {
      this->Device->UpdateState();
      const double force = -this->Device->GetState()->GetForce()[1];
      const Triple shown = this->Arm.GetForce();
      const double spring = EmulatedHand::Stiffness * (Depth + this->Arm.GetTip()[0]);
      return force > 0.1 && std::abs(shown[0] - force) < 0.05 && std::abs(spring - force) < 0.1;
    };
    bool felt = false;
    // On a busy machine, the servo may pause, after which the force starts again from zero, so
    // retry.
    for (int attempt = 0; attempt < 5 && !felt; ++attempt)
    {
      ASSERT_TRUE(this->LeadTo(-0.01));
      this->Arm.SetGoal({ -Depth, 0.0, 0.0 });
      for (int i = 0; i < 2000 && !(felt = isFelt()); ++i)
      {
        this->Hand.WaitTicks(1);
      }
    }
    EXPECT_TRUE(felt) << this->Arm.GetForce()[0] << " N, told "
                      << this->Device->GetState()->GetForce()[1];
  }

  static constexpr double Depth = 0.006; // m, goal behind the skin
  static constexpr double Slack = 0.02;  // m, tolerance of the arm's position
  emulated::Phantom Phantom;
  WoodenModel Arm;
  EmulatedHid Hid{ this->Arm };
  PhantomHand Hand{ this->Phantom, 2, 1.0 };
  vtkHapticDevice* const Device = this->Hand.Device;
  apitest::MessageLog Log{ this->Device };
};
} // namespace

TEST_F(PhantomWooden, IsFeltLostAndFeltAgain)
{
  ASSERT_TRUE(this->Device->Open("wooden"));
  ASSERT_TRUE(this->Device->Start());
  for (int plugged = 0; plugged < 2; ++plugged)
  {
    ASSERT_NO_FATAL_FAILURE(this->CalibrateAndPress());
    EXPECT_TRUE(this->Hand.WaitTicks(5000));

    this->Hid.Unplug();
    EXPECT_TRUE(this->Hand.WaitFor(vtkHapticDevice::FAULT));
    EXPECT_TRUE(this->Hand.Says("unplugged")) << this->Device->GetStatusText();
    EXPECT_TRUE(this->Hand.WaitTicks(5));
    EXPECT_EQ(Length(this->Device->GetState()->GetForce()), 0.0);
    this->Arm.PowerUp();
    this->Hid.PlugIn();
    // The device is opened again automatically, and then waits for its rest pose.
    EXPECT_TRUE(this->Hand.WaitFor(vtkHapticDevice::HOMING)) << this->Device->GetStatusText();
    EXPECT_TRUE(this->Hand.WaitTicks(100));
    EXPECT_EQ(Length(this->Device->GetState()->GetForce()), 0.0);
  }
}

TEST_F(PhantomWooden, AStackThatOverflowsLeavesNoForce)
{
  // The handler that was installed before the device's handler ends only its own thread, so that
  // the test continues.
  struct sigaction end = {};
  end.sa_handler = [](int)
  {
    HasOverflowed = 1;
    syscall(SYS_exit, 0);
  };
  end.sa_flags = SA_ONSTACK;
  sigaction(SIGSEGV, &end, nullptr);
  std::signal(SIGTRAP, [](int) { std::_Exit(Overflow(0)); });
  const std::set<int> before = ListThreads();
  ASSERT_TRUE(this->Device->Open("wooden"));
  const int thread = FindNewThread(before);
  ASSERT_TRUE(this->Device->Start());
  ASSERT_NO_FATAL_FAILURE(this->CalibrateAndPress());
  ASSERT_GT(Length(this->Arm.GetForce().data()), 0.0);
  syscall(SYS_tgkill, getpid(), thread, SIGTRAP);
  ASSERT_TRUE(Eventually([] { return HasOverflowed != 0; }));
  // The device measures time in packets, so its watchdog can't end the force when the packets stop.
  EXPECT_TRUE(Eventually([this] { return Length(this->Arm.GetForce().data()) == 0.0; }))
    << Length(this->Arm.GetForce().data());
}
