// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a device behind a plug-in, from opening to closing, against the guarantees in
 * VendorPlugin.h. The test controls the plug-in. Each fault of the device must end in zero force
 * and a text.
 */

#include "PlayedVendor.h"
#include "Rigs/ShellRig.h"
#include "VendorRig.h"

#include <limits>

using namespace vendortest;

namespace
{
class VendorDevice : public testing::Test
{
protected:
  VendorDevice()
  {
    const fs::path file = this->Folder.Add("played");
    std::string error;
    void* const library = Libraries::Load(file.string(), error);
    using Getter = PlayedVendor* (*)();
    const auto get = reinterpret_cast<Getter>(Libraries::Find(library, "GetPlayedVendor"));
    this->Played = get();
    this->Played->Calls.clear();
  }
  template <typename F>
  void Play(F&& change)
  {
    const std::lock_guard<std::mutex> lock(this->Played->Mutex);
    change(*this->Played);
  }
  template <typename F>
  auto Ask(F&& question)
  {
    const std::lock_guard<std::mutex> lock(this->Played->Mutex);
    return question(*this->Played);
  }
  std::array<double, 3> Force()
  {
    return this->Ask([](const PlayedVendor& played) { return played.Force; });
  }
  void OpenReady()
  {
    ASSERT_TRUE(this->Bench.Open("vendor:played")) << this->Bench.Error;
    ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
  }
  /**
   * Reads and writes like the servo, until the device has exactly this force. If a busy machine
   * renews the force late, it fades temporarily.
   */
  bool Push(const DeviceCommand& command)
  {
    return Eventually(
      [&]
      {
        DeviceSample sample;
        this->Bench.Device->Read(0.001, sample);
        this->Bench.Device->Send(command);
        const Vector3& f = command.Force;
        const Vector3& t = command.Torque;
        return this->Ask(
          [&](const PlayedVendor& played)
          {
            return played.Force == std::array<double, 3>{ f.X, f.Y, f.Z } &&
              played.Torque == std::array<double, 3>{ t.X, t.Y, t.Z };
          });
      });
  }
  /// Causes a fault while a force acts. Expects the text, and a force that becomes zero and stays
  /// zero.
  template <typename F>
  void Break(F&& change, const char* text)
  {
    ASSERT_NO_FATAL_FAILURE(this->OpenReady());
    ASSERT_TRUE(this->Push({ { 1.0, 0.0, 0.0 }, {} }));
    this->Play(change);
    EXPECT_TRUE(Eventually(
      [&]
      {
        DeviceSample sample;
        this->Bench.Device->Read(0.001, sample);
        this->Bench.Device->Send({ { 1.0, 0.0, 0.0 }, {} });
        return this->Bench.Device->GetCondition().Stage == DeviceStage::Lost;
      }));
    EXPECT_TRUE(Has(this->Bench.Text(), text)) << this->Bench.Text();
    EXPECT_TRUE(Eventually([&] { return this->Force() == std::array<double, 3>{}; }));
    // The force does not return by itself.
    this->Bench.Device->Send({ { 1.0, 0.0, 0.0 }, {} });
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    EXPECT_EQ(this->Force(), (std::array<double, 3>{}));
    this->Bench.Device->Close();
    EXPECT_EQ(this->Ask([](const PlayedVendor& played) { return played.Calls.back(); }), "close");
  }

  const PluginFolder Folder;
  PlayedVendor* Played = nullptr;
  DeviceBench Bench;
};
} // namespace

TEST_F(VendorDevice, HasItsLimitsNameAndIdentityAndIsInUse)
{
  ASSERT_NO_FATAL_FAILURE(this->OpenReady());
  const DeviceLimits limits = this->Bench.Device->GetLimits();
  EXPECT_EQ(limits.MaximumForce, 4.0);
  EXPECT_EQ(limits.MaximumTorque, 0.1);
  EXPECT_EQ(limits.MaximumStiffness, 800.0);
  EXPECT_EQ(limits.WorkspaceRadius, 0.05);
  EXPECT_EQ(this->Bench.Device->GetName(), "Played stylus 0 (vendor:played:0)");
  EXPECT_EQ(this->Bench.Device->GetIdentity(), "vendor:played:SN_1_2");
  EXPECT_TRUE(this->Bench.Device->KeepsIdentity());
  const int asked = this->Ask([](const PlayedVendor& played) { return played.Asked; });
  const std::vector<DeviceListing> all = ListVendors();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].State, "in use");
  EXPECT_EQ(all[1].State, "available");
  EXPECT_EQ(this->Ask([](const PlayedVendor& played) { return played.Asked; }), asked)
    << "the plug-in is not asked while its device runs";
  EXPECT_TRUE(Has(ErrorOf("vendor:played:0"), "in use by this program"));
}

