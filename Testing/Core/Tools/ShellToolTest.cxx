// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a tool with a shape as the tool of a model: in world units, across changes of the model,
 * and from a stored state with its contacts.
 */

#include "Core/Servo/ServoTick.h"
#include "Core/State/ServoStateNumbers.h"
#include "Core/Tools/Needle/BakedNeedle.h"
#include "Rigs/ShellRig.h"

#include <gtest/gtest.h>

using namespace coretest;

namespace
{
constexpr double ToolRadius = 5.0;
constexpr double RampSurface = 10.0;

/// Returns the points of a sphere in world units: millimetres and square millimetres.
std::vector<ShellPoint> MakeWorldSphere(double radius, int count)
{
  std::vector<ShellPoint> points = MakeSphere(radius, count);
  for (ShellPoint& point : points)
  {
    point.Position = 1e3 * point.Position;
    point.Area *= 1e6;
  }
  return points;
}

/// A hand that runs the ticks of a model as the servo does.
class ToolHand
{
public:
  explicit ToolHand(std::shared_ptr<const HapticModel> model)
    : Model(std::move(model))
    , Memory(ToolMemory::Provide(*this->Model->Baked, nullptr))
  {
  }

  const TickRecord& Tick(const Vector3& world, const Quaternion& turn = {})
  {
    return this->TickAt(this->Model->WorldToDevice(world), turn);
  }
  const TickRecord& TickAt(const Vector3& tip, const Quaternion& turn = {})
  {
    this->State.Orientation = turn;
    this->State.HasOrientation = true;
    VolumeHaptics::Tick(*this->Model, this->State, tip, this->Record,
      LocalSurfaceResult::Simulated(), &this->Taps, this->Memory.get());
    return this->Record;
  }
  /// Moves the tip straight to a goal (world units), by at most `step` per tick.
  const TickRecord& Lead(const Vector3& goal, double step = 0.05)
  {
    const Vector3 from = this->Model->DeviceToWorld(this->Record.Tip);
    const double steps = std::ceil(Norm(goal - from) / step);
    for (double i = 1.0; i <= steps; i += 1.0)
    {
      this->Tick(from + (i / steps) * (goal - from), this->State.Orientation);
    }
    return this->Record;
  }
  const TickRecord& Rest(int ticks = 50)
  {
    for (int i = 0; i < ticks; ++i)
    {
      this->TickAt(Vector3(this->Record.Tip), Quaternion(this->State.Orientation));
    }
    return this->Record;
  }
  void Publish(std::shared_ptr<const HapticModel> model)
  {
    auto memory = ToolMemory::Provide(*model->Baked, this->Memory);
    CarryState(*this->Model, *model, this->State, memory.get());
    this->Memory = memory ? memory : this->Memory;
    this->Model = std::move(model);
  }
  /// Returns the energy (J) in the springs between tool and hand.
  double GetStored() const
  {
    const ShellSettings& touch = ShapedTool::Find(*this->Model->Baked)->Description.Touch;
    return ComputeCouplingEnergy(
      touch, this->Model->Caps, this->State.Shell.Tool, this->State.Shell.Hand);
  }

  std::shared_ptr<const HapticModel> Model;
  std::shared_ptr<ToolMemory> Memory;
  TickMemory Taps;
  ServoState State;
  TickRecord Record;
};

class ShellTool : public testing::Test
{
protected:
  ShellTool()
  {
    this->Tool.Points = std::make_shared<const PointShell>(MakeWorldSphere(ToolRadius, 10000));
    this->Tool.Touch.Level = 100.0 * RampSurface;
    this->Tool.Touch.ContactArea = 25.0;
  }

  std::shared_ptr<const HapticModel> Make() const { return Make(this->Scene, this->Tool); }
  static std::shared_ptr<const HapticModel> Make(
    HapticModelDescription scene, const ShellDescription& tool)
  {
    scene.Tool = std::make_shared<const BakedShell>(tool);
    return std::make_shared<const HapticModel>(scene);
  }
  void SetShell(std::vector<ShellPoint> points)
  {
    this->Tool.Points = std::make_shared<const PointShell>(std::move(points));
  }
  /// Returns a hand at rest that presses into the tissue, 2 mm deep.
  ToolHand Press()
  {
    ToolHand hand(this->Make());
    hand.Tick(this->Above);
    hand.Lead(this->Above + Vector3{ 0.0, 0.0, 3.0 });
    hand.Rest();
    return hand;
  }

