// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a tool with a shape in a running loop. Force and torque must stay within their limits,
 * whatever model is published; the tool's memory must be freed with the models; a replay from a
 * stored state and its contacts must be equal, to the bit; and the program must be able to rotate a
 * hand whose device measures no orientation.
 */

#include "Core/State/ServoStateNumbers.h"
#include "Rigs/PlayedDevice.h"
#include "Rigs/ShellRig.h"

#include <vector>

using namespace servotest;

namespace
{
constexpr double MostTorque = 2e-4; // N m

/// A device that accepts torque. It measures no orientation, so only the loop rotates the tool.
class TorqueDevice : public PlayedDevice
{
public:
  DeviceState Send(const DeviceCommand& command) noexcept override
  {
    const double norm = Norm(command.Torque);
    this->LargestTorque = std::max(this->LargestTorque, norm);
    this->LargestTorqueGrowth = std::max(this->LargestTorqueGrowth, norm - this->LastTorque);
    this->LastTorque = norm;
    return this->Write(command.Force);
  }

  ///@{
  /// N m, once the loop has ended.
  double LargestTorque = 0.0;
  double LargestTorqueGrowth = 0.0;
  ///@}

private:
  double LastTorque = 0.0;
};

SafetyLimits TorqueLimits()
{
  SafetyLimits limits = QuickLimits();
  limits.MaximumTorque = MostTorque;
  limits.MaximumTorqueRate = 0.1;
  return limits;
}

std::shared_ptr<const PointShell> MakeTool(double radius)
{
  std::vector<ShellPoint> points = MakeSphere(radius, 300);
  for (ShellPoint& point : points)
  {
    // Place the shell beside the hand's point, so that contact rotates the tool.
    point = { 1e3 * point.Position + Vector3{ 1.0, 0.0, 0.0 }, 1e6 * point.Area };
  }
  return std::make_shared<const PointShell>(std::move(points));
}

HapticModelDescription DescribeTool(
  const TestVolume& volume, const std::shared_ptr<const PointShell>& shell, double coupling = 500.0)
{
  HapticModelDescription d = Describe(volume);
  ShellDescription tool;
  tool.Points = shell;
  tool.Touch.Level = 1000.0;
  tool.Touch.ContactArea = 25.0;
  tool.Touch.CouplingStiffness = coupling;
  d.Tool = shell ? std::make_shared<const BakedShell>(tool) : nullptr;
  return d;
}
} // namespace

TEST(ToolLoop, WhateverIsPublishedStaysWithinTheLimits)
{
  TorqueDevice device;
  const TestVolume volume = MakeRamp();
  std::vector<std::weak_ptr<const PointShell>> shells;
  std::shared_ptr<const PointShell> shell = MakeTool(3.0);
  {
    RunningLoop loop(device, 5000.0, TorqueLimits());
    loop->Arm();
    loop->TurnHand({});
    for (int i = 0; i < 400; ++i)
    {
      if (i % 10 == 9)
      {
        shells.push_back(shell);
        shell = MakeTool(2.0 + 0.1 * (i % 20));
      }
      HapticModelDescription d =
        DescribeTool(volume, i % 7 == 3 ? nullptr : shell, 300.0 + 100.0 * (i % 4));
      d.Material.Stiffness = ConstantPolyline(300.0 + 100.0 * (i % 5));
      d.DeviceToWorld.Offset = { 0.0, 0.0, i % 3 ? 0.0 : 0.1 };
      const std::uint64_t ticks = loop->GetTickCount();
      loop->Publish(i % 50 == 49 ? nullptr : std::make_shared<const HapticModel>(d));
      if (i % 2 == 0)
      {
        ASSERT_TRUE(Eventually([&] { return loop->GetTickCount() > ticks + 20; }));
      }
    }
    const std::uint64_t last = loop->Publish(nullptr);
    ASSERT_TRUE(Eventually([&] { return loop->GetAcknowledged() == last; }));
    loop->Publish(std::make_shared<const HapticModel>(DescribeTool(volume, shell)));
    ASSERT_TRUE(Eventually([&] { return loop->GetAcknowledged() == last + 1; }));
    loop->Collect();
    for (const auto& old : shells)
    {
      const auto isFreed = [&]
      {
        loop->Collect();
        return old.expired();
      };
      EXPECT_TRUE(Eventually(isFreed)) << "a tool that nobody has any more";
    }
    ASSERT_TRUE(Eventually([&] { return device.Force.load() > 0.2; }));
  }
  EXPECT_GT(device.LargestTorque, 0.5 * MostTorque);
  EXPECT_LE(device.LargestTorque, MostTorque * (1.0 + 1e-12));
  EXPECT_LE(device.LargestTorqueGrowth, 0.1 / 5000.0 * (1.0 + 1e-9));
  EXPECT_LE(device.LargestGrowth, QuickLimits().MaximumForceRate / 5000.0 * (1.0 + 1e-9));
}

