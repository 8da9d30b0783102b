// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests sessions with a guarded DualSense through hidapi, by cable and by Bluetooth: contact makes
 * it vibrate, and the motors stop whenever the program ends.
 */

#include "DeviceBench.h"
#include "Emulators/DualSenseModel.h"
#include "Emulators/EmulatedEvdev.h"
#include "Emulators/EmulatedHid.h"
#include "Emulators/ModelClock.h"
#include "GuardProcesses.h"

#include <gtest/gtest.h>

#include <csignal>

using namespace emulated;

namespace
{
constexpr int RightY = 3; ///< the model's axis of the right stick

class DualSenses : public testing::TestWithParam<bool>
{
protected:
  void Begin() { this->Bench.Begin("vibration:pad", this->Ground.Model); }
  void PressUntilFelt()
  {
    this->Model.Move(RightY, 0);
    EXPECT_TRUE(Eventually([&] { return !this->Model.IsStill(); }));
  }
  /// Sends changing forces until the motors run.
  void Shake(DeviceBackend& device)
  {
    for (int i = 0; i < 20000 && this->Model.IsStill(); ++i)
    {
      DeviceSample sample;
      device.Read(1e-3, sample);
      device.Write({ 0.0, 0.0, i / 40 % 2 == 0 ? 2.0 : -2.0 });
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_FALSE(this->Model.IsStill());
  }

  DualSenseModel Model{ GetParam(), 0x0215 };
  EmulatedHid Hid{ this->Model };
  ModelClock Clock{ [this] { this->Model.Step(); } };
  Floor Ground{ -0.02 };
  DeviceBench Bench;
};
} // namespace

TEST_P(DualSenses, ContactIsFeltAndRestIsSilent)
{
  const std::vector<DeviceListing> all = ListDevices();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].Id, "vibration:pad:0");
  EXPECT_TRUE(Has(all[0].Name, "DualSense Wireless Controller")) << all[0].Name;
  EXPECT_TRUE(Has(all[0].Name, ": vibration, not force")) << all[0].Name;
  EXPECT_EQ(all[0].State, "available");
  this->Begin();
  EXPECT_TRUE(Has(this->Bench.Device->GetName(), "vibration, not force"));
  EXPECT_EQ(ListDevices()[0].State, "in use");
  this->PressUntilFelt();
  EXPECT_TRUE(Eventually([&] { return Norm(this->Bench.State().Command) > 1.5; }));
  this->Model.Move(RightY, 128);
  EXPECT_TRUE(Eventually([&] { return this->Model.IsStill(); }));
  EXPECT_GT(this->Model.DrainLargest().Right, 70) << "the weak motor";
  EXPECT_TRUE(this->Bench.WaitForTicks(200));
  EXPECT_GT(Norm(this->Bench.State().Command), 1.0) << "the force is still there";
  EXPECT_TRUE(this->Model.IsStill());
  this->Model.Press(0, 0x20);
  EXPECT_TRUE(Eventually([&] { return this->Bench.State().Buttons == 1; })) << "the cross";
  this->Model.Move(0, 255);
  EXPECT_TRUE(Eventually([&] { return this->Bench.State().Record.Tip.X > 0.02; }));
  EXPECT_EQ(this->Model.BadReports, 0);
  EXPECT_EQ(this->Bench.State().GetFault(), GateReason::None);
}

TEST_P(DualSenses, ClosingItStopsTheMotors)
{
  this->Begin();
  this->PressUntilFelt();
  this->Bench.Stop();
  this->Bench.Device->Close();
  EXPECT_TRUE(this->Model.IsStill());
  ASSERT_TRUE(this->Bench.Reopen()) << this->Bench.Error;
  EXPECT_TRUE(this->Bench.WaitFor(DeviceStage::Ready));
}

TEST_P(DualSenses, FaultsAreSilenceAndAText)
{
  this->Begin();
  this->PressUntilFelt();
  this->Model.IsSilent = true;
  this->Bench.ExpectLost("no longer reports. Check its cable or battery");
  EXPECT_TRUE(Eventually([&] { return this->Model.IsStill(); }));
  this->Model.IsSilent = false;
  this->Bench.Device->Home();
  EXPECT_TRUE(this->Bench.WaitFor(DeviceStage::Ready));
  this->Hid.Unplug();
  this->Bench.ExpectLost("was unplugged.");
  this->Hid.PlugIn();
  this->Bench.ExpectBack();
  EXPECT_TRUE(this->Model.IsStill());
}