TEST_F(VendorDevice, KeepsNoIdentityWithoutASerialNumber)
{
  this->Play([](PlayedVendor& played) { played.Serial.clear(); });
  ASSERT_NO_FATAL_FAILURE(this->OpenReady());
  EXPECT_EQ(this->Bench.Device->GetIdentity(), "vendor:played:number:0") << "it has signs, however";
  EXPECT_FALSE(this->Bench.Device->KeepsIdentity());
  const std::vector<DeviceListing> all = ListVendors();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].Identity, "");
}

TEST_F(VendorDevice, TellsPoseButtonsAndOrientation)
{
  this->Play(
    [](PlayedVendor& played) {
      played.Pose = { { 0.01, 0.02, 0.03 }, { 0.6, 0.0, 0.8, 0.0 }, 2'000'000, 5u, 1 };
    });
  ASSERT_NO_FATAL_FAILURE(this->OpenReady());
  DeviceSample sample;
  ASSERT_TRUE(Eventually([&]
    { return this->Bench.Device->Read(0.001, sample) == DeviceState::Running && sample.Fresh; }));
  EXPECT_EQ(sample.Tip.X, 0.01);
  EXPECT_EQ(sample.Tip.Y, 0.02);
  EXPECT_EQ(sample.Tip.Z, 0.03);
  EXPECT_EQ(sample.Buttons, 5u);
  EXPECT_TRUE(sample.HasOrientation);
  EXPECT_EQ(sample.Orientation.W, 0.6);
  EXPECT_EQ(sample.Orientation.Y, 0.8);
  const auto now = std::chrono::duration_cast<std::chrono::nanoseconds>(
    std::chrono::steady_clock::now().time_since_epoch());
  EXPECT_GE(now.count() - sample.Time, 2'000'000) << "it was measured two milliseconds before";
  // A read without news shows that the device is alive. It returns the sample of the last read.
  this->Play([](PlayedVendor& played) { played.ReadResult = VOLUME_HAPTICS_VENDOR_DONE; });
  EXPECT_TRUE(Eventually(
    [&]
    {
      this->Bench.Device->Read(0.001, sample);
      return sample.Alive && !sample.Fresh;
    }));
}

/// Presses a ball with a radius of 3 mm 2 mm deep into solid material above z = 10 mm. The ball is
/// held 1 mm beside its centre. Expects a downward force, and the torque of the 1 mm lever, which
/// rotates with the stylus.
TEST_F(VendorDevice, AToolWithAShapeIsFeltInSixDegrees)
{
  const TestVolume volume = MakeRamp();
  HapticModelDescription d = coretest::Describe(volume);
  std::vector<ShellPoint> points = coretest::MakeSphere(3.0, 1000);
  for (ShellPoint& point : points)
  {
    point = { 1e3 * point.Position + Vector3{ 1.0, 0.0, 0.0 }, 1e6 * point.Area };
  }
  ShellDescription tool;
  tool.Points = std::make_shared<const PointShell>(std::move(points));
  tool.Touch.Level = 1000.0;
  tool.Touch.ContactArea = 25.0;
  d.Tool = std::make_shared<const BakedShell>(tool);
  const auto place = [this](double z, const Quaternion& q)
  {
    this->Play(
      [&](PlayedVendor& played)
      {
        played.Pose = { { 0.012, 0.012, z }, { q.W, q.X, q.Y, q.Z }, 0, 0, 1 };
        played.ReadResult = VOLUME_HAPTICS_VENDOR_NEWS;
      });
    std::this_thread::sleep_for(std::chrono::milliseconds(4));
  };
  place(0.006, {});
  ASSERT_NO_FATAL_FAILURE(this->OpenReady());
  this->Bench.Start(std::make_shared<const HapticModel>(d));
  SafetyLimits limits = servotest::QuickLimits();
  limits.MaximumTorque = this->Bench.Device->GetLimits().MaximumTorque;
  this->Bench->SetLimits(limits);
  this->Bench->Arm();
  const Quaternion turns[] = { {}, coretest::TurnAbout({ 0.0, 0.0, 1.0 }, 0.5 * coretest::Pi) };
  for (int turn = 0; turn < 2; ++turn)
  {
    for (int i = 0; i <= 60; ++i)
    {
      place(0.006 + 5e-5 * i, turns[turn]);
    }
    // In equilibrium, k (2 mm - depth) = pi kappa a depth^2. The torque is the force times the
    // lever.
    const double b = 500.0 / (coretest::Pi * coretest::Kappa * 3e-3);
    const double force = 500.0 * (2e-3 - 0.5 * (std::sqrt(b * b + 4.0 * b * 2e-3) - b));
    const auto isFelt = [&]
    {
      place(0.009, turns[turn]);
      return this->Ask(
        [&](const PlayedVendor& played)
        {
          const double torque = turn == 0 ? played.Torque[1] : -played.Torque[0];
          const double other = turn == 0 ? played.Torque[0] : played.Torque[1];
          return std::abs(played.Force[2] + force) < 0.02 * force &&
            std::abs(torque - 1e-3 * force) < 0.03e-3 * force && std::abs(other) < 1e-5;
        });
    };
    EXPECT_TRUE(Eventually(isFelt)) << turn;
    for (int i = 60; i >= 0; --i)
    {
      place(0.006 + 5e-5 * i, turns[turn]);
    }
  }
  this->Bench.Stop();
}

