// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the plug-in for OpenHaptics in closed loop: a hand presses on a floor. The library is a
 * stand-in that follows the toolkit's public documentation
 * (Emulators/OpenHaptics/FakeOpenHaptics.h): axes point right, up, and towards the user; lengths
 * are in millimetres.
 */

#include "Devices/Vendor/VendorPlugin.h"
#include "Emulators/OpenHaptics/FakeOpenHaptics.h"
#include "VendorRig.h"

#include <HD/hd.h>

using namespace vendortest;

namespace
{
constexpr double Height = -0.01; // m, height of the floor
// Maps the device's up axis (y) to the floor's normal.
const Matrix3 ToTheFloor = Matrix3::FromColumns({ 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 0 });

class OpenHaptics : public testing::Test
{
protected:
  OpenHaptics() { this->Fake.Reset(); }
  ~OpenHaptics() override { unsetenv("VOLUMEHAPTICS_OPENHAPTICS_DEVICES"); }
  template <typename F>
  auto With(F&& use)
  {
    const std::lock_guard<std::mutex> lock(this->Fake.Mutex);
    return use(this->Fake);
  }
  Triple Force()
  {
    return this->With([](const FakeOpenHaptics& fake) { return fake.Force; });
  }
  void Lead(const Triple& goal)
  {
    this->With([&goal](FakeOpenHaptics& fake) { fake.Hand.Goal = goal; });
  }
  void Feel()
  {
    ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
    this->Bench.Start(this->Ground.Model);
    ASSERT_TRUE(this->Bench.WaitForTicks(20));
    this->Bench->Arm();
    const double held = FloorStiffness * BalancedDepth(0.005);
    EXPECT_TRUE(this->Bench.Press(
      [&]
      {
        this->Lead({ 0.0, Height + 0.005, 0.0 });
        Eventually(
          [&]
          {
            return this->With([](const FakeOpenHaptics& fake)
              { return std::abs(fake.Hand.Tip[1] - Height - 0.005) < 0.001; });
          });
      },
      [&] {
        this->Lead({ 0.0, Height - 0.005, 0.0 });
      },
      [&] {
        return IsNear(this->Force(), { 0.0, held, 0.0 }, 0.05);
      }))
      << this->Force()[1];
  }
  template <typename F>
  void Break(F&& change, const char* text)
  {
    ASSERT_TRUE(this->Bench.Open("vendor:openhaptics")) << this->Bench.Error;
    ASSERT_NO_FATAL_FAILURE(this->Feel());
    this->With(change);
    this->Bench.ExpectLost(text);
  }
  bool IsQuiet()
  {
    return Eventually([&] { return this->Force() == Triple{}; });
  }

  FakeOpenHaptics& Fake = FakeOpenHaptics::Get();
  const PluginFolder Folder;
  const fs::path File = this->Folder.Add("openhaptics");
  const Floor Ground{ Height, ToTheFloor };
  DeviceBench Bench;
};
} // namespace

TEST_F(OpenHaptics, PressesAFloorAndLetsGo)
{
  const std::vector<DeviceListing> found = ListVendors();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].Identity, "") << "only an open device tells its serial number";
  ASSERT_TRUE(this->Bench.Open("vendor:openhaptics")) << this->Bench.Error;
  const DeviceLimits limits = this->Bench.Device->GetLimits();
  EXPECT_EQ(limits.MaximumForce, 3.3) << "the peak";
  EXPECT_EQ(limits.ContinuousForce, 0.88);
  EXPECT_EQ(limits.MaximumStiffness, 1000.0) << "a newton per millimetre";
  EXPECT_NEAR(limits.MaximumDamping, 3.0, 1e-12);
  EXPECT_NEAR(limits.WorkspaceRadius, 0.035, 1e-12) << "half of the box's least extent";
  EXPECT_EQ(this->Bench.Device->GetIdentity(), "vendor:openhaptics:HD_0815_7");
  ASSERT_NO_FATAL_FAILURE(this->Feel());
  this->Bench.Device->Close();
  const auto calls = this->With([](const FakeOpenHaptics& fake) { return fake.Calls; });
  EXPECT_EQ(calls, (std::vector<std::string>{ "init default", "stop", "disable" }));
  EXPECT_EQ(this->With([](const FakeOpenHaptics& fake) { return fake.ForcesAtTheEnd; }), 0);
}

