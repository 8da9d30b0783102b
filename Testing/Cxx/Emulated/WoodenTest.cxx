// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A session with a WoodenHaptics: from plugging it in to feeling a floor, and again after it was unplugged.
 */

#include "HidRig.h"
#include "WoodenModel.h"

#include <gtest/gtest.h>

using namespace emulated;

namespace
{
constexpr double Height = -0.01; ///< m, of the floor

class Wooden : public testing::Test
{
protected:
  /// Calibrates, arms, and leads the hand to the floor's middle, 10 mm inside.
  void Feel()
  {
    ASSERT_TRUE(this->Bench.WaitForText("rest pose")) << this->Bench.Text();
    EXPECT_EQ(this->Bench.Device->GetCondition().Stage, DeviceStage::Homing);
    this->Bench.Start(this->Ground.Model);
    this->Bench.Device->Home();
    ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
    ASSERT_TRUE(this->Bench.WaitForTicks(20));
    this->Bench->Arm();
    this->Model.SetGoal({ 0.0, 0.0, Height + 0.005 });
    ASSERT_TRUE(Eventually([&] { return this->Model.GetTip()[2] < Height + 0.006; }));
    this->Model.SetGoal({ 0.0, 0.0, Height - 0.01 });
    EXPECT_TRUE(this->Settles(1.0)) << this->Model.GetForce()[2];
  }
  /// The floor holds against a hand that is led 10 mm inside.
  bool Settles(double part)
  {
    const double force = part * FloorStiffness * BalancedDepth(0.01);
    return Eventually([&] { return IsNear(this->Model.GetForce(), { 0.0, 0.0, force }, 0.05); });
  }

  WoodenModel Model;
  EmulatedHid Hid{ this->Model, 0 };
  Floor Ground{ Height };
  HidBench Bench;
};
} // namespace

TEST_F(Wooden, FromPluggingInToFeelingAgain)
{
  const std::vector<DeviceListing> all = ListDevices();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].Id, "wooden:0");
  EXPECT_EQ(all[0].Name, "Emulated PolhemHaptics (/dev/hidraw0)");
  EXPECT_EQ(all[0].State, "available");
  ASSERT_TRUE(this->Bench.Open("wooden")) << this->Bench.Error;
  EXPECT_EQ(this->Bench.Device->GetLimits().MaximumForce, 5.0);
  EXPECT_EQ(ListDevices()[0].State, "in use");
  ASSERT_NO_FATAL_FAILURE(this->Feel());
  EXPECT_EQ(this->Model.GetPresets(), 1);

  // It slides: friction holds the hand back.
  this->Bench->SetRecording(true);
  this->Model.SetGoal({ 0.0, 0.03, Height - 0.01 });
  EXPECT_TRUE(Eventually([&] { return this->Model.GetTip()[1] > 0.027; }));
  int sliding = 0;
  double slowest = 0.0;
  ServoSnapshot s;
  while (this->Bench->Drain(s))
  {
    if (s.Record.Contact == ContactState::Sliding)
    {
      ++sliding;
      EXPECT_LE(std::abs(s.Record.Force.Y), Friction * s.Record.Force.Z + 1e-3);
      slowest = std::min(slowest, s.Record.Force.Y / s.Record.Force.Z);
    }
  }
  EXPECT_GT(sliding, 20);
  EXPECT_NEAR(slowest, -Friction, 0.01);
  EXPECT_TRUE(this->Bench.WaitForTicks(5000));
  EXPECT_LT(this->Model.GetForce()[1], 0.0);

  // Unplugged in contact: cut, said, and nothing resumes by itself.
  this->Hid.Unplug();
  EXPECT_TRUE(this->Bench.WaitForFault(SafetyFault::DeviceLost));
  EXPECT_TRUE(this->Bench.WaitForText("was unplugged. Plug it in, then Open() and Start() it."));
  EXPECT_TRUE(ListDevices().empty());
  this->Bench.Device->Home();
  EXPECT_TRUE(this->Bench.WaitForTicks(50));
  EXPECT_TRUE(this->Bench.WaitFor(DeviceStage::Lost));
  this->Bench.Stop();

  this->Model.PowerUp();
  this->Hid.PlugIn();
  ASSERT_TRUE(this->Bench.Reopen()) << this->Bench.Error;
  ASSERT_NO_FATAL_FAILURE(this->Feel());
  this->Bench.Stop();
  this->Bench.Device->Close();
  EXPECT_EQ(Size(this->Model.GetForce()), 0.0);
  EXPECT_EQ(this->Model.GetLastPacket(), std::vector<std::uint8_t>(15, 0));
}