TEST(ToolLoop, WhatIsKeptBeginsAReplay)
{
  TorqueDevice device;
  const TestVolume volume = MakeRamp();
  const auto model = std::make_shared<const HapticModel>(DescribeTool(volume, MakeTool(3.0)));
  std::vector<ServoSnapshot> ticks;
  std::vector<ShellContact> contacts;
  double share = 0.0;
  {
    RunningLoop loop(device, 5000.0, TorqueLimits());
    loop->Publish(model);
    ASSERT_TRUE(Eventually(
      [&]
      {
        loop->ReadState();
        return loop->GetState().Record.NormalForce > 0.5;
      }));
    const ReaderPace pace(device);
    loop->SetRecording(true);
    loop->KeepTool();
    const auto take = [&](const ServoSnapshot& tick)
    {
      if (tick.IsKept || !ticks.empty())
      {
        ticks.push_back(tick);
      }
    };
    ASSERT_TRUE(Eventually(
      [&]
      {
        pace.Drain(loop.operator->(), take);
        return ticks.size() > 3000;
      }));
    EXPECT_EQ(loop->GetLostRecords(), 0U);
    const ShellContacts& kept = *FindKeptContacts(loop->GetTool().get());
    contacts.assign(kept.List.begin(), kept.List.begin() + static_cast<std::ptrdiff_t>(kept.Count));
    share = kept.Fraction;
  }
  ASSERT_TRUE(ticks.front().IsKept);
  EXPECT_GT(contacts.size(), 10U);
  ServoState state = FromNumbers(ToNumbers(ticks.front().Before));
  const auto memory = ToolMemory::Provide(*model->Baked, nullptr);
  ASSERT_TRUE(RestoreContacts(*memory, *model->Baked, contacts, share));
  TickRecord record;
  for (const ServoSnapshot& tick : ticks)
  {
    if (!tick.Before.Enabled)
    {
      state.Enabled = false;
    }
    state.Orientation = tick.Before.Orientation;
    state.HasOrientation = tick.Before.HasOrientation;
    Tick(*model, state, tick.Record.Tip, record, LocalSurfaceResult::Simulated(), nullptr,
      memory.get());
    ASSERT_TRUE(IsIdentical(record.Force, tick.Record.Force)) << tick.Tick;
    ASSERT_TRUE(IsIdentical(record.Torque, tick.Record.Torque)) << tick.Tick;
    ASSERT_TRUE(IsIdentical(record.ToolOrientation, tick.Record.ToolOrientation)) << tick.Tick;
  }
}

/// The hand rotates through the smaller angle, at 4 rad/s.
TEST(ToolLoop, TurnsTheHandThatNothingMeasures)
{
  TorqueDevice device;
  RunningLoop loop(device, 1000.0);
  const auto orientation = [&]
  {
    loop->ReadState();
    return loop->GetState().Orientation;
  };
  EXPECT_TRUE(Eventually([&] { return loop->ReadState(); }));
  EXPECT_FALSE(loop->GetState().HasOrientation);
  loop->TurnHand(TurnAbout({ 0.0, 1.0, 0.0 }, 0.5));
  ASSERT_TRUE(Eventually([&] { return orientation().Y > 0.0; }));
  EXPECT_TRUE(loop->GetState().IsOrdered);
  EXPECT_NEAR(loop->GetState().Orientation.Y, std::sin(0.25), 1e-12) << "it begins there";
  loop->SetRecording(true);
  loop->TurnHand(TurnAbout({ 0.0, 1.0, 0.0 }, -0.3));
  ASSERT_TRUE(Eventually([&] { return orientation().Y < -0.149; }));
  std::vector<double> angles;
  for (ServoSnapshot tick; loop->Drain(tick);)
  {
    angles.push_back(2.0 * std::asin(tick.Orientation.Y));
  }
  ASSERT_GT(angles.size(), 150U);
  for (std::size_t i = 1; i < angles.size(); ++i)
  {
    ASSERT_LE(angles[i], angles[i - 1] + 1e-12);
    ASSERT_LE(angles[i - 1] - angles[i], 4e-3 * (1.0 + 1e-9));
  }
  loop->ForgetTurn();
  EXPECT_TRUE(Eventually(
    [&]
    {
      loop->ReadState();
      return !loop->GetState().HasOrientation;
    }));
}