TEST_F(OpenHaptics, OrientationComesFromTheTransformsColumns)
{
  // Rotate the stylus by 90 degrees about y (up), which turns its handle from z to x.
  this->With(
    [](FakeOpenHaptics& fake)
    {
      fake.Turn = { 0, 0, -1, 0, 1, 0, 1, 0, 0 };
      fake.Hand.Place({ 0.01, 0.02, 0.03 });
      fake.Buttons = 2;
    });
  ASSERT_TRUE(this->Bench.Open("vendor:openhaptics")) << this->Bench.Error;
  ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
  DeviceSample sample;
  ASSERT_TRUE(Eventually(
    [&]
    {
      this->Bench.Device->Read(0.001, sample);
      return sample.HasOrientation;
    }));
  EXPECT_NEAR(sample.Tip.X, 0.01, 1e-9);
  EXPECT_NEAR(sample.Tip.Y, 0.02, 1e-9);
  EXPECT_NEAR(sample.Tip.Z, 0.03, 1e-9);
  EXPECT_EQ(sample.Buttons, 2u);
  const Vector3 handle = ToMatrix(sample.Orientation) * Vector3{ 0.0, 0.0, 1.0 };
  EXPECT_NEAR(handle.X, 1.0, 1e-9);
  EXPECT_NEAR(handle.Y, 0.0, 1e-9);
  EXPECT_NEAR(handle.Z, 0.0, 1e-9);
}

