// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests contacts with the faces of a cut. Behind an open face, no force may act. If the tip is at
 * the depth h and a solid face at the depth w, the force is k (h - w), up to the surface strength
 * T_N, as in the closed form of a wall.
 */

#include "Rigs/CoreScene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>

using namespace coretest;

namespace
{
constexpr double PerMillimetre = 1e-3;
constexpr double FaceStiffness = 500.0; // N/m, of the default material
constexpr double FaceStrength = 2.0;    // N

TestVolume MakeEven(double value)
{
  TestVolume volume(ScalarType::Float32, { 32, 32, 32 });
  volume.Fill<float>(
    [value](std::int64_t, std::int64_t, std::int64_t) { return static_cast<float>(value); });
  return volume;
}

/// Moves a tip in steps of at most 0.1 mm, and sums up the work. Positions are in millimetres.
class CutHand
{
public:
  explicit CutHand(const HapticModel& model, const Vector3& start)
    : Model(model)
    , At(start)
  {
    this->Tick(start);
  }

  const TickRecord& Tick(const Vector3& to)
  {
    this->At = to;
    VolumeHaptics::Tick(this->Model, this->State, PerMillimetre * to, this->Record);
    this->Energy -=
      0.5 * Dot(this->Record.Force + this->Force, PerMillimetre * (to - this->Before));
    this->Force = this->Record.Force;
    this->Before = to;
    return this->Record;
  }
  const TickRecord& MoveTo(const Vector3& to)
  {
    const Vector3 from = this->At;
    const int ticks = std::max(1, static_cast<int>(std::ceil(Norm(to - from) / 0.1)));
    for (int i = 1; i <= ticks; ++i)
    {
      this->Tick(from + (static_cast<double>(i) / ticks) * (to - from));
    }
    return this->Record;
  }
  Vector3 GetProxy() const { return (1.0 / PerMillimetre) * this->Record.Proxy; }
  /// Returns the work (J) that the hand has done.
  double GetEnergy() const { return this->Energy; }

private:
  const HapticModel& Model;
  ServoState State;
  TickRecord Record;
  Vector3 At;
  Vector3 Before;
  Vector3 Force;
  double Energy = 0.0;
};

class CutOfSolver : public testing::TestWithParam<HapticSolver>
{
protected:
  HapticModelDescription DescribeCut(
    const TestVolume& volume, std::vector<CutPlane> planes, const CutRegions& regions, bool isSolid)
  {
    HapticModelDescription description = Describe(volume);
    PlaceAsThePaper(description);
    description.Settings.Solver = this->GetParam();
    description.Cut =
      std::make_shared<CutAway>(std::move(planes), regions, description.IndexToWorld, isSolid);
    return description;
  }
};
} // namespace

TEST_P(CutOfSolver, NothingIsFeltInAPartThatIsCutAway)
{
  const TestVolume ramp = MakeRamp();
  for (const HapticMethod method : { HapticMethod::Proxy, HapticMethod::ForceField })
  {
    HapticModelDescription description =
      this->DescribeCut(ramp, { { { 1.0, 0.0, 0.0 }, 12.0 } }, {}, false);
    description.Settings.Method = method;
    description.Settings.ForceFieldGain = 0.01;
    description.Material.Viscosity = ConstantPolyline(0.2);
    const HapticModel cut(description);
    description.Cut = nullptr;
    const HapticModel whole(description);

    CutHand away(cut, { 8.0, 12.0, 10.0 });
    for (double z = 10.0; z < 14.0; z += 0.1)
    {
      const TickRecord& record = away.Tick({ 8.0, 12.0, z });
      // The method ForceField damps the hand even without a surface. The other methods have no
      // force there.
      const double damping = method == HapticMethod::ForceField ? record.DragForce : 0.0;
      EXPECT_NEAR(Norm(record.Force), damping, 1e-12);
    }
    // At least one voxel in front of the face, the forces must equal those without a cut.
    CutHand kept(cut, { 13.0, 12.0, 10.0 });
    CutHand same(whole, { 13.0, 12.0, 10.0 });
    for (double z = 10.0; z < 14.0; z += 0.1)
    {
      const Vector3 tip{ 13.0 + 0.1 * (z - 10.0), 12.0, z };
      const Vector3 force = kept.Tick(tip).Force;
      EXPECT_EQ(Norm(force - same.Tick(tip).Force), 0.0);
      EXPECT_TRUE(z < 11.0 || Norm(force) > 0.4);
    }
  }
}