TEST_F(VendorDevice, ForceAndTorqueArriveWithinTheLimits)
{
  ASSERT_NO_FATAL_FAILURE(this->OpenReady());
  ASSERT_TRUE(this->Push({ { 3.0, 0.0, 0.0 }, { 0.0, 0.05, 0.0 } }));
  const auto isCut = [&]
  {
    this->Bench.Device->Send({ { 0.0, 40.0, 0.0 }, { 0.0, 0.0, -2.0 } });
    return this->Ask(
      [](const PlayedVendor& played)
      {
        return played.Force == std::array<double, 3>{ 0.0, 4.0, 0.0 } &&
          std::abs(played.Torque[2] + 0.1) < 1e-12;
      });
  };
  EXPECT_TRUE(Eventually(isCut));
  // The force becomes zero both when the servo stops renewing it and when it is quenched.
  const auto isZero = [&]
  {
    return this->Ask(
      [](const PlayedVendor& played) {
        return played.Force == std::array<double, 3>{} && played.Torque == std::array<double, 3>{};
      });
  };
  EXPECT_TRUE(Eventually(isZero));
  ASSERT_TRUE(this->Push({ { 1.0, 0.0, 0.0 }, {} }));
  this->Bench.Device->Quench();
  EXPECT_TRUE(Eventually(isZero));
  EXPECT_TRUE(Eventually([&] { return this->Bench.Device->IsAtRest(); }));
}

TEST_F(VendorDevice, BeginsAndEndsWithZero)
{
  ASSERT_NO_FATAL_FAILURE(this->OpenReady());
  ASSERT_TRUE(this->Push({ { 1.0, 0.0, 0.0 }, {} }));
  this->Bench.Device->Close();
  const auto calls = this->Ask([](const PlayedVendor& played) { return played.Calls; });
  ASSERT_GE(calls.size(), 5U);
  EXPECT_EQ(calls[0], "open");
  EXPECT_EQ(calls[1], "zero");
  EXPECT_EQ(calls[2], "force");
  // On a busy machine, the force may have faded and returned, which adds earlier calls.
  EXPECT_EQ(calls[calls.size() - 2], "zero");
  EXPECT_EQ(calls.back(), "close");
}

