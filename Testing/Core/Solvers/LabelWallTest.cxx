// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests walls between labels under a hand, in a volume with one value. If the tip is at the depth h
 * and a wall that holds at the depth w, the force is k (h - w), which is the closed form of these
 * tests.
 */

#include "Rigs/CoreScene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <vector>

using namespace coretest;

namespace
{
constexpr double Millimetre = 1e-3;
/// Number of crossings. Sanitizers and debug builds are slow, so they make fewer crossings,
/// although the statistics need the number of a release build.
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
constexpr int Crossings = 1000000;
#else
constexpr int Crossings = 20000;
#endif

LabelledMaterial Entry(std::int64_t label, double stiffness, double strength)
{
  LabelledMaterial entry;
  entry.Label = label;
  entry.Material.Value = { stiffness, 0.0, strength, 0.0 };
  entry.Material.IsSet = { true, false, true, false };
  return entry;
}

/// A volume of zeros, with a label map on the same grid.
class LabelledScene
{
public:
  explicit LabelledScene(std::int64_t side, const std::function<int(const Vector3&)>& label,
    const std::vector<LabelledMaterial>& entries)
    : Volume(ScalarType::Int16, { side, side, side })
    , Labels(ScalarType::UInt8, { side, side, side })
  {
    this->Labels.Fill<std::uint8_t>(
      [&](std::int64_t i, std::int64_t j, std::int64_t k) {
        return label({ double(i), double(j), double(k) });
      });
    auto baked = std::make_shared<BakedLabels>();
    baked->View = LabelView(this->Labels.View);
    baked->Table = LabelTable(entries);
    this->Description = Describe(this->Volume);
    this->Description.Labels = baked;
    this->Description.Settings.Geometry = SurfaceGeometry::Labels;
  }

  TestVolume Volume;
  TestVolume Labels;
  HapticModelDescription Description;
};

/// Moves a tip and runs the ticks. Positions are in millimetres.
class WallHand
{
public:
  explicit WallHand(const HapticModel& model)
    : Model(model)
  {
  }

  const TickRecord& MoveTo(const Vector3& to, double step = 0.1)
  {
    const double length = Norm(to - this->At);
    const int ticks = this->IsThere ? std::max(1, int(std::ceil(length / step))) : 1;
    const Vector3 from = this->IsThere ? this->At : to;
    for (int i = 1; i <= ticks; ++i)
    {
      this->At = from + (double(i) / ticks) * (to - from);
      Tick(this->Model, this->State, Millimetre * this->At, this->Record);
    }
    this->At = to;
    this->IsThere = true;
    return this->Record;
  }

private:
  const HapticModel& Model;
  ServoState State;
  TickRecord Record;
  Vector3 At;
  bool IsThere = false;
};

/// The wall of L6. It is between the labels 0 and 1, passes through the middle, and is oblique to
/// all axes. Positions and lengths are in millimetres. The random numbers are the same in each run.
class ObliqueWall
{
public:
  static constexpr double Stiffness = 500.0;
  static constexpr double Strength = 2.0;
  static constexpr double Bumps = 0.4; ///< size of the bumps caused by the voxels (mm)

  explicit ObliqueWall(std::uint64_t seed)
    : Scene(32, [this](const Vector3& x) { return this->DepthOf(x) > 0.0 ? 1 : 0; },
        { Entry(1, Stiffness, Strength) })
    , Model(this->Scene.Description)
    , Engine(seed)
  {
  }

  double DepthOf(const Vector3& x) const { return Dot(x - this->Middle, this->Normal); }
  double Draw(double low, double high)
  {
    return low + (high - low) * static_cast<double>(this->Engine() >> 11) * 0x1p-53;
  }
  /// Returns a random step along the wall, of up to `reach` (mm) in each of two directions.
  Vector3 DrawAlong(double reach)
  {
    const double u = this->Draw(-reach, reach);
    const double v = this->Draw(-reach, reach);
    return u * this->Across + v * Cross(this->Normal, this->Across);
  }
  void Move(const Vector3& tip) { Tick(this->Model, this->State, Millimetre * tip, this->Record); }
  bool IsThrough() const { return this->DepthOf((1.0 / Millimetre) * this->Record.Proxy) > Bumps; }

