// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that the stylus's orientation passes through the loop, and that invalid orientations do
 * not. The force must not depend on the orientation.
 */

#include "Rigs/PlayedDevice.h"

#include <limits>
#include <vector>

using namespace servotest;

namespace
{
constexpr double Nan = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr std::uint64_t Ticks = 4000;

/// A device that rotates, and sometimes reports an invalid orientation.
class TurnedDevice : public PlayedDevice
{
public:
  explicit TurnedDevice(bool isTurned)
    : IsTurned(isTurned)
  {
  }

  struct Report
  {
    Quaternion Orientation;
    bool HasOrientation;
    bool IsGood;
  };
  static Report ReportOf(std::uint64_t tick)
  {
    const double half = 1e-3 * static_cast<double>(tick);
    const Quaternion good{ std::cos(half), 0.0, 0.6 * std::sin(half), 0.8 * std::sin(half) };
    switch (tick % 8)
    {
      case 1:
        return { { Nan, 0.0, 0.0, 0.0 }, true, false };
      case 2:
        return { 1.005 * good, true, true };
      case 3:
        return { { 0.0, 0.0, 0.0, 0.0 }, true, false };
      case 4:
        return { { 1.0, Infinity, 0.0, 0.0 }, true, false };
      case 5:
        return { 2.0 * good, true, false };
      case 6:
        return { { Nan, Nan, Nan, Nan }, false, false };
      default:
        return { good, true, true };
    }
  }
  DeviceState Read(double period, DeviceSample& sample) noexcept override
  {
    if (this->IsTurned)
    {
      const Report report = ReportOf(this->Reads.load());
      sample.Orientation = report.Orientation;
      sample.HasOrientation = report.HasOrientation;
    }
    return PlayedDevice::Read(period, sample);
  }

private:
  const bool IsTurned;
};

/// Runs a loop with a model. Returns all its ticks.
std::vector<ServoSnapshot> AllTicks(PlayedDevice& device, const TestVolume& volume)
{
  ServoLoop loop(device, 5000.0);
  loop.SetLimits(QuickLimits());
  loop.Publish(std::make_shared<HapticModel>(Describe(volume)));
  loop.SetRecording(true);
  std::vector<ServoSnapshot> ticks;
  std::thread thread;
  {
    const ReaderPace pace(device);
    thread = std::thread([&loop] { loop.Run(); });
    EXPECT_TRUE(Eventually(
      [&]
      {
        pace.Drain(&loop, [&](const ServoSnapshot& tick) { ticks.push_back(tick); });
        return ticks.size() >= Ticks;
      }));
    loop.RequestStop();
  }
  thread.join();
  EXPECT_EQ(loop.GetLostRecords(), 0u);
  return ticks;
}
} // namespace

TEST(Orientation, PassesAsAUnitQuaternionOrNotAtAll)
{
  TurnedDevice device(true);
  const TestVolume volume = MakeRamp();
  for (const ServoSnapshot& tick : AllTicks(device, volume))
  {
    const TurnedDevice::Report report = TurnedDevice::ReportOf(tick.Tick);
    ASSERT_EQ(tick.HasOrientation, report.IsGood) << tick.Tick;
    const Quaternion wanted =
      report.IsGood ? TurnedDevice::ReportOf(tick.Tick - tick.Tick % 8).Orientation : Quaternion{};
    ASSERT_NEAR(SquaredNorm(tick.Orientation), 1.0, 1e-14) << tick.Tick;
    const double cosine = wanted.W * tick.Orientation.W + wanted.X * tick.Orientation.X +
      wanted.Y * tick.Orientation.Y + wanted.Z * tick.Orientation.Z;
    // In eight ticks, the orientation rotates by at most 8e-3 rad about one axis.
    ASSERT_GT(cosine, std::cos(9e-3)) << tick.Tick;
    if (report.IsGood && tick.Tick % 8 != 2)
    {
      ASSERT_TRUE(IsIdentical(tick.Orientation, report.Orientation)) << "to the bit";
    }
    ASSERT_TRUE(IsIdentical(tick.Torque, {}));
  }
}

TEST(Orientation, IsThatOfTheLastTickWhileTheDeviceIsSilent)
{
  /// A device that reports an orientation once.
  class OnceTurned : public PlayedDevice
  {
  public:
    DeviceState Read(double period, DeviceSample& sample) noexcept override
    {
      if (this->Reads.load() == 5)
      {
        sample.Orientation = { 0.0, 0.0, 1.0, 0.0 };
        sample.HasOrientation = true;
      }
      return PlayedDevice::Read(period, sample);
    }
  };
  OnceTurned device;
  const TestVolume volume = MakeRamp();
  for (const ServoSnapshot& tick : AllTicks(device, volume))
  {
    ASSERT_EQ(tick.HasOrientation, tick.Tick >= 5) << tick.Tick;
    ASSERT_EQ(tick.Orientation.Y, tick.Tick >= 5 ? 1.0 : 0.0) << tick.Tick;
  }
}

TEST(Orientation, ChangesNoForce)
{
  const TestVolume volume = MakeRamp();
  TurnedDevice turned(true);
  TurnedDevice still(false);
  const std::vector<ServoSnapshot> with = AllTicks(turned, volume);
  const std::vector<ServoSnapshot> without = AllTicks(still, volume);
  double largest = 0.0;
  for (std::uint64_t i = 0; i < Ticks; ++i)
  {
    ASSERT_EQ(with[i].Tick, without[i].Tick);
    ASSERT_TRUE(IsIdentical(with[i].Record.Force, without[i].Record.Force)) << i;
    ASSERT_TRUE(IsIdentical(with[i].Record.Proxy, without[i].Record.Proxy)) << i;
    ASSERT_FALSE(without[i].HasOrientation);
    largest = std::max(largest, Norm(with[i].Record.Force));
  }
  EXPECT_GT(largest, 0.5) << "nothing was touched";
}

TEST(Orientation, ADeviceWithTorqueGetsTheWholeCommand)
{
  /// A device that accepts force and torque.
  class TorqueDevice : public PlayedDevice
  {
  public:
    DeviceState Send(const DeviceCommand& command) noexcept override
    {
      this->Torque.store(this->Torque.load() + Norm(command.Torque));
      this->Sends.fetch_add(1);
      return this->Write(command.Force);
    }
    std::atomic<double> Torque{ 0.0 };
    std::atomic<std::uint64_t> Sends{ 0 };
  };
  TorqueDevice device;
  AllTicks(device, MakeRamp());
  EXPECT_EQ(device.Sends.load(), device.Writes.load()) << "by that one way, also at the end";
  EXPECT_EQ(device.Torque.load(), 0.0) << "nothing gives torque yet";
}
