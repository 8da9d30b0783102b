// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the plug-in for Force Dimension's library in closed loop: a hand presses on a floor. The
 * library is a stand-in that follows the SDK's public documentation
 * (Emulators/ForceDimension/FakeForceDimension.h): x points towards the user, y to the right, and z
 * up.
 */

#include "Emulators/ForceDimension/FakeForceDimension.h"
#include "VendorRig.h"

using namespace vendortest;

namespace
{
constexpr double Height = -0.01; // m, height of the floor
// Maps the device's axes (right, up, towards the user) to the library's y, z and x.
const Matrix3 ToTheLibrary = Matrix3::FromColumns({ 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 0 });

class ForceDimension : public testing::Test
{
protected:
  ForceDimension()
  {
    this->Fake.Reset();
    this->Folder.Add("forcedimension");
  }
  template <typename F>
  auto With(F&& use)
  {
    const std::lock_guard<std::mutex> lock(this->Fake.Mutex);
    return use(this->Fake);
  }
  Triple Force()
  {
    return this->With([](const FakeForceDimension& fake) { return fake.Force; });
  }
  void Lead(const Triple& goal)
  {
    this->With([&goal](FakeForceDimension& fake) { fake.Hand.Goal = goal; });
  }
  bool IsHeld()
  {
    const double force = FloorStiffness * BalancedDepth(0.01);
    return IsNear(this->Force(), { 0.0, 0.0, force }, 0.05);
  }
  /// Arms the device, and moves the hand's goal 10 mm deep into the middle of the floor.
  void Feel()
  {
    ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
    this->Bench.Start(this->Ground.Model);
    ASSERT_TRUE(this->Bench.WaitForTicks(20));
    this->Bench->Arm();
    EXPECT_TRUE(this->Bench.Press(
      [&]
      {
        this->Lead({ 0.0, 0.0, Height + 0.005 });
        Eventually(
          [&]
          {
            return this->With([](const FakeForceDimension& fake)
              { return std::abs(fake.Hand.Tip[2] - Height - 0.005) < 0.001; });
          });
      },
      [&] {
        this->Lead({ 0.0, 0.0, Height - 0.01 });
      },
      [&] { return this->IsHeld(); }))
      << this->Force()[2];
  }
  template <typename F>
  void Break(F&& change, const char* text)
  {
    ASSERT_TRUE(this->Bench.Open("vendor:forcedimension")) << this->Bench.Error;
    ASSERT_NO_FATAL_FAILURE(this->Feel());
    this->With(change);
    this->Bench.ExpectLost(text);
  }
  bool IsQuiet()
  {
    return Eventually([&] { return this->Force() == Triple{}; });
  }

  FakeForceDimension& Fake = FakeForceDimension::Get();
  const PluginFolder Folder;
  const Floor Ground{ Height, ToTheLibrary };
  DeviceBench Bench;
};
} // namespace

TEST_F(ForceDimension, PressesAFloorAndLetsGo)
{
  const std::vector<DeviceListing> all = ListVendors();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].Identity, "") << "only an open device tells its serial number";
  ASSERT_TRUE(this->Bench.Open("vendor:forcedimension")) << this->Bench.Error;
  EXPECT_EQ(this->Bench.Device->GetLimits().MaximumForce, 12.0) << "an omega";
  EXPECT_EQ(this->Bench.Device->GetIdentity(), "vendor:forcedimension:4711");
  ASSERT_NO_FATAL_FAILURE(this->Feel());
  // Slide to the right, which is the library's y. Friction resists the hand.
  this->Lead({ 0.0, 0.03, Height - 0.01 });
  EXPECT_TRUE(Eventually([&] { return this->Force()[1] < -0.5 * Friction; }));
  this->Bench.Stop();
  this->Bench.Device->Close();
  const auto calls = this->With([](const FakeForceDimension& fake) { return fake.Calls; });
  ASSERT_GE(calls.size(), 3U);
  EXPECT_EQ(calls[0], "open");
  EXPECT_EQ(calls[calls.size() - 2], "zero");
  EXPECT_EQ(calls.back(), "close");
}