  const TestVolume Volume = MakeRamp();
  HapticModelDescription Scene = Describe(this->Volume); ///< without the tool
  ShellDescription Tool;
  const Vector3 Above{ 12.0, 12.0, RampSurface - ToolRadius - 1.0 };
};
} // namespace

/// S3 of the design: k (2 mm - delta) = pi kappa a delta^2 gives a force of 0.4211 N.
TEST_F(ShellTool, HasTheForceOfASphere)
{
  ToolHand hand = this->Press();
  EXPECT_NEAR(hand.Record.Force.Z, -0.4211, 0.4211e-2);
  EXPECT_NEAR(hand.Record.NormalForce, 0.4211, 0.4211e-2);
  EXPECT_EQ(hand.Record.Contact, ContactState::Sticking);
  EXPECT_LE(Norm(hand.Record.Torque), 1e-5);
  // The proxy is the tool's origin, which is 1.1578 mm deep.
  EXPECT_NEAR(hand.Record.Proxy.Z, 1e-3 * (RampSurface - ToolRadius + 1.1578), 1e-5);
  EXPECT_NEAR(std::abs(hand.Record.ToolOrientation.W), 1.0, 1e-9);
  EXPECT_EQ(hand.Record.SurfaceValue, hand.Model->ValueAtDevice(hand.Record.Proxy));
}

/// The tool must keep its size in the world for any scale of the device. If a device's motion
/// appears half as large in the world, the contact area is four times as large on the device.
TEST_F(ShellTool, HasItsSizeInTheWorld)
{
  for (const double scale : { 0.5, 2.0 })
  {
    this->Scene.DeviceToWorld.Linear = (1000.0 / scale) * Matrix3{};
    ToolHand hand(this->Make());
    hand.Tick(this->Above);
    hand.Lead(this->Above + Vector3{ 0.0, 0.0, 3.0 });
    hand.Rest();
    const double b = 500.0 / (Pi * Kappa / (scale * scale) * scale * 5e-3);
    const double delta = 0.5 * (std::sqrt(b * b + 4.0 * b * scale * 2e-3) - b);
    const double expected = 500.0 * (scale * 2e-3 - delta);
    EXPECT_NEAR(hand.Record.Force.Z, -expected, 0.01 * expected) << scale;
  }
}

TEST_F(ShellTool, IsAPointWithoutItsMemory)
{
  const auto model = this->Make();
  const auto point = std::make_shared<const HapticModel>(this->Scene);
  ServoState states[2];
  TickRecord records[2];
  for (int i = 0; i < 400; ++i)
  {
    const Vector3 tip{ 0.012, 0.012 + 1e-5 * i, 0.001 + 3e-5 * i };
    Tick(*model, states[0], tip, records[0]);
    Tick(*point, states[1], tip, records[1]);
    ASSERT_TRUE(IsIdentical(records[0].Force, records[1].Force));
  }
  EXPECT_GT(records[1].NormalForce, 0.1);
}

TEST_F(ShellTool, IsHeldAsLastByADeviceWithoutOrientation)
{
  ToolHand hand = this->Press();
  const Quaternion turn = TurnAbout({ 1.0, 2.0, 0.5 }, 0.2);
  for (int i = 0; i < 60; ++i)
  {
    hand.TickAt(Vector3(hand.Record.Tip), turn);
  }
  hand.State.HasOrientation = false;
  hand.State.Orientation = {};
  Tick(*hand.Model, hand.State, Vector3(hand.Record.Tip), hand.Record,
    LocalSurfaceResult::Simulated(), nullptr, hand.Memory.get());
  EXPECT_TRUE(IsIdentical(hand.State.Shell.Hand.Orientation, turn));
}