TEST_P(CutOfSolver, ASurfaceEndsAtAnOpenFace)
{
  const TestVolume ramp = MakeRamp();
  const HapticModel model(this->DescribeCut(ramp, { { { -1.0, 0.0, 0.0 }, -12.0 } }, {}, false));
  CutHand hand(model, { 8.0, 12.0, 10.0 });
  EXPECT_NEAR(
    Norm(hand.MoveTo({ 8.0, 12.0, 12.0 }).Force), FaceStiffness * 2.0 * PerMillimetre, 1e-6);
  EXPECT_EQ(Norm(hand.MoveTo({ 13.0, 12.0, 12.0 }).Force), 0.0);
  EXPECT_LT(hand.GetEnergy(), 1.1e-3) << "the spring's, which is lost";
  EXPECT_GT(hand.GetEnergy(), 0.0);
}

TEST_P(CutOfSolver, ASolidFaceIsAWallOfItsMaterial)
{
  const TestVolume even = MakeEven(100.0);
  const Vector3 normal = (1.0 / std::sqrt(14.0)) * Vector3{ 1.0, 2.0, 3.0 };
  const Vector3 middle{ 16.0, 16.0, 16.0 };
  HapticModelDescription description =
    this->DescribeCut(even, { { normal, Dot(normal, middle) } }, {}, true);
  const HapticModel model(description);
  CutHand hand(model, middle - 4.0 * normal);
  EXPECT_EQ(Norm(hand.MoveTo(middle - 0.1 * normal).Force), 0.0);
  for (double depth = 0.5; depth < 3.9; depth += 0.1)
  {
    const TickRecord& record = hand.MoveTo(middle + depth * normal);
    const Vector3 force = (-FaceStiffness * depth * PerMillimetre) * normal;
    EXPECT_NEAR(Norm(record.Force - force), 0.0, 3e-3 + 1e-3 * Norm(force)) << depth;
    EXPECT_EQ(record.SurfaceValue, 100.0);
  }
  // The face holds up to its material's strength. A hand that presses harder breaks through.
  EXPECT_LE(Norm(hand.MoveTo(middle + 6.0 * normal).Force), FaceStrength * (1.0 + 1e-9));
  EXPECT_LT(Norm(hand.MoveTo(middle + 8.0 * normal).Force), 0.1);
  // While the hand leaves, no force acts.
  hand.MoveTo(middle + 2.0 * normal);
  EXPECT_LT(Norm(hand.MoveTo(middle - 2.0 * normal).Force), 1e-9);
  // The face of the cut has the strength of its material, which may be 0.
  description.Material.SurfaceStrength = { { 0.0, 2.0 }, { 99.0, 2.0 }, { 100.0, 0.0 } };
  const HapticModel soft(description);
  CutHand other(soft, middle - 4.0 * normal);
  EXPECT_EQ(Norm(other.MoveTo(middle + 3.0 * normal).Force), 0.0);
}

TEST_P(CutOfSolver, ACornerOfThreeFacesHoldsAHand)
{
  // The cut removes one of eight octants, so that three faces meet in a hollow corner.
  const TestVolume even = MakeEven(100.0);
  CutRegions regions;
  for (int axis = 0; axis < 3; ++axis)
  {
    regions.Low[axis] = 0.0;
    regions.High[axis] = 16.0;
  }
  regions.Kept = CutRegions::All & ~(1U << 26); // removes the octant above High along all axes
  const HapticModel model(this->DescribeCut(even, {}, regions, true));
  const Vector3 corner{ 16.0, 16.0, 16.0 };
  std::mt19937_64 engine(3);
  const auto draw = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  CutHand hand(model, corner + Vector3{ 4.0, 4.0, 4.0 });
  Vector3 tip = corner + Vector3{ 4.0, 4.0, 4.0 };
  double deepest = 0.0;
  int pushes = 0;
  for (int i = 0; i < 200; ++i)
  {
    const Vector3 goal =
      corner + 2.0 * Vector3{ 2.0 * draw() - 1.0, 2.0 * draw() - 1.0, 2.0 * draw() - 1.0 };
    const TickRecord& record = hand.MoveTo(goal);
    tip = goal;
    const Vector3 in = corner - hand.GetProxy();
    // The proxy must be at the point nearest to the tip outside the removed octant, which is a box.
    const Vector3 nearest = Most(goal, corner);
    const Vector3 wanted = (FaceStiffness * PerMillimetre) * (nearest - goal);
    deepest = std::max({ deepest, in.X, in.Y, in.Z });
    pushes += Norm(wanted) > 0.5 ? 1 : 0;
    // In the tick that meets the face, the tip moves by up to 0.1 mm, so the proxy may be wrong by
    // the same distance.
    EXPECT_NEAR(Norm(record.Force - wanted), 0.0, 0.1 * PerMillimetre * FaceStiffness) << i;
  }
  EXPECT_LT(deepest, 0.1);
  EXPECT_GT(pushes, 50);
}

INSTANTIATE_TEST_SUITE_P(
  CutContact, CutOfSolver, testing::Values(HapticSolver::Paper, HapticSolver::Precise));
