// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests published force-feedback firmwares: the force acts along the requested axis with the
 * requested sign, as computed by the firmware's own arithmetic.
 */

#include "DeviceBench.h"
#include "Emulators/ArduinoFfbModel.h"
#include "Emulators/EmulatedHid.h"
#include "Emulators/ModelClock.h"
#include "Emulators/OpenFfboardModel.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

using namespace emulated;

namespace
{
using Kind = OpenFfboardModel::Kind;
using Version = OpenFfboardModel::Version;

/** A model that is plugged in, and a driver that has opened it. */
template <typename Model>
class Bench
{
public:
  /// @param second force (N) at full scale of the second axis; 0 if that axis has no motor
  template <typename... Arguments>
  explicit Bench(double second, Arguments... arguments)
    : Device(arguments...)
  {
    this->Options.NewtonsPerFullScale = { FfbHandle::FullScale, second };
  }
  void MakeReady()
  {
    ASSERT_TRUE(this->Hid.Open("pid", this->Options)) << this->Hid.Error;
    ASSERT_TRUE(this->Hid.WaitFor(DeviceStage::Ready)) << this->Hid.Text();
  }
  /// Requests a force (N) through the servo. Returns whether the hand receives it.
  bool Gets(const Vector3& force, double tolerance = 0.01)
  {
    return Eventually(
      [&]
      {
        DeviceSample sample;
        this->Hid.Device->Read(0.001, sample);
        this->Hid.Device->Write(force);
        this->Tip = sample.Tip;
        return IsNear(this->Device.GetForce(), { force.X, force.Y, 0.0 }, tolerance);
      });
  }
  std::string Says() const
  {
    const Triple force = this->Device.GetForce();
    return std::to_string(force[0]) + ", " + std::to_string(force[1]) + " N";
  }

  Model Device;
  EmulatedHid Plug{ this->Device };
  ModelClock Clock{ [this] { this->Device.Step(); } };
  DeviceOptions Options;
  DeviceBench Hid;
  Vector3 Tip;
};

template <typename Model>
void ExpectEachDirection(Bench<Model>& bench, bool hasSecond, double leak)
{
  ASSERT_NO_FATAL_FAILURE(bench.MakeReady());
  for (const double newtons : { 1.0, -1.0 })
  {
    EXPECT_TRUE(bench.Gets({ newtons, 0.0, 0.0 }, leak)) << newtons << ": " << bench.Says();
    EXPECT_TRUE(!hasSecond || bench.Gets({ 0.0, newtons, 0.0 }, leak))
      << newtons << ": " << bench.Says();
  }
  EXPECT_TRUE(!hasSecond || bench.Gets({ 0.6, -0.8, 0.0 }, leak)) << bench.Says();
  EXPECT_TRUE(bench.Gets({})) << bench.Says();
}
} // namespace

TEST(PidFirmware, AnOpenFfboardWheelIsPushedTheRightWay)
{
  for (const Kind kind : { Kind::Wheel, Kind::OneAxisWheel })
  {
    SCOPED_TRACE(kind == Kind::Wheel ? "descriptor of two axes" : "descriptor of one axis");
    Bench<OpenFfboardModel> bench(0.0, kind);
    ExpectEachDirection(bench, false, 0.01);
    EXPECT_EQ(bench.Hid.Device->GetLimits().MaximumForce, FfbHandle::FullScale);
  }
}

TEST(PidFirmware, AnOpenFfboardStickIsPushedTheRightWayAlongBothAxes)
{
  Bench<OpenFfboardModel> bench(FfbHandle::FullScale, Kind::Joystick);
  ExpectEachDirection(bench, true, 0.01);
}

TEST(PidFirmware, AnArduinoStickIsPushedTheRightWayAlongBothAxes)
{
  // The firmware divides a circle into 255 parts, so 90 degrees become 90.35.
  Bench<ArduinoFfbModel> bench(FfbHandle::FullScale, 2);
  ExpectEachDirection(bench, true, 0.03);
}