  const Vector3 Normal = (1.0 / std::sqrt(14.0)) * Vector3{ 1.0, 2.0, 3.0 };
  const Vector3 Across = (1.0 / std::sqrt(5.0)) * Vector3{ 2.0, -1.0, 0.0 };
  const Vector3 Middle{ 16, 16, 16 };
  const LabelledScene Scene;
  const HapticModel Model;
  ServoState State;
  TickRecord Record;

private:
  std::mt19937_64 Engine;
};

class LabelWallOfSolver : public testing::TestWithParam<HapticSolver>
{
};
} // namespace

TEST_P(LabelWallOfSolver, HoldsWhereTheLabelsMeet)
{
  // L1, with the geometry of labels: regions of 200 N/m and of 800 N/m are behind one wall at z =
  // 11.5.
  const auto labels = [](const Vector3& x) { return x.Z < 11.5 ? 0 : (x.X < 11.5 ? 1 : 2); };
  LabelledScene scene(24, labels, { Entry(1, 200.0, 50.0), Entry(2, 800.0, 50.0) });
  scene.Description.Settings.Solver = this->GetParam();
  const HapticModel model(scene.Description);
  for (const auto& [x, stiffness] : { std::pair(6.0, 200.0), std::pair(17.0, 800.0) })
  {
    WallHand hand(model);
    EXPECT_EQ(Norm(hand.MoveTo({ x, 12, 8 }).Force), 0.0);
    EXPECT_EQ(Norm(hand.MoveTo({ x, 12, 11.4 }).Force), 0.0) << "not before the wall";
    const TickRecord& pressed = hand.MoveTo({ x, 12, 13.5 }, 0.01);
    EXPECT_NEAR(pressed.Stiffness, stiffness, 1e-9 * stiffness);
    EXPECT_NEAR(pressed.Proxy.Z, 11.5 * Millimetre, 0.015 * Millimetre);
    // The force is the lag times the stiffness of this region, without influence of the other
    // region.
    EXPECT_NEAR(-pressed.Force.Z / (stiffness * (13.5 * Millimetre - pressed.Proxy.Z)), 1.0, 1e-9);
    const TickRecord& left = hand.MoveTo({ x, 12, 8 });
    EXPECT_EQ(Norm(left.Force), 0.0) << "the way out is free";
  }
}

TEST_P(LabelWallOfSolver, GivesWayAtItsStrength)
{
  const auto labels = [](const Vector3& x) { return x.Z < 11.5 ? 0 : 1; };
  LabelledScene scene(40, labels, { Entry(1, 500.0, 1.0) });
  scene.Description.Settings.Solver = this->GetParam();
  const HapticModel model(scene.Description);
  WallHand hand(model);
  hand.MoveTo({ 20, 20, 8 });
  double most = 0.0;
  for (double z = 8.0; z < 22.0; z += 0.05)
  {
    most = std::max(most, Norm(hand.MoveTo({ 20, 20, z }).Force));
  }
  EXPECT_NEAR(most, 1.0, 1e-3);
  EXPECT_EQ(Norm(hand.MoveTo({ 20, 20, 22 }).Force), 0.0) << "inside a label nothing holds";
  // On the way out of the structure, the wall does not hold either.
  for (double z = 22.0; z > 8.0; z -= 0.05)
  {
    ASSERT_LT(Norm(hand.MoveTo({ 20, 20, z }).Force), 1e-9) << z;
  }
}

