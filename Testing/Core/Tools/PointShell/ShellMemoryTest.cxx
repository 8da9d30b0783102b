// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that ticks of a shell never allocate memory.
 */

#include "Rigs/AllocationCounter.h"
#include "Rigs/ShellRig.h"

#include <gtest/gtest.h>

using namespace coretest;

TEST(ShellMemoryUse, NoTickAllocates)
{
  TestVolume volume(ScalarType::Float32, { 24, 24, 24 });
  std::mt19937_64 engine(3);
  volume.Fill<float>(
    [&](std::int64_t, std::int64_t, std::int64_t k)
    {
      const auto dice = engine() % 1000;
      return dice == 0 ? std::numeric_limits<float>::quiet_NaN() : 70.0F * k + 0.1F * dice;
    });
  HapticModelDescription scene = Describe(volume);
  ShellSettings settings;
  settings.Level = 800.0;
  ShellHand hand(scene, MakeSphere(3.0, 400), settings);
  Wanderer wanderer(24.0);
  double most = 0.0;
  const std::size_t before = CountAllocations().Calls;
  for (int i = 0; i < 3000; ++i)
  {
    ShellPose pose{ wanderer.Next(), TurnAbout({ 1.0, 0.4, 0.2 }, 0.002 * i) };
    pose.Position.X = i % 997 == 0 ? std::numeric_limits<double>::quiet_NaN() : pose.Position.X;
    most = std::max(most, Norm(hand.TickAt(pose).Force));
  }
  EXPECT_EQ(CountAllocations().Calls, before);
  EXPECT_GT(most, 0.01);
}

/// Uses a shell as the tool of models. Changes the model, and copies states for recordings.
TEST(ShellMemoryUse, NoTickOfAToolAllocates)
{
  const TestVolume volume = MakeRamp();
  HapticModelDescription scene = Describe(volume);
  std::vector<ShellPoint> points = MakeSphere(3.0, 400);
  for (ShellPoint& point : points)
  {
    point = { 1e3 * point.Position, 1e6 * point.Area };
  }
  ShellDescription tool;
  tool.Points = std::make_shared<const PointShell>(std::move(points));
  tool.Touch.Level = 1000.0;
  tool.Touch.ContactArea = 25.0;
  scene.Tool = std::make_shared<const BakedShell>(tool);
  const HapticModel first(scene);
  scene.Material.Stiffness = ConstantPolyline(900.0);
  scene.DeviceToWorld.Linear = 900.0 * Matrix3{};
  const HapticModel second(scene);
  const auto memory = ToolMemory::Provide(*first.Baked, nullptr);
  Wanderer wanderer(24.0);
  ServoState state;
  TickRecord record;
  double most = 0.0;
  const std::size_t before = CountAllocations().Calls;
  for (int i = 0; i < 3000; ++i)
  {
    const bool isSecond = i / 300 % 2 == 1;
    if (i % 300 == 0 && i > 0)
    {
      CarryState(isSecond ? first : second, isSecond ? second : first, state, memory.get());
    }
    if (i % 100 == 0)
    {
      memory->Keep();
    }
    Tick(isSecond ? second : first, state, wanderer.Next(), record, LocalSurfaceResult::Simulated(),
      nullptr, memory.get());
    most = std::max(most, record.NormalForce);
  }
  EXPECT_EQ(CountAllocations().Calls, before);
  EXPECT_GT(most, 0.01);
}