/// With another material or other settings, the tool must stay in contact, and the springs must
/// have at most the energy that they had before.
TEST_F(ShellTool, GoesOnWithAnotherMaterial)
{
  const struct
  {
    double Stiffness;
    double Strength;
    double Coupling;
  } cases[] = { { 500.0, 2.0, 500.0 }, { 1500.0, 2.0, 500.0 }, { 100.0, 2.0, 500.0 },
    { 500.0, 0.05, 500.0 }, { 500.0, 2.0, 1500.0 }, { 500.0, 2.0, 100.0 }, { 0.0, 0.0, 500.0 } };
  for (const auto& next : cases)
  {
    ToolHand hand = this->Press();
    const double stored = hand.GetStored();
    const double pressed = hand.State.Shell.Sum.Energy;
    const double before = hand.Record.NormalForce;
    HapticModelDescription scene = this->Scene;
    scene.Material.Stiffness = ConstantPolyline(next.Stiffness);
    scene.Material.SurfaceStrength = ConstantPolyline(next.Strength);
    ShellDescription tool = this->Tool;
    tool.Touch.CouplingStiffness = next.Coupling;
    hand.Publish(Make(scene, tool));
    hand.Rest(1);
    EXPECT_TRUE(hand.State.Enabled);
    // Energy of the springs plus energy of the contacts.
    EXPECT_LE(hand.GetStored() + hand.State.Shell.Sum.Energy, (stored + pressed) * 1.0001)
      << next.Stiffness << " " << next.Strength << " " << next.Coupling;
    hand.Rest(20);
    EXPECT_LE(hand.GetStored() + hand.State.Shell.Sum.Energy, (stored + pressed) * 1.0001);
    if (next.Stiffness == 500.0 && next.Strength == 2.0 && next.Coupling == 500.0)
    {
      EXPECT_NEAR(hand.Record.NormalForce, before, 1e-3 * before) << "nothing has changed";
    }
    else if (next.Strength > 0.0)
    {
      EXPECT_GT(hand.Record.NormalForce, 0.02) << "it is still held";
    }
    else
    {
      EXPECT_EQ(hand.Record.NormalForce, 0.0) << "nothing holds it";
    }
  }
}

/// Only the placement of the device in the world changes. Hand and tool keep their positions in the
/// world.
TEST_F(ShellTool, GoesAlongWithTheDevicesPlacement)
{
  ToolHand hand = this->Press();
  const Vector3 world = hand.Model->DeviceToWorld(hand.Record.Tip);
  const Vector3 force = hand.Record.Force;
  const Quaternion turn = TurnAbout({ 0.2, 1.0, -0.4 }, 1.1);
  for (const double scale : { 1.0, 1.25 })
  {
    ToolHand moved = hand;
    moved.Memory = std::make_shared<ShapedMemory>(static_cast<const ShapedMemory&>(*hand.Memory));
    Affine3 placed;
    placed.Linear = (1000.0 / scale) * ToMatrix(turn);
    placed.Offset = { 3.0, -7.0, 2.0 };
    moved.Publish(std::make_shared<const HapticModel>(*hand.Model, placed, ForceCaps{}));
    // Move the hand to its old position and orientation in the world.
    moved.Tick(world, Conjugate(turn));
    const Vector3 felt = ToMatrix(turn) * moved.Record.Force;
    EXPECT_NEAR(felt.Z, scale * force.Z, 0.002) << "a spring that is longer by the scale";
    EXPECT_NEAR(std::hypot(felt.X, felt.Y), 0.0, 0.002);
    moved.Rest();
    const Vector3 rested = ToMatrix(turn) * moved.Record.Force;
    EXPECT_NEAR(rested.Z, scale * force.Z, 0.003);
  }
}