TEST_F(ForceDimension, OrientationAndButtonsAreInOurAxes)
{
  // Rotate the pen by 90 degrees about the library's z (up), so that it points to the right instead
  // of towards the user.
  this->With(
    [](FakeForceDimension& fake)
    {
      fake.Frame = { { { 0, -1, 0 }, { 1, 0, 0 }, { 0, 0, 1 } } };
      fake.Buttons = 3;
    });
  ASSERT_TRUE(this->Bench.Open("vendor:forcedimension")) << this->Bench.Error;
  ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
  DeviceSample sample;
  ASSERT_TRUE(Eventually(
    [&]
    {
      this->Bench.Device->Read(0.001, sample);
      return sample.HasOrientation;
    }));
  EXPECT_EQ(sample.Buttons, 3u);
  // Expect a rotation about the device's y (up), which turns the handle from z (towards the user)
  // to x (right).
  const Vector3 handle = ToMatrix(sample.Orientation) * Vector3{ 0.0, 0.0, 1.0 };
  EXPECT_NEAR(handle.X, 1.0, 1e-9);
  EXPECT_NEAR(handle.Y, 0.0, 1e-9);
  EXPECT_NEAR(handle.Z, 0.0, 1e-9);
}

TEST_F(ForceDimension, AClosedGripperIsItsButton)
{
  this->With([](FakeForceDimension& fake) { fake.HasGripper = fake.IsGripperClosed = true; });
  ASSERT_TRUE(this->Bench.Open("vendor:forcedimension")) << this->Bench.Error;
  ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
  const auto has = [&](unsigned buttons)
  {
    return Eventually(
      [&]
      {
        DeviceSample sample;
        return this->Bench.Device->Read(0.001, sample) == DeviceState::Running &&
          sample.Buttons == buttons;
      });
  };
  EXPECT_TRUE(has(1u));
  this->With([](FakeForceDimension& fake) { fake.IsGripperClosed = false; });
  EXPECT_TRUE(has(0u));
}