TEST_P(LabelWallOfSolver, IsNotThereIfNothingIsFelt)
{
  // The label of the skin is not felt; the bone behind the skin is.
  const auto labels = [](const Vector3& x) { return x.Z < 8.5 ? 0 : (x.Z < 14.5 ? 1 : 2); };
  LabelledMaterial skin = Entry(1, 300.0, 5.0);
  skin.Material.IsFelt = false;
  LabelledMaterial air = Entry(0, 300.0, 0.0);
  air.Material.IsFelt = false;
  LabelledScene scene(24, labels, { air, skin, Entry(2, 500.0, 50.0) });
  scene.Description.Settings.Solver = this->GetParam();
  const HapticModel model(scene.Description);
  WallHand hand(model);
  for (double z = 4.0; z < 14.4; z += 0.1)
  {
    ASSERT_EQ(Norm(hand.MoveTo({ 12, 12, z }).Force), 0.0) << z;
  }
  EXPECT_NEAR(hand.MoveTo({ 12, 12, 16.5 }, 0.01).Force.Z, -500.0 * 2.0 * Millimetre, 0.01);
}

INSTANTIATE_TEST_SUITE_P(
  Both, LabelWallOfSolver, testing::Values(HapticSolver::Paper, HapticSolver::Precise));

TEST(LabelWall, IsNeverFallenThrough)
{
  // The tip moves at up to 3 m/s, and presses with less than the wall's strength T_N.
  ObliqueWall wall(7);
  constexpr double deepest =
    0.9 * ObliqueWall::Strength / ObliqueWall::Stiffness / Millimetre - ObliqueWall::Bumps;
  constexpr int crossings = Crossings / 25; // fewer, because each way takes several ticks
  constexpr double fastest = 3.0;           // mm per tick of 1 ms, which is 3 m/s
  Vector3 tip = wall.Middle - 2.0 * wall.Normal;
  wall.Move(tip);
  int through = 0;
  int unpressed = 0;
  for (int i = 0; i < crossings; ++i)
  {
    for (const bool goesIn : { true, false })
    {
      const double depth = goesIn ? wall.Draw(0.5, deepest) : wall.Draw(-3.0, -0.5);
      const Vector3 to = wall.Middle + wall.DrawAlong(5.0) + depth * wall.Normal;
      // Divide the path into equal steps of at most 3 mm, with one tick each.
      const Vector3 way = to - tip;
      const int ticks = static_cast<int>(std::ceil(Norm(way) / fastest));
      for (int tick = 1; tick <= ticks; ++tick)
      {
        wall.Move(tip + (double(tick) / ticks) * way);
        through += wall.IsThrough() ? 1 : 0;
      }
      tip = to;
      // The force divided by k must equal the depth, except for the size of the bumps.
      const double pressed = -Dot(wall.Record.Force, wall.Normal) / ObliqueWall::Stiffness;
      unpressed += goesIn && std::abs(pressed / Millimetre - depth) > ObliqueWall::Bumps ? 1 : 0;
    }
  }
  EXPECT_EQ(through, 0);
  EXPECT_EQ(unpressed, 0);
}

TEST(LabelWall, IsNotFallenThroughInAMillionCrossings)
{
  // Make up to 10^6 crossings of one tick each, at places with bumps and dents due to voxels.
  ObliqueWall wall(9);
  Vector3 foot = wall.Middle;
  wall.Move(foot - wall.Normal);
  int through = 0;
  int unheld = 0;
  int caught = 0;
  for (int i = 0; i < Crossings; ++i)
  {
    const bool goesIn = i % 2 == 0;
    if (goesIn && i % 100 == 0)
    {
      // Start a new contact at another place in front of the wall.
      foot = wall.Middle + wall.DrawAlong(6.0);
      wall.State.Enabled = false;
      wall.Move(foot - wall.Normal);
    }
    foot += wall.DrawAlong(0.1);
    wall.Move(foot + (goesIn ? wall.Draw(0.5, 0.9) : wall.Draw(-0.9, -0.5)) * wall.Normal);
    const double force = Norm(wall.Record.Force);
    through += wall.IsThrough() ? 1 : 0;
    unheld += goesIn && !(force > 0.0) ? 1 : 0;
    caught += !goesIn && force > 1e-6 ? 1 : 0;
  }
  EXPECT_EQ(through, 0);
  EXPECT_EQ(unheld, 0);
  EXPECT_EQ(caught, 0) << "the way out is free";
}