/// After a change to another tool, another shape or another volume, no force may act until the hand
/// moves.
TEST_F(ShellTool, IsSwitchedUnderForce)
{
  const auto point = std::make_shared<const HapticModel>(this->Scene);
  HapticModelDescription scene = this->Scene;
  scene.Tool = std::make_shared<const BakedNeedle>(NeedleDescription{});
  const auto needle = std::make_shared<const HapticModel>(scene);
  ShellDescription smallerTool = this->Tool;
  smallerTool.Points = std::make_shared<const PointShell>(MakeWorldSphere(0.9 * ToolRadius, 500));
  const auto smaller = Make(this->Scene, smallerTool);
  const TestVolume copy = MakeRamp();
  scene = this->Scene;
  scene.View = copy.View;
  const auto other = Make(scene, this->Tool);
  for (const auto& next : { point, needle, smaller, other })
  {
    ToolHand hand = this->Press();
    ASSERT_GT(hand.Record.NormalForce, 0.4);
    hand.Publish(next);
    hand.Rest(1);
    EXPECT_EQ(Norm(hand.Record.Force), 0.0);
    EXPECT_EQ(Norm(hand.Record.Torque), 0.0);
    // Change back to the first tool while a force acts.
    const double deeper = next == point || next == needle ? 5.5 : 3.0;
    hand.Lead(this->Above);
    hand.Lead(this->Above + Vector3{ 0.0, 0.0, deeper });
    hand.Publish(this->Make());
    hand.Rest(1);
    EXPECT_EQ(Norm(hand.Record.Force), 0.0);
    hand.Lead(this->Above);
    hand.Lead(this->Above + Vector3{ 0.0, 0.0, 3.0 });
    hand.Rest();
    EXPECT_NEAR(hand.Record.NormalForce, 0.4211, 0.4211e-2);
  }
}

/// Publish random models under a random hand. While a model stays, the hand must get at most the
/// energy that it has put in, and publishing a model must add none.
TEST_F(ShellTool, NoModelGivesEnergy)
{
  this->SetShell(MakeWorldSphere(4.0, 300));
  std::mt19937_64 engine(5);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  ToolHand hand(this->Make());
  Vector3 at = this->Above;
  Vector3 speed;
  double felt = 0.0;
  int carried = 0;
  hand.Tick(at);
  double paid = 0.0; // upper bound (J) of the energy that hand and models may get back
  for (int i = 0; i < 40000; ++i)
  {
    if (i % 100 == 99)
    {
      this->Scene.Material.Stiffness = ConstantPolyline(50.0 + 1500.0 * uniform(engine));
      this->Scene.Material.SurfaceStrength = ConstantPolyline(3.0 * uniform(engine));
      this->Tool.Touch.CouplingStiffness = 100.0 + 900.0 * uniform(engine);
      this->Tool.Touch.TurningStiffness = 0.05 + uniform(engine);
      this->Tool.Touch.ContactArea = 5.0 + 50.0 * uniform(engine);
      this->Tool.Touch.Level = 950.0 + 100.0 * uniform(engine);
      hand.Publish(this->Make());
      const double after = hand.GetStored();
      EXPECT_LE(after, paid + 1e-12) << "publishing costs nothing";
      paid = std::min(paid, hand.State.Shell.Budget);
      carried += hand.State.Shell.Enabled && after > 1e-6 ? 1 : 0;
    }
    speed = 0.97 * speed + 0.01 * RandomIn(engine, 1.0);
    speed += 2e-3 * (this->Above + Vector3{ 0.0, 0.0, 2.5 } - at);
    at = at + speed;
    const ShellPose tool = hand.State.Shell.Tool;
    const ShellPose last = hand.State.Shell.Hand;
    const ShellPose next{ hand.Model->WorldToDevice(at), TurnAbout({ 1.0, 0.3, 0.2 }, 1e-4 * i) };
    const auto energyOf = [&](const ShellPose& at)
    { return ComputeCouplingEnergy(this->Tool.Touch, hand.Model->Caps, tool, at); };
    // Add the work of the hand while the tool rests.
    paid += hand.State.Shell.Enabled ? energyOf(next) - energyOf(last) : 0.0;
    hand.TickAt(next.Position, next.Orientation);
    ASSERT_LE(hand.GetStored(), paid + 1e-9) << i;
    felt = std::max(felt, hand.Record.NormalForce);
    if (hand.State.Shell.Sum.Contacts == 0)
    {
      paid = hand.GetStored();
    }
  }
  EXPECT_GT(felt, 0.3);
  EXPECT_GT(carried, 50);
}