TEST_F(VendorDevice, WaitsUntilItIsHomed)
{
  this->Play(
    [](PlayedVendor& played)
    {
      played.ReadResult = VOLUME_HAPTICS_VENDOR_WAITS;
      played.Error = "is not homed. Press Home().";
    });
  ASSERT_TRUE(this->Bench.Open("vendor:played:0")) << this->Bench.Error;
  ASSERT_TRUE(this->Bench.WaitForText("is not homed. Press Home().")) << this->Bench.Text();
  EXPECT_EQ(this->Bench.Device->GetCondition().Stage, DeviceStage::Homing);
  DeviceSample sample;
  EXPECT_EQ(this->Bench.Device->Read(0.001, sample), DeviceState::NotReady);
  for (int i = 0; i < 20; ++i)
  {
    this->Bench.Device->Send({ { 1.0, 0.0, 0.0 }, {} });
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_EQ(this->Force(), (std::array<double, 3>{}));
  this->Play([](PlayedVendor& played) { played.ReadResult = VOLUME_HAPTICS_VENDOR_NEWS; });
  this->Bench.Device->Home();
  EXPECT_TRUE(this->Bench.WaitFor(DeviceStage::Ready));
  EXPECT_EQ(this->Ask([](const PlayedVendor& played) { return played.Homes; }), 1);
}

TEST_F(VendorDevice, ALossLatchesUntilItIsHomed)
{
  ASSERT_NO_FATAL_FAILURE(this->OpenReady());
  this->Play([](PlayedVendor& played) { played.ReadResult = VOLUME_HAPTICS_VENDOR_LOST; });
  ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Lost));
  EXPECT_TRUE(Has(this->Bench.Text(), "is as the test wants it.")) << this->Bench.Text();
  this->Play(
    [](PlayedVendor& played)
    {
      played.ReadResult = VOLUME_HAPTICS_VENDOR_NEWS;
      played.HomeResult = VOLUME_HAPTICS_VENDOR_LOST;
    });
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  EXPECT_EQ(this->Bench.Device->GetCondition().Stage, DeviceStage::Lost);
  this->Bench.Device->Home();
  EXPECT_TRUE(Eventually(
    [&] { return this->Ask([](const PlayedVendor& played) { return played.Homes; }) == 1; }));
  ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Lost));
  this->Play([](PlayedVendor& played) { played.HomeResult = VOLUME_HAPTICS_VENDOR_DONE; });
  this->Bench.Device->Home();
  EXPECT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
}

TEST_F(VendorDevice, AnotherOneInItsPlaceIsOpenedOnceAndLeft)
{
  this->Play(
    [](PlayedVendor& played)
    {
      played.Count = 1;
      played.TellsSerialOnlyOpen = true;
    });
  ASSERT_NO_FATAL_FAILURE(this->OpenReady());
  const std::string serial = this->Ask([](const PlayedVendor& played) { return played.Serial; });
  this->Play(
    [](PlayedVendor& played)
    {
      played.ReadResult = VOLUME_HAPTICS_VENDOR_GONE;
      played.Serial = "another";
    });
  ASSERT_TRUE(this->Bench.WaitForText("Played stylus 0 (vendor:played:0) was unplugged. Plug it in "
                                      "again: it is opened by itself"))
    << this->Bench.Text();
  const auto countOpens = [this]
  {
    return this->Ask([](const PlayedVendor& played)
      { return std::count(played.Calls.begin(), played.Calls.end(), "open"); });
  };
  for (int look = 0; look < 5; ++look)
  {
    const int asked = this->Ask([](const PlayedVendor& played) { return played.Asked; });
    this->Bench.Device->Home();
    EXPECT_TRUE(Eventually([&]
      { return this->Ask([](const PlayedVendor& played) { return played.Asked; }) > asked + 1; }));
    EXPECT_TRUE(this->Bench.WaitFor(DeviceStage::Lost));
  }
  EXPECT_EQ(countOpens(), 2);
  EXPECT_EQ(this->Bench.Device->GetName(), "Played stylus 0 (vendor:played:0)");
  EXPECT_EQ(this->Force(), (std::array<double, 3>{}));
  // Plug the device in again, together with another device.
  this->Play(
    [&](PlayedVendor& played)
    {
      played.ReadResult = VOLUME_HAPTICS_VENDOR_NEWS;
      played.Serial = serial;
      played.Count = 2;
    });
  EXPECT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
  EXPECT_EQ(countOpens(), 3);
}

TEST_F(VendorDevice, WithoutASerialNumberItIsNotOpenedByItself)
{
  this->Play([](PlayedVendor& played) { played.Serial.clear(); });
  ASSERT_NO_FATAL_FAILURE(this->OpenReady());
  this->Play([](PlayedVendor& played) { played.ReadResult = VOLUME_HAPTICS_VENDOR_GONE; });
  EXPECT_TRUE(this->Bench.WaitForText("was unplugged. Plug it in, then Open() and Start() it."))
    << this->Bench.Text();
}

TEST_F(VendorDevice, AFaultOfReadingCutsTheForce)
{
  this->Break([](PlayedVendor& played) { played.ReadResult = VOLUME_HAPTICS_VENDOR_LOST; },
    "is as the test wants it.");
}

TEST_F(VendorDevice, AFaultOfWritingCutsTheForce)
{
  this->Break([](PlayedVendor& played) { played.WriteResult = VOLUME_HAPTICS_VENDOR_LOST; },
    "is as the test wants it.");
}

TEST_F(VendorDevice, APositionThatIsNoNumberCutsTheForce)
{
  this->Break([](PlayedVendor& played)
    { played.Pose.Position[1] = std::numeric_limits<double>::quiet_NaN(); },
    "reported an impossible position");
}