TEST_F(ForceDimension, FindsItsZeroOnlyWhenTheUserSaysSo)
{
  this->With([](FakeForceDimension& fake) { fake.IsInitialised = false; });
  ASSERT_TRUE(this->Bench.Open("vendor:forcedimension")) << this->Bench.Error;
  ASSERT_TRUE(this->Bench.WaitForText("it moves by itself")) << this->Bench.Text();
  for (int i = 0; i < 20; ++i)
  {
    this->Bench.Device->Write({ 0.0, 1.0, 0.0 });
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_FALSE(this->With([](const FakeForceDimension& fake) { return fake.IsInitialised; }));
  this->Bench.Device->Home();
  ASSERT_NO_FATAL_FAILURE(this->Feel());
  EXPECT_EQ(this->With([](const FakeForceDimension& fake) { return fake.ForcesBeforeZero; }), 0);
}

TEST_F(ForceDimension, StopsWhereItIsIfItDoesNotFindItsZero)
{
  this->With(
    [](FakeForceDimension& fake)
    {
      fake.IsInitialised = false;
      fake.FailsToInit = fake.ForceIsOn = true;
    });
  ASSERT_TRUE(this->Bench.Open("vendor:forcedimension")) << this->Bench.Error;
  ASSERT_TRUE(this->Bench.WaitForText("it moves by itself")) << this->Bench.Text();
  this->Bench.Device->Home();
  ASSERT_TRUE(this->Bench.WaitForText("did not find its zero (timeout)")) << this->Bench.Text();
  EXPECT_TRUE(this->With(
    [](const FakeForceDimension& fake) { return !fake.IsRegulating && !fake.ForceIsOn; }));
  this->With([](FakeForceDimension& fake) { fake.FailsToInit = false; });
  this->Bench.Device->Home();
  ASSERT_NO_FATAL_FAILURE(this->Feel());
}

TEST_F(ForceDimension, IsNotReadyWhileItsForceIsOff)
{
  this->With([](FakeForceDimension& fake) { fake.IsInitialised = false; });
  ASSERT_TRUE(this->Bench.Open("vendor:forcedimension")) << this->Bench.Error;
  ASSERT_TRUE(this->Bench.WaitForText("it moves by itself")) << this->Bench.Text();
  // The user has moved the device to its zero, but its force is still switched off.
  this->With([](FakeForceDimension& fake) { fake.IsInitialised = true; });
  ASSERT_TRUE(this->Bench.WaitForText("has its force switched off")) << this->Bench.Text();
  EXPECT_EQ(this->Bench.Device->GetCondition().Stage, DeviceStage::Homing);
  this->Bench.Start(this->Ground.Model);
  ASSERT_TRUE(this->Bench.WaitForTicks(20));
  this->Bench->Arm();
  this->Lead({ 0.0, 0.0, Height - 0.01 });
  ASSERT_TRUE(this->Bench.WaitForTicks(50));
  EXPECT_EQ(this->Force(), Triple{}) << "its button would switch that on at once";
  this->With([](FakeForceDimension& fake) { fake.ForceIsOn = true; });
  EXPECT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
}

TEST_F(ForceDimension, AForceThatCantBeSwitchedOnIsAnErrorWithACure)
{
  this->With([](FakeForceDimension& fake) { fake.FailsToEnable = true; });
  const std::string error = ErrorOf("vendor:forcedimension");
  EXPECT_TRUE(Has(error, "does not switch its force on (communication error)")) << error;
  this->With([](FakeForceDimension& fake) { fake.FailsToEnable = false; });
  EXPECT_TRUE(this->Bench.Open("vendor:forcedimension")) << this->Bench.Error;
}

TEST_F(ForceDimension, LimitsAreThoseOfTheTypeUnlessTheLibraryHasOthers)
{
  // Limits of sigma.7 and lambda.7, as in CHAI3D's CDeltaDevices.cpp.
  struct Row
  {
    int Type;
    double Force, Torque, Radius;
  };
  for (const Row& row : { Row{ 33, 12.0, 0.0, 0.055 }, Row{ 37, 12.0, 0.0, 0.055 },
         Row{ 63, 20.0, 0.0, 0.13 }, Row{ 104, 12.0, 0.2, 0.065 }, Row{ 105, 12.0, 0.2, 0.065 },
         Row{ 206, 12.0, 0.0, 0.065 }, Row{ 108, 12.0, 0.2, 0.1125 }, Row{ 109, 12.0, 0.2, 0.1125 },
         Row{ 203, 12.0, 0.0, 0.1125 }, Row{ 60, 8.0, 0.0, 0.04 }, Row{ 91, 8.0, 0.0, 0.04 } })
  {
    this->With([&](FakeForceDimension& fake) { fake.Type = row.Type; });
    DeviceBench bench;
    ASSERT_TRUE(bench.Open("vendor:forcedimension")) << bench.Error;
    const DeviceLimits limits = bench.Device->GetLimits();
    EXPECT_EQ(limits.MaximumForce, row.Force) << row.Type;
    EXPECT_EQ(limits.MaximumTorque, row.Torque) << row.Type;
    EXPECT_EQ(limits.WorkspaceRadius, row.Radius) << row.Type;
  }
  this->With(
    [](FakeForceDimension& fake)
    {
      fake.Type = 104;
      fake.MaxForce = 5.0;
      fake.MaxTorque = 0.1;
    });
  ASSERT_TRUE(this->Bench.Open("vendor:forcedimension")) << this->Bench.Error;
  EXPECT_EQ(this->Bench.Device->GetLimits().MaximumForce, 5.0);
  EXPECT_EQ(this->Bench.Device->GetLimits().MaximumTorque, 0.1);
}

TEST_F(ForceDimension, TorqueGoesToDevicesThatGiveIt)
{
  this->With([](FakeForceDimension& fake) { fake.Type = 104; }); // a sigma.7
  ASSERT_TRUE(this->Bench.Open("vendor:forcedimension")) << this->Bench.Error;
  ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
  EXPECT_TRUE(Eventually(
    [&]
    {
      DeviceSample sample;
      this->Bench.Device->Read(0.001, sample);
      this->Bench.Device->Send({ { 1.0, 2.0, 3.0 }, { 0.05, 0.1, 0.15 } });
      return this->With(
        [](const FakeForceDimension& fake) {
          return fake.Force == Triple{ 3.0, 1.0, 2.0 } && fake.Torque == Triple{ 0.15, 0.05, 0.1 };
        });
    }));
}

TEST_F(ForceDimension, ALossOfPowerCutsTheForce)
{
  this->Break([](FakeForceDimension& fake) { fake.HasPower = false; }, "has no power");
  EXPECT_TRUE(this->IsQuiet());
}

TEST_F(ForceDimension, ADeviceThatIsBackWaitsForTheUser)
{
  this->Break([](FakeForceDimension& fake) { fake.IsPluggedIn = false; }, "was unplugged");
  this->Bench.Device->Home();
  EXPECT_TRUE(this->Bench.WaitForText("was unplugged"));
  EXPECT_EQ(this->Bench.Device->GetCondition().Stage, DeviceStage::Lost);
  // Without power, the device has lost its zero while the hand moved it.
  this->With(
    [](FakeForceDimension& fake)
    {
      fake.Hand.Place({ 0.0, 0.0, Height + 0.005 });
      fake.IsInitialised = false;
      fake.IsPluggedIn = true;
    });
  this->Bench.ExpectBack();
  EXPECT_TRUE(this->Bench.WaitForText("it moves by itself")) << this->Bench.Text();
  EXPECT_FALSE(this->With([](const FakeForceDimension& fake) { return fake.IsInitialised; }));
  this->Bench.Device->Home();
  EXPECT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
  EXPECT_TRUE(this->Bench.WaitForTicks(50));
  EXPECT_EQ(this->Bench.State().GetFault(), GateReason::DeviceLost) << "not by itself";
  EXPECT_EQ(this->Force(), Triple{});
  this->Bench.Stop();
  ASSERT_NO_FATAL_FAILURE(this->Feel());
}

TEST_F(ForceDimension, ItsForceButtonCutsTheForceUntilHome)
{
  this->Break([](FakeForceDimension& fake) { fake.ForceIsOn = false; }, "switched its force off");
  EXPECT_TRUE(this->IsQuiet());
  this->Bench.Device->Home();
  EXPECT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
  EXPECT_TRUE(this->With([](const FakeForceDimension& fake) { return fake.ForceIsOn; }));
}

TEST_F(ForceDimension, AReadThatFailsCutsTheForce)
{
  this->Break([](FakeForceDimension& fake) { fake.FailsToRead = true; }, "communication error");
  EXPECT_TRUE(this->IsQuiet());
}

TEST_F(ForceDimension, AWriteThatFailsIsAFault)
{
  // The library rejects even a force of zero, so only its watchdog can end the force.
  this->Break([](FakeForceDimension& fake) { fake.FailsToWrite = true; }, "does not take a force");
}

TEST_F(ForceDimension, APositionThatIsNoNumberCutsTheForce)
{
  this->Break([](FakeForceDimension& fake) { fake.TellsNonsense = true; }, "impossible position");
  EXPECT_TRUE(this->IsQuiet());
}

TEST_F(ForceDimension, ADeviceInUseElsewhereIsAnErrorWithACure)
{
  this->With([](FakeForceDimension& fake) { fake.FailsToOpen = true; });
  const std::string error = ErrorOf("vendor:forcedimension");
  EXPECT_TRUE(Has(error, "device already in use")) << error;
  EXPECT_TRUE(Has(error, "Close other programs")) << error;
  this->With([](FakeForceDimension& fake) { fake.Count = 0; });
  EXPECT_TRUE(Has(ErrorOf("vendor:forcedimension"), "has no device"));
}