/// From a stored state with its contacts, all further ticks must be equal, to the bit.
TEST_F(ShellTool, GoesOnFromWhatWasKept)
{
  this->SetShell(MakeWorldSphere(4.0, 700));
  for (const int begin : { 1, 100, 101, 170 })
  {
    ToolHand live(this->Make());
    std::unique_ptr<ToolHand> replay;
    std::mt19937_64 engine(8);
    int pressed = 0;
    for (int i = 0; i < 1000; ++i)
    {
      const double depth = 4.0 * std::sin(1e-2 * i);
      const Vector3 at = this->Above + Vector3{ 1e-3 * i, 0.3 * std::sin(0.02 * i), depth };
      const Quaternion turn = TurnAbout({ 0.3, 1.0, 0.2 }, 2e-3 * i);
      const auto placed = i == 180
        ? std::make_shared<const HapticModel>(*live.Model,
            Affine3{ 1010.0 * ToMatrix(TurnAbout({ 1.0, 0.0, 0.0 }, 0.02)), { 0.1, 0.2, 0.0 } },
            ForceCaps{})
        : nullptr;
      if (placed)
      {
        live.Publish(placed);
        replay->Publish(
          std::make_shared<const HapticModel>(*replay->Model, placed->DeviceToWorld, ForceCaps{}));
      }
      if (i == begin)
      {
        live.Memory->Keep();
        const ShellContacts& kept = *FindKeptContacts(live.Memory.get());
        replay = std::make_unique<ToolHand>(this->Make());
        replay->State = FromNumbers(ToNumbers(live.State));
        EXPECT_TRUE(AreOfAState(ToNumbers(live.State)));
        EXPECT_EQ(kept.Count > 0, begin >= 100);
        ASSERT_TRUE(RestoreContacts(*replay->Memory, *replay->Model->Baked,
          { kept.List.begin(), kept.List.begin() + static_cast<std::ptrdiff_t>(kept.Count) },
          kept.Fraction));
      }
      live.Tick(at, turn);
      if (replay)
      {
        replay->Tick(at, turn);
        ASSERT_TRUE(IsIdentical(live.Record.Force, replay->Record.Force)) << i;
        ASSERT_TRUE(IsIdentical(live.Record.Torque, replay->Record.Torque)) << i;
        ASSERT_TRUE(IsIdentical(live.Record.Proxy, replay->Record.Proxy)) << i;
        ASSERT_TRUE(IsIdentical(live.Record.ToolOrientation, replay->Record.ToolOrientation)) << i;
        pressed += live.Record.NormalForce > 0.05 ? 1 : 0;
      }
    }
    EXPECT_GT(pressed, 100);
  }
}

TEST_F(ShellTool, WhatWasKeptOfAnotherToolIsRefused)
{
  this->SetShell(MakeWorldSphere(4.0, 100));
  const auto model = this->Make();
  const auto memory = ToolMemory::Provide(*model->Baked, nullptr);
  ShellContact contact{};
  contact.Point = 7;
  EXPECT_TRUE(RestoreContacts(*memory, *model->Baked, { contact }, 1.0));
  EXPECT_FALSE(RestoreContacts(*memory, *model->Baked, { contact, contact }, 1.0)) << "one twice";
  contact.Point = 100;
  EXPECT_FALSE(RestoreContacts(*memory, *model->Baked, { contact }, 1.0)) << "no such point";
  contact.Point = 7;
  this->SetShell(MakeWorldSphere(4.0, 100));
  EXPECT_FALSE(RestoreContacts(*memory, *this->Make()->Baked, { contact }, 1.0)) << "another shell";
}

TEST_F(ShellTool, ModelsWithTheSameShellShareItsMemory)
{
  const auto first = this->Make();
  const auto memory = ToolMemory::Provide(*first->Baked, nullptr);
  ASSERT_TRUE(memory);
  this->Scene.Material.Stiffness = ConstantPolyline(200.0);
  EXPECT_EQ(ToolMemory::Provide(*this->Make()->Baked, memory), memory);
  this->SetShell(MakeWorldSphere(4.0, 100));
  EXPECT_NE(ToolMemory::Provide(*this->Make()->Baked, memory), memory);
  const HapticModel point(this->Scene);
  EXPECT_EQ(ToolMemory::Provide(*point.Baked, memory), nullptr);
}
