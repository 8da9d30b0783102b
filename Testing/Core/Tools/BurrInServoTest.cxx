// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a burr as the tool of a model: in a servo tick, with its size in the world, across changes
 * of the model, and from a stored state.
 */

#include "Core/Safety/EnergyObserver.h"
#include "Core/Servo/ServoTick.h"
#include "Core/State/ServoStateNumbers.h"
#include "Rigs/BurrRig.h"

#include <gtest/gtest.h>

using namespace coretest;

namespace
{
/// A hand that runs the ticks of a model as the servo does.
class ServoHand
{
public:
  explicit ServoHand(std::shared_ptr<const HapticModel> model)
    : Model(std::move(model))
    , Memory(ToolMemory::Provide(*this->Model->Baked, nullptr))
  {
    this->State.IsSpinning = true;
  }

  const TickRecord& Tick(const Vector3& world)
  {
    VolumeHaptics::Tick(*this->Model, this->State, this->Model->WorldToDevice(world), this->Record,
      LocalSurfaceResult::Simulated(), nullptr, this->Memory.get());
    this->Removed += this->Record.RemovedVolume;
    return this->Record;
  }
  /// Moves the tip so that the spring presses with `force` (N) along z, and runs a tick.
  const TickRecord& Press(double force)
  {
    Vector3 tip = this->Record.Tip;
    tip.Z = this->Record.Proxy.Z + force / 500.0;
    return this->Tick(this->Model->DeviceToWorld(tip));
  }
  void Publish(std::shared_ptr<const HapticModel> model)
  {
    auto memory = ToolMemory::Provide(*model->Baked, this->Memory);
    CarryState(*this->Model, *model, this->State, memory.get());
    this->Memory = std::move(memory);
    this->Model = std::move(model);
  }
  std::vector<std::uint8_t> GetFractions() const
  {
    return CopyTissue(
      this->Model->Baked->Removal->Bricks, this->Model->Baked->Field.GetView().Dimensions);
  }

  std::shared_ptr<const HapticModel> Model;
  std::shared_ptr<ToolMemory> Memory;
  ServoState State;
  TickRecord Record;
  double Removed = 0.0; ///< mm^3
};

class BurrOfModel : public testing::Test
{
protected:
  std::shared_ptr<const HapticModel> Make() const
  {
    HapticModelDescription scene = this->Half.Scene;
    scene.Tool = std::make_shared<const BakedBurr>(this->Burr);
    return std::make_shared<const HapticModel>(scene);
  }

  HalfSpace Half{ { 40, 40, 40 }, 0.4, 16 };
  const BurrInHand Settings = MakeBurr(5e9, 100.0);
  const Polyline Energies = ConstantPolyline(2.0);
  BurrDescription Burr = DescribeBurr(this->Settings, this->Energies);
  const Vector3 Above{ 7.9, 7.7, Half.Surface - 2.1 };
};
} // namespace

TEST_F(BurrOfModel, TicksInTheServo)
{
  ServoHand hand(this->Make());
  HapticModelDescription other = this->Half.Scene;
  other.Removal = std::make_shared<TissueRemoval>();
  BurrInVolume alone(other, this->Settings, this->Energies);
  hand.Tick(this->Above);
  alone.Tick(this->Above);
  for (int i = 0; i < 1500; ++i)
  {
    hand.State.IsSpinning = alone.IsSpinning = i % 400 < 300;
    const Vector3 at = this->Above + Vector3{ 0.0005 * i, 0.0, 0.003 * std::min(i, 900) };
    const Vector3 force = hand.Tick(at).Force;
    const Vector3 expected = alone.Tick(at).Force;
    ASSERT_EQ(std::memcmp(&force, &expected, sizeof(force)), 0);
    ASSERT_EQ(hand.Record.RemovedVolume, alone.Record.RemovedVolume);
  }
  EXPECT_GT(hand.Removed, 0.5);
  EXPECT_EQ(
    hand.GetFractions(), CopyTissue(other.Removal->Bricks, this->Half.Volume.View.Dimensions));
  EXPECT_EQ(this->Half.Removal->Journal.GetUndoable(), 4u) << "a stroke for each time it spun";
  EXPECT_EQ(hand.Record.Contact, ContactState::Sticking);
  EXPECT_EQ(1000.0 * hand.Record.Proxy.X, 1000.0 * alone.Record.Shell.Tool.Position.X);
}