TEST_F(VendorDevice, APositionInMillimetresCutsTheForce)
{
  this->Break([](PlayedVendor& played) { played.Pose.Position[1] = 50.0; },
    "reported an impossible position");
}

TEST_F(VendorDevice, ACallThatHangsCutsTheForce)
{
  this->Break([](PlayedVendor& played) { played.ReadTime = 600; }, "did not answer for");
}

TEST_F(VendorDevice, IsNotOpenedWithoutItsLimits)
{
  this->Play([](PlayedVendor& played) { played.Limits.MaximumForce = 0.0; });
  EXPECT_TRUE(Has(ErrorOf("vendor:played"), "does not say its largest force"));
  this->Play(
    [](PlayedVendor& played)
    {
      played.Limits.MaximumForce = 4.0;
      played.Limits.MaximumStiffness = std::numeric_limits<double>::quiet_NaN();
    });
  EXPECT_TRUE(Has(ErrorOf("vendor:played"), "limits that are no numbers"));
  EXPECT_EQ(this->Ask([](const PlayedVendor& played) { return played.Calls.back(); }), "close");
}

TEST_F(VendorDevice, PushesAlongAllAxesIfItsAxesAreNotKnown)
{
  this->Play([](PlayedVendor& played) { played.Limits.ForceAxes = 0; });
  ASSERT_NO_FATAL_FAILURE(this->OpenReady());
  EXPECT_EQ(this->Bench.Device->GetLimits().ForceAxes, 7u);
  this->Bench.Device->Close();
  this->Play([](PlayedVendor& played) { played.Limits.ForceAxes = 8; });
  EXPECT_TRUE(Has(ErrorOf("vendor:played"), "has no axis"));
}

TEST_F(VendorDevice, APeakFadesToTheContinuousForceAndIsTold)
{
  this->Play(
    [](PlayedVendor& played)
    {
      played.Limits.ContinuousForce = 1.0;
      played.Limits.PeakTime = 0.5;
    });
  ASSERT_NO_FATAL_FAILURE(this->OpenReady());
  EXPECT_EQ(this->Bench.Device->GetLimits().MaximumForce, 4.0);
  EXPECT_EQ(this->Bench.Device->GetLimits().ContinuousForce, 1.0);
  EXPECT_TRUE(this->Push({ { 3.5, 0.0, 0.0 }, {} })) << "at first";
  EXPECT_TRUE(Eventually(
    [&]
    {
      DeviceSample sample;
      this->Bench.Device->Read(0.001, sample);
      this->Bench.Device->Send({ { 3.5, 0.0, 0.0 }, {} });
      return std::abs(this->Force()[0] - 1.0) < 1e-9;
    }))
    << this->Force()[0];
  EXPECT_TRUE(Has(this->Bench.Text(), "gives 1 N now, so that its motors don't get warm"))
    << this->Bench.Text();
  EXPECT_EQ(this->Bench.Device->GetCondition().Stage, DeviceStage::Ready);
  // A weaker force has no time limit, and removes the warning from the text.
  EXPECT_TRUE(this->Push({ { 0.9, 0.0, 0.0 }, {} }));
  EXPECT_TRUE(Eventually([&] { return this->Bench.Text().empty(); })) << this->Bench.Text();
  const auto rested = std::chrono::steady_clock::now() + std::chrono::milliseconds(2600);
  while (std::chrono::steady_clock::now() < rested)
  {
    this->Push({ { 0.9, 0.0, 0.0 }, {} });
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_TRUE(this->Push({ { 3.5, 0.0, 0.0 }, {} })) << "rested";
}

TEST_F(VendorDevice, TheReasonOfAFailureToOpenIsThePluginsOwn)
{
  this->Play(
    [](PlayedVendor& played)
    {
      played.OpenFails = 1;
      played.Error = "is held by another program. Close that.";
    });
  EXPECT_EQ(ErrorOf("vendor:played:1"), "vendor:played:1 is held by another program. Close that.");
  this->Play([](PlayedVendor& played) { played.Count = -1; });
  EXPECT_EQ(ErrorOf("vendor:played:1"), "vendor:played:1 is held by another program. Close that.");
  EXPECT_TRUE(Has(TextOfMissing(), "vendor:played is held by another program")) << TextOfMissing();
  this->Play([](PlayedVendor& played) { played.Count = 0; });
  EXPECT_TRUE(Has(ErrorOf("vendor:played"), "has no device. Plug it in"));
}