TEST(PidFirmware, AnArduinoWithAnotherProgramIsNotTakenForTheLibrary)
{
  class OtherProgram : public OpenFfboardModel
  {
  public:
    std::uint16_t GetVendor() const override { return 0x2341; }
    std::uint16_t GetProduct() const override { return 0x8036; }
    std::string GetName() const override { return "Arduino Leonardo"; }
  };
  {
    Bench<OtherProgram> bench(FfbHandle::FullScale);
    const std::string error = ErrorOf("pid", bench.Options);
    EXPECT_TRUE(Has(error, "two axes")) << error;
  }
  Bench<OtherProgram> wheel(0.0);
  ExpectEachDirection(wheel, false, 0.01);
}

TEST(PidFirmware, AnArduinoWheelIsPushedTheRightWay)
{
  Bench<ArduinoFfbModel> bench(0.0, 1);
  ExpectEachDirection(bench, false, 0.03);
}

TEST(PidFirmware, TheHandLeadsTheTipTheSameWay)
{
  Bench<OpenFfboardModel> bench(FfbHandle::FullScale, Kind::Joystick);
  ASSERT_NO_FATAL_FAILURE(bench.MakeReady());
  bench.Device.SetGoal(0.02, 0.01);
  EXPECT_TRUE(Eventually(
    [&]
    {
      bench.Gets({});
      return Norm(bench.Tip - Vector3{ 0.02, 0.01, 0.0 }) < 1e-4;
    }))
    << bench.Tip.X << " " << bench.Tip.Y;
}

TEST(PidFirmware, APedalDoesNotMoveAWheelsTip)
{
  Bench<OpenFfboardModel> bench(0.0, Kind::Wheel);
  ASSERT_NO_FATAL_FAILURE(bench.MakeReady());
  bench.Device.Pedal = 0.7;
  bench.Device.SetGoal(0.02, 0.0);
  EXPECT_TRUE(Eventually(
    [&]
    {
      bench.Gets({});
      return bench.Tip.X > 0.0199;
    }));
  EXPECT_EQ(bench.Tip.Y, 0.0);
}

TEST(PidFirmware, AnOldOpenFfboardIsDrivenAlongItsFirstAxisOnly)
{
  // Old versions differ in the sign of y. Only newer versions can be recognised by their name.
  {
    Bench<OpenFfboardModel> bench(FfbHandle::FullScale, Kind::Joystick, Version::V1_16_0);
    const std::vector<DeviceListing> all = ListDevices();
    ASSERT_EQ(all.size(), 1U);
    EXPECT_TRUE(Has(all[0].State, "refused: it has two axes")) << all[0].State;
    const std::string error = ErrorOf("pid", bench.Options);
    EXPECT_TRUE(Has(error, "FFBoard (")) << error;
    EXPECT_TRUE(Has(error, "two axes")) << error;
    EXPECT_TRUE(Has(error, "1.16.5")) << error;
    EXPECT_EQ(bench.Device.GetResets(), 0) << "nothing was sent";
  }
  for (const Kind kind : { Kind::Wheel, Kind::Joystick })
  {
    Bench<OpenFfboardModel> bench(0.0, kind, Version::V1_16_0);
    ExpectEachDirection(bench, false, 0.01);
  }
}

TEST(PidFirmware, ADeviceThatRepeatsItselfRarelyMayRest)
{
  Bench<OpenFfboardModel> bench(0.0, Kind::Wheel);
  ASSERT_NO_FATAL_FAILURE(bench.MakeReady());
  // At rest, the device reports ten times a second. Wait for about 40 reports.
  for (int i = 0; i < 400; ++i)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ASSERT_EQ(bench.Hid.Device->GetCondition().Stage, DeviceStage::Ready) << bench.Hid.Text();
  }
}