/// If the device's motions appear half as large in the world, the drilled hole must still have the
/// burr's radius in the world.
TEST_F(BurrOfModel, HasItsSizeInTheWorld)
{
  this->Burr.SpecificEnergy = ConstantPolyline(0.1);
  for (const double scale : { 1000.0, 500.0 })
  {
    this->Half.Scene.DeviceToWorld.Linear = scale * Matrix3{};
    this->Half.Scene.Removal = std::make_shared<TissueRemoval>();
    ServoHand hand(this->Make());
    hand.Tick(this->Above);
    for (int i = 0; i < 20000 && hand.Record.Proxy.Z * scale < this->Half.Surface + 1.5; ++i)
    {
      hand.Press(2.0);
    }
    EXPECT_GE(hand.Record.Proxy.Z * scale, this->Half.Surface + 1.5);
    const FieldSampler& field = hand.Model->Baked->Field;
    for (int i = 0; i < 8; ++i)
    {
      const Vector3 ray{ std::cos(Pi * i / 4.0), std::sin(Pi * i / 4.0), 0.0 };
      const Vector3 axis{ this->Above.X / 0.4, this->Above.Y / 0.4,
        (this->Half.Surface + 0.8) / 0.4 };
      double low = 0.0;
      double high = 10.0;
      for (int n = 0; n < 40; ++n)
      {
        const double r = 0.5 * (low + high);
        (field.Value(axis + r * ray) < 100.0 ? low : high) = r;
      }
      EXPECT_NEAR(0.4 * low, 2.0, 0.1 * 0.4) << scale;
    }
  }
}

/// After a change of material or placement, the burr must keep its force and continue to remove
/// tissue.
TEST_F(BurrOfModel, GoesAlongToAnotherModel)
{
  ServoHand hand(this->Make());
  hand.Tick(this->Above);
  const auto drill = [&hand]()
  {
    const double before = hand.Removed;
    for (int i = 0; i < 300; ++i)
    {
      hand.Press(2.0);
    }
    return hand.Removed - before;
  };
  drill();
  const double first = drill();
  EXPECT_NEAR(first, 0.3 * 0.3 * 2.0 * 12.566 / 2.0, 0.05 * first) << "mu F v t/U";
  this->Burr.SpecificEnergy = ConstantPolyline(4.0);
  hand.Publish(this->Make());
  const Vector3 force = hand.Press(2.0).Force;
  EXPECT_NEAR(Norm(force), 2.0, 0.02);
  EXPECT_NEAR(drill(), 0.5 * first, 0.05 * first);
  this->Half.Scene.DeviceToWorld.Offset = { 3.0, -5.0, 7.0 };
  const Vector3 world = hand.Model->DeviceToWorld(hand.Record.Tip);
  hand.Publish(this->Make());
  EXPECT_NEAR(Norm(hand.Tick(world).Force), 2.0, 0.05);
  EXPECT_NEAR(drill(), 0.5 * first, 0.05 * first);
  // After the tool was removed, the hand starts again without a force.
  hand.Publish(std::make_shared<const HapticModel>(this->Half.Scene));
  EXPECT_EQ(Norm(hand.Tick(world).Force), 0.0);
}

/// B4: from a stored state with its contacts and fractions, the ticks continue identically, to the
/// bit.
TEST_F(BurrOfModel, GoesOnFromWhatWasKept)
{
  HapticModelDescription copied = this->Half.Scene;
  copied.Removal = std::make_shared<TissueRemoval>();
  copied.Tool = std::make_shared<const BakedBurr>(this->Burr);
  ServoHand hand(this->Make());
  hand.Tick(this->Above);
  for (int i = 0; i < 700; ++i)
  {
    hand.Press(2.0);
  }
  const CarvedBricks& bricks = this->Half.Removal->Bricks;
  for (std::uint32_t brick = 0; brick < bricks.GetCount(); ++brick)
  {
    const std::uint32_t copy = copied.Removal->Bricks.FindOrAdd(bricks.GetKey(brick));
    for (int row = 0; row < CarvedBricks::Rows; ++row)
    {
      copied.Removal->Bricks.SetRow(copy, row, bricks.GetRow(brick, row));
    }
  }
  ServoHand again(std::make_shared<const HapticModel>(copied));
  hand.Memory->Keep();
  const ShellContacts& kept = *FindKeptContacts(hand.Memory.get());
  const std::vector<ShellContact> contacts(kept.List.begin(), kept.List.begin() + kept.Count);
  ASSERT_TRUE(RestoreContacts(*again.Memory, *again.Model->Baked, contacts, kept.Fraction));
  const auto numbers = ToNumbers(hand.State);
  EXPECT_TRUE(AreOfAState(numbers));
  again.State = FromNumbers(numbers);
  again.Record = hand.Record;
  for (int i = 0; i < 500; ++i)
  {
    const Vector3 force = hand.Press(2.0).Force;
    const Vector3 expected = again.Press(2.0).Force;
    ASSERT_EQ(std::memcmp(&force, &expected, sizeof(force)), 0) << "tick " << i;
  }
  EXPECT_EQ(again.GetFractions(), hand.GetFractions());
}