TEST_F(OpenHaptics, IsCalibratedByItselfOrByTheInkwell)
{
  this->With([](FakeOpenHaptics& fake) { fake.Calibration = HD_CALIBRATION_NEEDS_MANUAL_INPUT; });
  ASSERT_TRUE(this->Bench.Open("vendor:openhaptics")) << this->Bench.Error;
  ASSERT_TRUE(this->Bench.WaitForText("into its inkwell")) << this->Bench.Text();
  for (int i = 0; i < 20; ++i)
  {
    this->Bench.Device->Write({ 0.0, 1.0, 0.0 });
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_EQ(this->Force(), Triple{});
  // When the stylus is in the inkwell, the library requests an update of the calibration.
  this->With([](FakeOpenHaptics& fake) { fake.Calibration = HD_CALIBRATION_NEEDS_UPDATE; });
  ASSERT_NO_FATAL_FAILURE(this->Feel());
  EXPECT_EQ(this->With([](const FakeOpenHaptics& fake) { return fake.ForcesBeforeZero; }), 0);
  EXPECT_EQ(this->With([](const FakeOpenHaptics& fake) { return fake.Calls.back(); }),
    "update in the inkwell");
}

TEST_F(OpenHaptics, OneOfSeveralWaysOfCalibrationIsChosen)
{
  struct Row
  {
    int Styles;
    const char* Call;
  };
  for (const Row& row : { Row{ 7, "update automatically" }, Row{ 6, "update automatically" },
         Row{ 5, "update in the inkwell" }, Row{ 1, "update by a reset" } })
  {
    this->With(
      [&](FakeOpenHaptics& fake)
      {
        fake.Styles = row.Styles;
        fake.Calibration = HD_CALIBRATION_NEEDS_UPDATE;
      });
    DeviceBench bench;
    ASSERT_TRUE(bench.Open("vendor:openhaptics")) << bench.Error;
    EXPECT_TRUE(bench.WaitFor(DeviceStage::Ready)) << bench.Text();
    EXPECT_EQ(this->With([](const FakeOpenHaptics& fake) { return fake.Calls.back(); }), row.Call);
  }
}

TEST_F(OpenHaptics, MoreThanTheContinuousForceFadesToIt)
{
  ASSERT_TRUE(this->Bench.Open("vendor:openhaptics")) << this->Bench.Error;
  ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
  const auto push = [&](double newtons)
  {
    DeviceSample sample;
    this->Bench.Device->Read(0.001, sample);
    this->Bench.Device->Write({ 0.0, newtons, 0.0 });
    return this->Force()[1];
  };
  EXPECT_TRUE(Eventually([&] { return push(3.2) == 3.2; })) << "at first";
  EXPECT_TRUE(Eventually([&] { return std::abs(push(3.2) - 0.88) < 1e-9; })) << this->Force()[1];
  // A weaker force has no time limit, and allows the motors to cool.
  EXPECT_TRUE(Eventually([&] { return push(0.5) == 0.5; }));
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(4);
  while (std::chrono::steady_clock::now() < end)
  {
    push(0.5);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_TRUE(Eventually([&] { return push(3.2) == 3.2; })) << "rested";
}

TEST_F(OpenHaptics, ALibraryWithoutAContinuousForceHasItsPeak)
{
  this->With([](FakeOpenHaptics& fake) { fake.ContinuousForce = 0.0; });
  ASSERT_TRUE(this->Bench.Open("vendor:openhaptics")) << this->Bench.Error;
  EXPECT_EQ(this->Bench.Device->GetLimits().MaximumForce, 3.3);
  EXPECT_EQ(this->Bench.Device->GetLimits().ContinuousForce, 0.0);
}

TEST_F(OpenHaptics, TheDefaultIsFoundByItsNames)
{
  for (const char* const name : { "Default Device", "Default PHANToM" })
  {
    this->With([&](FakeOpenHaptics& fake) { fake.Name = name; });
    DeviceBench bench;
    ASSERT_TRUE(bench.Open("vendor:openhaptics")) << bench.Error;
    EXPECT_TRUE(bench.WaitFor(DeviceStage::Ready)) << bench.Text();
  }
}

TEST_F(OpenHaptics, TorqueIsInMillinewtonMetresAndOnlyWhereItIsGiven)
{
  this->With([](FakeOpenHaptics& fake) { fake.OutputDof = 6; });
  ASSERT_TRUE(this->Bench.Open("vendor:openhaptics")) << this->Bench.Error;
  ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
  EXPECT_TRUE(Eventually(
    [&]
    {
      DeviceSample sample;
      this->Bench.Device->Read(0.001, sample);
      this->Bench.Device->Send({ { 0.5, 0.6, 0.25 }, { 0.1, 0.0, 0.0 } });
      return this->With(
        [](const FakeOpenHaptics& fake) {
          return fake.Force == Triple{ 0.5, 0.6, 0.25 } && fake.Torque == Triple{ 100.0, 0.0, 0.0 };
        });
    }));
}

TEST_F(OpenHaptics, WarmMotorsCutTheForceUntilHome)
{
  this->Break(
    [](FakeOpenHaptics& fake) { fake.Faults.push_back(HD_WARM_MOTORS); }, "Motors too warm");
  EXPECT_TRUE(this->IsQuiet());
  this->Bench.Device->Home();
  EXPECT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
}

TEST_F(OpenHaptics, ABrokenConnectionCutsTheForce)
{
  this->Break(
    [](FakeOpenHaptics& fake) {
      fake.Faults.insert(fake.Faults.end(), { HD_COMM_ERROR, HD_COMM_ERROR });
    },
    "Communication error");
  EXPECT_TRUE(this->IsQuiet());
}

TEST_F(OpenHaptics, ASchedulerThatStandsStillIsAFault)
{
  // The plug-in's callback no longer runs, so only the library's watchdog can end the force.
  this->Break(
    [](FakeOpenHaptics& fake) { fake.StandsStill = true; }, "the library's scheduler stands still");
}

TEST_F(OpenHaptics, APositionThatIsNoNumberCutsTheForce)
{
  this->Break([](FakeOpenHaptics& fake) { fake.TellsNonsense = true; }, "impossible position");
  EXPECT_TRUE(this->IsQuiet());
}

TEST_F(OpenHaptics, AForceThatIsNotRenewedEndsInTheCallback)
{
  // Use the plug-in without the driver, because the driver would write zero itself.
  std::string error;
  void* const library = VolumeHaptics::Libraries::Load(this->File.string(), error);
  ASSERT_NE(library, nullptr) << error;
  using Getter = const VolumeHapticsVendorPlugin* (*)(uint32_t);
  const auto get = reinterpret_cast<Getter>(
    VolumeHaptics::Libraries::Find(library, "VolumeHapticsVendorGetPlugin"));
  ASSERT_NE(get, nullptr);
  const VolumeHapticsVendorPlugin* const plugin = get(VOLUME_HAPTICS_VENDOR_VERSION);
  void* const device = plugin->Open(0);
  ASSERT_NE(device, nullptr);
  const double force[3] = { 0.0, 1.0, 0.0 };
  const double zero[3] = {};
  EXPECT_TRUE(Eventually(
    [&]
    {
      plugin->Write(device, force, zero);
      return this->Force()[1] == 1.0;
    }));
  EXPECT_TRUE(this->IsQuiet()) << "without another call";
  plugin->Write(device, zero, zero);
  plugin->Close(device);
}

TEST_F(OpenHaptics, FaultsOfAFailureToOpenAreForgotten)
{
  this->With(
    [](FakeOpenHaptics& fake) {
      fake.Faults.insert(fake.Faults.end(), { HD_COMM_ERROR, HD_COMM_ERROR });
    });
  ASSERT_TRUE(this->Bench.Open("vendor:openhaptics")) << this->Bench.Error;
  EXPECT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
}

TEST_F(OpenHaptics, NamedDevicesAreCounted)
{
  setenv("VOLUMEHAPTICS_OPENHAPTICS_DEVICES", "Left,Right", 1);
  const std::vector<DeviceListing> all = ListVendors();
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[2].Name, "OpenHaptics \"Right\"");
  ASSERT_TRUE(this->Bench.Open("vendor:openhaptics:1")) << this->Bench.Error;
  EXPECT_EQ(this->With([](const FakeOpenHaptics& fake) { return fake.Calls.back(); }), "init Left");
}

TEST_F(OpenHaptics, TwoArmsHaveEachItsOwnPoseAndForce)
{
  setenv("VOLUMEHAPTICS_OPENHAPTICS_DEVICES", "Right", 1);
  this->With(
    [](FakeOpenHaptics& fake)
    {
      fake.Hand.Place({ 0.01, 0.02, 0.03 });
      fake.Right.Hand.Place({ -0.01, 0.0, 0.02 });
    });
  DeviceBench right;
  ASSERT_TRUE(this->Bench.Open("vendor:openhaptics")) << this->Bench.Error;
  ASSERT_TRUE(right.Open("vendor:openhaptics:1")) << right.Error;
  EXPECT_EQ(right.Device->GetIdentity(), "vendor:openhaptics:HD_0816");
  ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
  ASSERT_TRUE(right.WaitFor(DeviceStage::Ready)) << right.Text();
  DeviceSample first;
  DeviceSample second;
  EXPECT_TRUE(Eventually(
    [&]
    {
      this->Bench.Device->Read(0.001, first);
      right.Device->Read(0.001, second);
      this->Bench.Device->Write({ 0.5, 0.0, 0.0 });
      right.Device->Write({ 0.0, 0.25, 0.0 });
      return this->With(
        [](const FakeOpenHaptics& fake) {
          return fake.Force == Triple{ 0.5, 0.0, 0.0 } &&
            fake.Right.Force == Triple{ 0.0, 0.25, 0.0 };
        });
    }));
  EXPECT_GE(first.Tip.X, 0.01);
  EXPECT_NEAR(first.Tip.Y, 0.02, 1e-9);
  EXPECT_NEAR(second.Tip.X, -0.01, 1e-9);
  EXPECT_NEAR(second.Tip.Z, 0.02, 1e-9);

  // The fault of one device must leave the other device ready.
  this->With([](FakeOpenHaptics& fake) { fake.Right.Faults.push_back(HD_WARM_MOTORS); });
  EXPECT_TRUE(right.WaitForText("Motors too warm"));
  EXPECT_EQ(this->Bench.Device->GetCondition().Stage, DeviceStage::Ready);
  EXPECT_TRUE(Eventually(
    [&]
    {
      this->Bench.Device->Read(0.001, first);
      this->Bench.Device->Write({ 0.5, 0.0, 0.0 });
      return this->With(
        [](const FakeOpenHaptics& fake) {
          return fake.Force == Triple{ 0.5, 0.0, 0.0 } && fake.Right.Force == Triple{};
        });
    }));
}

TEST_F(OpenHaptics, AnArmThatIsOpenedOrClosedDisarmsTheOther)
{
  setenv("VOLUMEHAPTICS_OPENHAPTICS_DEVICES", "Right", 1);
  ASSERT_TRUE(this->Bench.Open("vendor:openhaptics")) << this->Bench.Error;
  ASSERT_NO_FATAL_FAILURE(this->Feel());
  const auto expectDisarmed = [&]
  {
    EXPECT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
    EXPECT_TRUE(Eventually([&] { return !this->Bench.State().IsArmed(); }));
    EXPECT_TRUE(this->Bench.WaitForTicks(100));
    EXPECT_FALSE(this->Bench.State().IsArmed());
    EXPECT_EQ(this->Force(), Triple{}) << "not by itself";
    EXPECT_TRUE(this->Bench.WaitForText("lost its force: it waits while another device of this "
                                        "library is opened or closed. Arm() it"))
      << this->Bench.Text();
  };
  const auto feelAgain = [&]
  {
    // Move the hand out first. If the loop began below the floor, the hand would feel the floor
    // from below.
    this->Bench.Stop();
    this->Lead({ 0.0, Height + 0.005, 0.0 });
    EXPECT_TRUE(Eventually(
      [&]
      {
        return this->With([](const FakeOpenHaptics& fake) { return fake.Hand.Tip[1]; }) >
          Height + 0.004;
      }));
    ASSERT_NO_FATAL_FAILURE(this->Feel());
    EXPECT_TRUE(Eventually([&] { return this->Bench.Text().find("lost") == std::string::npos; }))
      << this->Bench.Text();
  };
  // The force must fade smoothly. On a busy machine that pauses meanwhile, it ends at once, so try
  // again.
  bool isSmooth = false;
  for (int attempt = 0; attempt < 5 && !isSmooth; ++attempt)
  {
    {
      const double held = this->Force()[1];
      this->With([](FakeOpenHaptics& fake) { fake.LargestFall = 0.0; });
      DeviceBench right;
      ASSERT_TRUE(right.Open("vendor:openhaptics:1")) << right.Error;
      EXPECT_TRUE(right.WaitFor(DeviceStage::Ready)) << right.Text();
      expectDisarmed();
      isSmooth =
        this->With([&](const FakeOpenHaptics& fake) { return fake.LargestFall < 0.2 * held; });
      feelAgain();
    }
    expectDisarmed();
    feelAgain();
  }
  EXPECT_TRUE(isSmooth);
  // A failed attempt to open the second device also disarms the first one.
  this->With([](FakeOpenHaptics& fake) { fake.IsPluggedIn = false; });
  EXPECT_TRUE(Has(ErrorOf("vendor:openhaptics:1"), "Communication error"));
  expectDisarmed();
  EXPECT_EQ(this->With([](const FakeOpenHaptics& fake) { return fake.ForcesAtTheEnd; }), 0);
}

TEST_F(OpenHaptics, ADeviceThatIsNotThereIsAnErrorWithACure)
{
  this->With([](FakeOpenHaptics& fake) { fake.IsPluggedIn = false; });
  const std::string error = ErrorOf("vendor:openhaptics");
  EXPECT_TRUE(Has(error, "Communication error")) << error;
  EXPECT_TRUE(Has(error, "pair it by the vendor's setup program")) << error;
}