TEST_P(DualSenses, AProgramThatStandsStillIsSilent)
{
  ASSERT_TRUE(this->Bench.Open("vibration:pad")) << this->Bench.Error;
  ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready));
  this->Shake(*this->Bench.Device);
  // Without further forces, the force fades, and the vibration ends.
  EXPECT_TRUE(Eventually([&] { return this->Model.IsStill(); }));
}

TEST_P(DualSenses, AGuardThatIsKilledLeavesNoVibration)
{
  ASSERT_TRUE(this->Bench.Open("vibration:pad")) << this->Bench.Error;
  ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready));
  this->Shake(*this->Bench.Device);
  const pid_t guard = FindGuard();
  ASSERT_GT(guard, 1);
  kill(guard, SIGKILL);
  EXPECT_TRUE(this->Bench.WaitFor(DeviceStage::Lost));
  EXPECT_TRUE(Eventually([&] { return this->Model.IsStill(); }))
    << "this program says so in its place";
  EXPECT_TRUE(this->Bench.WaitForText("guard process")) << this->Bench.Text();
}

TEST_P(DualSenses, AProgramThatIsKilledLeavesNoVibration)
{
  for (const char* const way : { "_exit", "crash", "kill" })
  {
    GuardedProgram program(way, "vibration:pad");
    EXPECT_TRUE(Eventually([&] { return !this->Model.IsStill(); })) << way;
    std::string(way) == "kill" ? program.Signal(SIGKILL) : program.Tell();
    program.Wait();
    EXPECT_TRUE(Eventually([&] { return this->Model.IsStill(); })) << way;
    EXPECT_TRUE(Eventually([] { return ListDevices()[0].State == "available"; })) << way;
  }
}

INSTANTIATE_TEST_SUITE_P(CableAndBluetooth, DualSenses, testing::Bool());

TEST(DualSenseModels, OlderFirmwareAndTheEdgeAreFeltToo)
{
  for (const bool isEdge : { false, true })
  {
    DualSenseModel model(false, 0x0100, isEdge);
    const EmulatedHid hid(model);
    const ModelClock clock([&model] { model.Step(); });
    const Floor ground(-0.005);
    DeviceBench bench;
    DeviceOptions options;
    options.UseGuard = false;
    ASSERT_TRUE(bench.Open("vibration:pad:0", options)) << bench.Error;
    bench.Start(ground.Model);
    ASSERT_TRUE(bench.WaitForTicks(20));
    bench->Arm();
    model.Move(RightY, 0);
    EXPECT_TRUE(Eventually([&] { return model.GetMotors().Right > 20; }));
    EXPECT_EQ(model.BadReports, 0);
  }
}

TEST(DualSenseModels, ReportsThatRadioSpoilsAreAFaultIfTheyGoOn)
{
  DualSenseModel model(true, 0x0215);
  const EmulatedHid hid(model);
  const ModelClock clock([&model] { model.Step(); });
  DeviceBench bench;
  ASSERT_TRUE(bench.Open("vibration:pad")) << bench.Error;
  ASSERT_TRUE(bench.WaitFor(DeviceStage::Ready));
  model.IsSpoilt = true;
  EXPECT_TRUE(bench.WaitForText("sent a report with a wrong checksum, again and again"))
    << bench.Text();
  EXPECT_EQ(bench.Device->GetCondition().Stage, DeviceStage::Lost);
}

TEST(DualSenseModels, OneThatSaysNothingIsRefused)
{
  DualSenseModel model(false, 0x0215);
  model.IsSilent = true;
  const EmulatedHid hid(model);
  EXPECT_TRUE(
    Has(ErrorOf("vibration:pad"), "sends no reports that are known. Press its PS button"));
}

TEST(DualSenseModels, OneThatTheKernelMakesVibrateIsListedOnce)
{
  DualSenseModel model(false, 0x0215);
  const EmulatedHid hid(model);
  PadModel pad(PadModel::Kind::PlayStation);
  const EmulatedEvdev evdev(pad);
  const std::vector<DeviceListing> all = ListDevices();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_TRUE(Has(all[0].Name, evdev.GetNode().c_str())) << all[0].Name;
}
