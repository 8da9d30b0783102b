// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that a burr which removes the tissue below it creates no energy, presses at most as hard
 * as its tissue can bear, and exerts no force while tissue is restored.
 */

#include "Rigs/BurrRig.h"

#include <gtest/gtest.h>

using namespace coretest;

namespace
{
/// Returns a bumpy ball with noise, of 16-bit values. Voxels are 0.5 mm, and the centre is at 16
/// mm.
TestVolume MakeBone()
{
  TestVolume volume(ScalarType::Int16, { 64, 64, 64 });
  std::mt19937_64 engine(9);
  std::uniform_real_distribution<double> uniform(-40.0, 40.0);
  volume.Fill<std::int16_t>(
    [&](std::int64_t i, std::int64_t j, std::int64_t k)
    {
      const Vector3 at{ i - 32.0, j - 32.0, k - 32.0 };
      const double surface = 18.0 + 1.5 * std::sin(0.4 * at.X) * std::cos(0.5 * at.Y);
      return static_cast<std::int16_t>(
        1000.0 * (1.0 + std::tanh(0.5 * (surface - Norm(at)))) + uniform(engine));
    });
  return volume;
}

class BurrSafety : public testing::Test
{
protected:
  BurrSafety()
  {
    this->Scene = Describe(this->Bone);
    this->Scene.IndexToWorld.Linear = 0.5 * Matrix3{};
    this->Scene.Removal = std::make_shared<TissueRemoval>();
    this->Scene.Material.Stiffness = { { 900.0, 100.0 }, { 1700.0, 600.0 }, { 2000.0, 900.0 } };
    this->Scene.Material.SurfaceStrength = { { 1000.0, 0.3 }, { 1900.0, 2.0 } };
  }

  /// Returns the place (mm) at time t from 0 to 1 on a smooth random path that begins and ends
  /// outside the ball.
  static Vector3 ComputePlace(double t, const Vector3* waves)
  {
    const double press = std::sin(Pi * t); // 0 at both ends
    const Vector3 away{ 1.0, 0.3 * std::sin(2.0 * Pi * t), 0.2 };
    return Vector3{ 16.0, 16.0, 16.0 } + (13.5 - 4.5 * press) * away +
      (3.0 * std::sin(4.0 * Pi * t)) * waves[0] + (2.0 * std::sin(6.0 * Pi * t)) * waves[1];
  }
  std::vector<std::uint8_t> GetFractions() const
  {
    return CopyTissue(this->Scene.Removal->Bricks, this->Bone.View.Dimensions);
  }

  const TestVolume Bone = MakeBone();
  HapticModelDescription Scene;
  BurrInHand Settings = MakeBurr(2e9, 1000.0);
  const Polyline Energies{ { 1000.0, 1.0 }, { 2000.0, 8.0 } };
};
} // namespace

/// S6 while tissue is removed, with and without vibration: no cycle of the hand may create energy.
TEST_F(BurrSafety, NoCycleCreatesEnergy)
{
  std::mt19937_64 engine(22);
  int drilled = 0;
  for (int cycle = 0; cycle < 24; ++cycle)
  {
    this->Settings.Vibration = cycle % 2 == 0 ? 0.0 : 0.3;
    this->Settings.Speed = cycle % 4 < 2 ? 1000.0 : 180.0;
    this->Scene.Removal = std::make_shared<TissueRemoval>(4096);
    BurrInVolume hand(this->Scene, this->Settings, this->Energies, 600);
    const Vector3 waves[2] = { RandomIn(engine, 1.0), RandomIn(engine, 1.0) };
    const int ticks = cycle % 3 == 0 ? 300 : 2000;
    double least = 0.0;
    for (int i = 0; i <= ticks; ++i)
    {
      hand.Tick(ComputePlace(static_cast<double>(i) / ticks, waves));
      const ShellRecord& shell = hand.Record.Shell;
      const double stored = hand.EnergyOfSpring(shell.Tool.Position, shell.Hand.Position);
      least = std::min(least, hand.Work - stored);
    }
    drilled += hand.Removed > 0.01 ? 1 : 0;
    for (int i = 0; i < 50; ++i)
    {
      hand.Tick(1000.0 * hand.Record.Shell.Hand.Position);
    }
    EXPECT_EQ(hand.Record.Shell.Contacts, 0u);
    EXPECT_GE(hand.Work, -1e-15) << "J, cycle " << cycle;
    EXPECT_GE(least, -1e-15) << "J: the spring holds more than the hand has put in";
    EXPECT_GE(hand.Work + hand.VibrationWork, -1e-15) << "J, with the vibration";
  }
  EXPECT_GE(drilled, 18);
}