TEST_F(BurrOfModel, AStateThatNoTickProducesIsTold)
{
  ServoState state;
  EXPECT_TRUE(AreOfAState(ToNumbers(state)));
  state.Burr.Unspent = -1.0;
  EXPECT_FALSE(AreOfAState(ToNumbers(state)));
  state.Burr = BurrState{};
  state.Burr.Phase = 2.0;
  EXPECT_FALSE(AreOfAState(ToNumbers(state)));
  state.Burr = BurrState{};
  state.Burr.Carved.Y = 1e300;
  EXPECT_FALSE(AreOfAState(ToNumbers(state)));
  state.Burr = BurrState{};
  state.Burr.Next.X = 1e300;
  EXPECT_FALSE(AreOfAState(ToNumbers(state)));
  state.Burr = BurrState{};
  state.Burr.Part = 4000000000U;
  EXPECT_TRUE(AreOfAState(ToNumbers(state)));
  EXPECT_EQ(FromNumbers(ToNumbers(state)).Burr.Part, 4000000000U);
}

/// Without the tool's memory, or without a removal to write to, the burr removes nothing.
TEST_F(BurrOfModel, WithoutMemoryIsAPoint)
{
  ServoHand hand(this->Make());
  hand.Memory = nullptr;
  hand.Tick(this->Above);
  for (double z = 0.0; z < 4.0; z += 0.02)
  {
    hand.Tick(this->Above + Vector3{ 0.0, 0.0, z });
  }
  EXPECT_GT(Norm(hand.Record.Force), 0.1);
  EXPECT_TRUE(this->Half.Removal->Bricks.IsEmpty());
  this->Half.Scene.Removal = nullptr;
  ServoHand other(this->Make());
  other.Tick(this->Above);
  for (int i = 0; i < 100; ++i)
  {
    other.Press(1.0);
  }
  EXPECT_NEAR(Norm(other.Record.Force), 1.0, 0.05);
  EXPECT_EQ(other.Removed, 0.0);
}

/// A hand of 0.1 kg holds the device, presses with up to 3 N and drills. The energy observer must
/// find no unstable loop.
TEST_F(BurrOfModel, ALoopThatDrillsDoesNotSwing)
{
  this->Burr.Settings.Vibration = 0.1;
  this->Burr.Settings.Speed = 150.0;
  ServoHand hand(this->Make());
  EnergyObserver observer;
  constexpr double mass = 0.1;    // kg
  constexpr double damping = 5.0; // N s/m
  double z = 0.001 * this->Above.Z;
  double speed = 0.0;
  int alarms = 0;
  for (int i = 0; i < 6000; ++i)
  {
    const double push = 1.5 - 1.5 * std::cos(2.0 * Pi * 1e-3 * i);
    const Vector3 tip{ 0.001 * this->Above.X, 0.001 * this->Above.Y, z };
    alarms += observer.Observe(tip, 1e-3) ? 1 : 0;
    const double force = hand.Tick(1000.0 * tip).Force.Z;
    observer.RecordSent(hand.Record.Force);
    for (int part = 0; part < 10; ++part)
    {
      speed += 1e-4 * (push + force - damping * speed) / mass;
      z += 1e-4 * speed;
    }
  }
  EXPECT_EQ(alarms, 0);
  EXPECT_LE(observer.GetEnergy(), 0.0) << "J: the hand has put energy in";
  EXPECT_GT(hand.Removed, 1.0);
}

/// Ticks must not serve requests. Only the owner of the removal serves them, and no force acts
/// meanwhile.
TEST_F(BurrOfModel, OnlyItsOwnerServesRequests)
{
  ServoHand hand(this->Make());
  hand.Tick(this->Above);
  hand.Tick(this->Above + Vector3{ 0.0, 0.0, 1.5 });
  for (int i = 0; i < 300; ++i)
  {
    hand.Press(2.0);
  }
  TissueRemoval& removal = *this->Half.Removal;
  ASSERT_EQ(removal.Journal.GetUndoable(), 1u);
  const auto fractions = hand.GetFractions();
  hand.State.IsSpinning = false;
  ASSERT_TRUE(removal.Request(RemovalRequest::Undo));
  hand.Press(2.0);
  EXPECT_EQ(removal.GetPending(), 1u);
  EXPECT_EQ(hand.GetFractions(), fractions);
  EXPECT_FALSE(hand.Record.IsServed);
  int served = 0;
  while (removal.GetPending() > 0)
  {
    TickAndServe(*hand.Model, hand.State, hand.Record.Tip, hand.Record,
      LocalSurfaceResult::Simulated(), nullptr, hand.Memory.get());
    EXPECT_TRUE(hand.Record.IsServed);
    EXPECT_EQ(hand.Record.Request, served == 0 ? RemovalRequest::Undo : RemovalRequest::None);
    EXPECT_EQ(Norm(hand.Record.Force), 0.0);
    EXPECT_FALSE(hand.State.Enabled);
    ASSERT_LT(++served, 1000);
  }
  EXPECT_GT(served, 0);
  EXPECT_TRUE(removal.Bricks.IsWhole());
  TickAndServe(*hand.Model, hand.State, hand.Record.Tip, hand.Record,
    LocalSurfaceResult::Simulated(), nullptr, hand.Memory.get());
  EXPECT_FALSE(hand.Record.IsServed);
  EXPECT_EQ(Norm(hand.Record.Force), 0.0) << "the hand begins anew";
}