/// The hand rests above tissue that is being removed, so the spring only relaxes.
TEST(BurrAtRest, TheForceOnlyFalls)
{
  HalfSpace half({ 48, 48, 40 }, 0.4, 16);
  BurrInVolume hand(half.Scene, MakeBurr(2e9, 100.0), ConstantPolyline(1.0), 2000);
  hand.IsSpinning = false;
  const Vector3 at{ 9.5, 9.3, half.Surface - 0.8 }; // 1.2 mm deep
  hand.Tick(at - Vector3{ 0.0, 0.0, 2.0 });
  hand.Lead(at);
  hand.Lead(at + Vector3{ 1e-9, 0.0, 0.0 }, 1e-11);
  hand.IsSpinning = true;
  double force = Norm(hand.Record.Force);
  EXPECT_GT(force, 0.3);
  for (int i = 0; i < 20000 && force > 0.02; ++i)
  {
    hand.Tick(at);
    EXPECT_LE(Norm(hand.Record.Force), force + 5e-3) << "N, tick " << i;
    force = std::min(force, Norm(hand.Record.Force));
  }
  EXPECT_LE(force, 0.02) << "there is a hole where the hand is";
}

/// The largest pressure is 0.5 N over the contact area. The force must be at most that pressure
/// times the pressed area.
TEST_F(BurrSafety, NoForceIsLargerThanTheTissueBears)
{
  this->Scene.Material.SurfaceStrength = ConstantPolyline(0.5);
  this->Settings = MakeBurr(2e8, 1000.0); // 0.2 MPa
  this->Settings.Vibration = 1.0;
  this->Settings.Speed = 170.0;
  const double each = 0.5 / this->Settings.Shell.ContactArea * 4.0 * Pi * 4.0 / 1000.0;
  std::mt19937_64 engine(23);
  double most = 0.0;
  for (int cycle = 0; cycle < 6; ++cycle)
  {
    BurrInVolume hand(this->Scene, this->Settings, this->Energies, 1000);
    hand.Tick({ 29.0, 16.0, 16.0 });
    const Vector3 goal = Vector3{ 18.0, 16.0, 16.0 } + RandomIn(engine, 2.0);
    for (double step = 0.0; step <= 11.0; step += 0.01)
    {
      const Vector3 at = Vector3{ 29.0, 16.0, 16.0 };
      hand.Tick(at + ClampNorm(goal - at, step));
      const double bound = each * hand.Record.Shell.Contacts;
      EXPECT_LE(Norm(hand.Record.Force), 1.001 * bound + 5e-3);
      most = std::max(most, Norm(hand.Record.Force) / std::max(bound, 0.1));
    }
  }
  EXPECT_GE(most, 0.5) << "the bound is met";
}

/// The amplitude of the vibration is the set fraction of the force. Its mean is zero, and its
/// frequency is the burr's.
TEST(BurrVibration, HasItsFractionAndNoMean)
{
  BurrInHand settings = MakeBurr(2e9, 100.0);
  settings.Vibration = 0.2;
  settings.Speed = 125.0; // Hz: one turn takes 8 ticks
  HalfSpace half({ 48, 48, 40 }, 0.4, 16);
  BurrInVolume hand(half.Scene, settings, ConstantPolyline(0.5), 2000);
  hand.Tick({ 9.5, 9.3, half.Surface - 2.1 });
  for (int i = 0; i < 2000; ++i)
  {
    hand.Press(1.0); // the press loses energy, which the vibration may return
  }
  std::vector<double> along;
  double least = 1.0;
  double most = -1.0;
  for (int i = 0; i < 800; ++i)
  {
    hand.Press(1.0);
    const Vector3& contact = hand.Record.Shell.Force;
    const Vector3 vibration = hand.Record.Force - contact;
    const double fraction = Dot(vibration, contact) / Dot(contact, contact);
    EXPECT_LE(std::abs(fraction), 0.2 + 1e-9);
    EXPECT_NEAR(Norm(vibration), std::abs(fraction) * Norm(contact), 1e-9);
    along.push_back(fraction);
    least = std::min(least, fraction);
    most = std::max(most, fraction);
  }
  EXPECT_LE(least, -0.19);
  EXPECT_GE(most, 0.19);
  for (std::size_t i = 0; i + 8 <= along.size(); i += 8)
  {
    double sum = 0.0;
    for (std::size_t n = 0; n < 8; ++n)
    {
      sum += along[i + n];
      EXPECT_NEAR(along[i + n], along[n], 1e-3) << "it is periodic";
    }
    EXPECT_NEAR(sum, 0.0, 1e-6);
  }
  // 60 000 turns a minute are 1000 Hz, which ticks of 1 ms can't reproduce. The vibration therefore
  // has a quarter of the tick rate.
  settings.Speed = 1000.0;
  EXPECT_EQ(BakedBurr({ settings, ConstantPolyline(1.0) }).Frequency, 250.0);
}

/// B4: undo, redo and reset must restore the fractions to the bit. Meanwhile, no force may act.
TEST_F(BurrSafety, StrokesAreUndoneAndDoneAgainToTheBit)
{
  BurrInVolume hand(this->Scene, this->Settings, this->Energies, 600);
  TissueRemoval& removal = *this->Scene.Removal;
  std::vector<std::vector<std::uint8_t>> history = { this->GetFractions() };
  for (int stroke = 0; stroke < 3; ++stroke)
  {
    const Vector3 above{ 28.0, 13.0 + 3.0 * stroke, 16.0 };
    hand.IsSpinning = true;
    hand.Tick(above);
    hand.Lead(above + Vector3{ -4.0, 0.0, 0.0 }, 0.004);
    hand.IsSpinning = false;
    hand.Tick(above);
    history.push_back(this->GetFractions());
    EXPECT_NE(history[history.size() - 1], history[history.size() - 2]);
  }
  EXPECT_EQ(removal.Journal.GetUndoable(), 3u);
  const auto ask = [&](RemovalRequest request, const std::vector<std::uint8_t>& expected)
  {
    // Request the change while the hand presses into the tissue.
    hand.Tick({ 28.0, 16.0, 16.0 });
    hand.Lead({ 24.0, 16.0, 16.0 });
    EXPECT_TRUE(removal.Request(request));
    for (int i = 0; i < 40; ++i)
    {
      const bool isAsked = removal.GetPending() > 0;
      hand.Tick({ 24.0, 16.0, 16.0 });
      EXPECT_TRUE(!isAsked || Norm(hand.Record.Force) == 0.0);
    }
    EXPECT_EQ(this->GetFractions(), expected);
    EXPECT_LE(Norm(hand.Record.Force), 1e-9) << "it may leave the tissue that came back";
  };
  ask(RemovalRequest::Undo, history[2]);
  ask(RemovalRequest::Undo, history[1]);
  ask(RemovalRequest::Redo, history[2]);
  ask(RemovalRequest::Redo, history[3]);
  ask(RemovalRequest::Reset, history[0]);
  EXPECT_EQ(removal.Journal.GetUndoable(), 0u);
}

/// B4: the same motion of the hand removes the same tissue, to the bit.
TEST_F(BurrSafety, ARecordingRemovesTheSame)
{
  const auto drill = [&](std::vector<double>& numbers)
  {
    this->Settings.Vibration = 0.1;
    this->Scene.Removal = std::make_shared<TissueRemoval>();
    BurrInVolume hand(this->Scene, this->Settings, this->Energies, 600);
    const Vector3 waves[2] = { { 0.3, -0.8, 0.4 }, { -0.6, 0.2, 0.7 } };
    for (int i = 0; i <= 2500; ++i)
    {
      hand.IsSpinning = i % 700 < 600;
      hand.Step = i % 13 == 0 ? 2e-3 : 1e-3;
      if (i == 1400)
      {
        this->Scene.Removal->Request(RemovalRequest::Undo);
      }
      const BurrRecord& record = hand.Tick(ComputePlace(i / 2500.0, waves));
      numbers.insert(numbers.end(),
        { record.Force.X, record.Force.Y, record.Force.Z, record.RemovedVolume, record.Energy });
    }
    EXPECT_GT(hand.Removed, 0.5);
    return this->GetFractions();
  };
  std::vector<double> first;
  std::vector<double> second;
  const auto fractions = drill(first);
  EXPECT_EQ(drill(second), fractions);
  ASSERT_EQ(first.size(), second.size());
  EXPECT_EQ(std::memcmp(first.data(), second.data(), first.size() * sizeof(double)), 0);
}

TEST_F(BurrSafety, AHandThatIsNoPlaceIsNotFeltAndRemovesNothing)
{
  BurrInVolume hand(this->Scene, this->Settings, this->Energies, 600);
  hand.Tick({ 28.0, 16.0, 16.0 });
  hand.Lead({ 24.5, 16.0, 16.0 }, 0.01);
  EXPECT_GT(hand.Removed, 0.0);
  const auto before = this->GetFractions();
  for (const double x : { std::numeric_limits<double>::quiet_NaN(), 1e300, -HUGE_VAL })
  {
    EXPECT_EQ(Norm(hand.Tick({ x, 16.0, 16.0 }).Force), 0.0);
  }
  EXPECT_EQ(this->GetFractions(), before);
  EXPECT_EQ(this->Scene.Removal->Journal.GetUndoable(), 1u) << "its stroke has ended";
  // Without a removal to write to, the burr feels the tissue and removes nothing.
  this->Scene.Removal = nullptr;
  BurrInVolume other(this->Scene, this->Settings, this->Energies, 600);
  other.Tick({ 28.0, 16.0, 16.0 });
  EXPECT_GT(Norm(other.Lead({ 24.5, 16.0, 16.0 }, 0.01).Force), 0.3);
  EXPECT_EQ(other.Removed, 0.0);
}
