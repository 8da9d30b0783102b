// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Compares the model of hfab arms with the published arithmetic (forsslund/hfabapi, commit cf00e97,
 * in Emulators/HfabEmulator.cxx). Derivatives are checked by differences of positions.
 */

#include "Devices/Hfab/HfabModel.h"
#include "Emulators/HfabEmulator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace VolumeHaptics;
using emulated::HfabEmulator;
using emulated::Triple;

namespace
{
constexpr double Circle = 6.283185307179586;

/**
 * Returns the calibration pose first, followed by random poses around the middle of the workspace.
 */
class HfabPoses
{
public:
  explicit HfabPoses(int model)
    : Model(model)
    , Random(static_cast<unsigned>(model))
  {
  }
  HfabModel::Counts Next()
  {
    const HfabGeometry& geometry = *HfabModel::Find(this->Model);
    if (this->IsFirst)
    {
      this->IsFirst = false;
      return geometry.Home;
    }
    // Angles in rad. Polhem's calibration pose is at the limits of its joints, so use the pose
    // whose published position is the origin as the middle of its workspace.
    const HfabModel::Angles home = HfabModel::ComputeAngles(geometry, geometry.Home);
    const HfabModel::Angles middle =
      this->Model == 1 ? HfabModel::Angles{ 0.0, 0.913, 2.36 } : home;
    std::uniform_real_distribution<double> turn(-0.4, 0.4);
    HfabModel::Counts counts{};
    for (std::size_t j = 0; j < 3; ++j)
    {
      const double perRadian = geometry.Signs[j] * geometry.CountsPerTurn / Circle *
        geometry.Body[j] / geometry.Capstan[j];
      counts[j] = static_cast<int>((middle[j] + turn(this->Random)) * perRadian);
    }
    return counts;
  }

private:
  const int Model;
  std::mt19937 Random;
  bool IsFirst = true;
};

Triple AnglesOf(int model, const HfabModel::Counts& counts)
{
  return HfabEmulator::AnglesOf(model, { counts[0], counts[1], counts[2] });
}

Vector3 TipAtHome(int model)
{
  const HfabGeometry& geometry = *HfabModel::Find(model);
  Vector3 tip;
  EXPECT_TRUE(
    HfabModel::ComputeTip(geometry, HfabModel::ComputeAngles(geometry, geometry.Home), tip));
  return tip;
}
} // namespace

TEST(HfabModels, PositionsAreThePublishedOnes)
{
  for (int model = 1; model <= 3; ++model)
  {
    SCOPED_TRACE(model);
    const HfabGeometry& geometry = *HfabModel::Find(model);
    HfabPoses poses(model);
    for (int i = 0; i < 300; ++i)
    {
      const HfabModel::Counts counts = poses.Next();
      const Triple published = HfabEmulator::TipOf(model, AnglesOf(model, counts));
      Vector3 tip;
      ASSERT_TRUE(HfabModel::ComputeTip(geometry, HfabModel::ComputeAngles(geometry, counts), tip));
      EXPECT_LT(Norm(tip - Vector3{ published[0], published[1], published[2] }), 1e-9);
    }
  }
}

TEST(HfabModels, PosesForCalibrationCanBeWorkedOutByHand)
{
  // WoodenHaptics' calibration pose: upper arm upright, forearm level. 6000 counts are 90 degrees
  // of the forearm, with 2000 counts per turn and a gear of 1:12.
  EXPECT_LT(Norm(TipAtHome(3) - Vector3{ 0.245 - 0.22, 0.0, 0.205 }), 1e-12);
  // PHANToM's calibration pose: upper arm level, forearm hanging. 7700 counts are 90 degrees of the
  // upper arm, with 4000 counts per turn and a gear of 1:7.7.
  EXPECT_LT(Norm(TipAtHome(2) - Vector3{ 0.0, 0.0, 0.097 - 0.112 }), 1e-12);
}

TEST(HfabModels, JacobiansAreTheDifferenceQuotients)
{
  constexpr double h = 1e-6;
  for (int model = 1; model <= 3; ++model)
  {
    SCOPED_TRACE(model);
    const HfabGeometry& geometry = *HfabModel::Find(model);
    HfabPoses poses(model);
    for (int i = 0; i < 300; ++i)
    {
      const HfabModel::Angles at = HfabModel::ComputeAngles(geometry, poses.Next());
      Matrix3 jacobian;
      ASSERT_TRUE(HfabModel::ComputeJacobian(geometry, at, jacobian));
      const Matrix3 columns = Transpose(jacobian);
      for (std::size_t j = 0; j < 3; ++j)
      {
        HfabModel::Angles above = at;
        HfabModel::Angles below = at;
        above[j] += h;
        below[j] -= h;
        Vector3 a;
        Vector3 b;
        ASSERT_TRUE(HfabModel::ComputeTip(geometry, above, a));
        ASSERT_TRUE(HfabModel::ComputeTip(geometry, below, b));
        EXPECT_LT(Norm(columns.Row[j] - (0.5 / h) * (a - b)), 1e-8);
      }
    }
  }
}

TEST(HfabModels, CurrentsAreThePublishedOnes)
{
  for (int model = 1; model <= 3; ++model)
  {
    SCOPED_TRACE(model);
    const HfabGeometry& geometry = *HfabModel::Find(model);
    HfabPoses poses(model);
    for (int i = 0; i < 300; ++i)
    {
      const HfabModel::Counts counts = poses.Next();
      const Vector3 force{ 0.5 * std::cos(i), 0.5 * std::sin(i), 0.3 };
      const auto currents =
        HfabModel::ComputeCurrents(geometry, HfabModel::ComputeAngles(geometry, counts), force);
      const Triple published =
        HfabEmulator::CurrentsOf(model, AnglesOf(model, counts), { force.X, force.Y, force.Z });
      for (int j = 0; j < 3; ++j)
      {
        EXPECT_NEAR(currents[j], published[j], 0.51) << "rounded to a milliampere";
      }
    }
  }
}

TEST(HfabModels, CurrentsSaturateTogetherAndWhatIsNoNumberIsNone)
{
  const HfabGeometry& geometry = *HfabModel::Find(3);
  const HfabModel::Angles at = HfabModel::ComputeAngles(geometry, geometry.Home);
  const auto large = HfabModel::ComputeCurrents(geometry, at, { 30.0, 40.0, 50.0 });
  EXPECT_EQ(HfabModel::ComputeCurrents(geometry, at, { 30e9, 40e9, 50e9 }), large)
    << "the direction stays";
  int most = 0;
  for (const int current : large)
  {
    most = std::max(most, std::abs(current));
  }
  EXPECT_EQ(most, 3000);
  const std::array<int, 3> none{};
  for (const double bad : { std::numeric_limits<double>::quiet_NaN(), HUGE_VAL })
  {
    EXPECT_EQ(HfabModel::ComputeCurrents(geometry, at, { bad, 1.0, 1.0 }), none);
    EXPECT_EQ(HfabModel::ComputeCurrents(geometry, { bad, 1.0, 1.0 }, { 1.0, 1.0, 1.0 }), none);
  }
}

TEST(HfabModels, ALinkageThatCannotCloseHasNoTip)
{
  const HfabGeometry& geometry = *HfabModel::Find(1);
  // In this pose, the ends of the cranks are 151 mm apart, less than the rod (190 mm) and its crank
  // (34 mm) allow.
  const HfabModel::Angles folded{ 0.0, 2.178, 3.6 };
  Vector3 tip;
  EXPECT_TRUE(std::isnan(HfabEmulator::TipOf(1, { folded[0], folded[1], folded[2] })[0]));
  EXPECT_FALSE(HfabModel::ComputeTip(geometry, folded, tip));
  EXPECT_EQ(
    HfabModel::ComputeCurrents(geometry, folded, { 1.0, 1.0, 1.0 }), (std::array<int, 3>{}));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(HfabModel::ComputeTip(geometry, { 0.0, nan, 3.0 }, tip));
  EXPECT_FALSE(HfabModel::ComputeTip(geometry, { 0.0, 0.0, nan }, tip));
  for (const int model : { 0, 4, -1, 2147483647 })
  {
    EXPECT_EQ(HfabModel::Find(model), nullptr);
  }
}

TEST(HfabModels, ThePolhemsHandleTurnsWithItsEncoders)
{
  const HfabGeometry& geometry = *HfabModel::Find(1);
  HfabModel::Counts counts = geometry.Home;
  const Quaternion before = HfabModel::ComputeOrientation(geometry, counts);
  EXPECT_NEAR(SquaredNorm(before), 1.0, 1e-12);
  // The last joint rotates the handle by 90 degrees about its own axis, which is the stylus' z.
  counts[5] += 256;
  const Quaternion turn = Conjugate(before) * HfabModel::ComputeOrientation(geometry, counts);
  EXPECT_NEAR(std::abs(turn.W), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(turn.X, 0.0, 1e-12);
  EXPECT_NEAR(turn.Y, 0.0, 1e-12);
  EXPECT_NEAR(std::abs(turn.Z), std::sqrt(0.5), 1e-12);
  // The first motor rotates the arm and the handle about the vertical, which is the device's y.
  counts = geometry.Home;
  const double quarter =
    geometry.CountsPerTurn / 4.0 * geometry.Body[0] / geometry.Capstan[0] * geometry.Signs[0];
  counts[0] += static_cast<int>(std::lround(quarter));
  const Quaternion swing = HfabModel::ComputeOrientation(geometry, counts) * Conjugate(before);
  EXPECT_NEAR(std::abs(swing.W), std::sqrt(0.5), 1e-3);
  EXPECT_NEAR(swing.X, 0.0, 1e-12);
  EXPECT_NEAR(std::abs(swing.Y), std::sqrt(0.5), 1e-3);
  EXPECT_NEAR(swing.Z, 0.0, 1e-12);
}

TEST(HfabModels, ThePhantomsHandleTurnsWithItsForearmAndItsGimbal)
{
  const HfabGeometry& geometry = *HfabModel::Find(2);
  HfabGeometry longer = geometry;
  longer.Lengths[2] += 1.0;
  const auto pointsAlong = [](const Quaternion& turn, const Vector3& ownAxis)
  {
    const Quaternion p =
      turn * Quaternion{ 0.0, ownAxis.X, ownAxis.Y, ownAxis.Z } * Conjugate(turn);
    return Vector3{ p.X, p.Y, p.Z };
  };
  for (const HfabModel::Counts& counts :
    { HfabModel::Counts{ 0, 7700, 0, 0, 0, 0 }, HfabModel::Counts{ 900, 5000, -6000, 0, 0, 0 },
      HfabModel::Counts{ -1500, 9000, 4000, 0, 0, 0 } })
  {
    // Lengthen the forearm by 1 m: the tip then moves 1 m along the forearm. In the calibration
    // pose, this is also the axis of the handle.
    const HfabModel::Angles angles = HfabModel::ComputeAngles(geometry, counts);
    Vector3 tip;
    Vector3 farther;
    ASSERT_TRUE(HfabModel::ComputeTip(geometry, angles, tip));
    ASSERT_TRUE(HfabModel::ComputeTip(longer, angles, farther));
    const Vector3 forearm = HfabModel::ToDevice(farther - tip);
    const Quaternion rest = HfabModel::ComputeOrientation(geometry, counts);
    EXPECT_NEAR(SquaredNorm(rest), 1.0, 1e-12);
    EXPECT_NEAR(Norm(pointsAlong(rest, { 0.0, 0.0, 1.0 }) - forearm), 0.0, 1e-12);
    // Turn each gimbal joint by 90 degrees. With the published signs, the joints' axes are up (y),
    // right (x), and the handle itself (z).
    const auto by = [&](std::size_t encoder)
    {
      HfabModel::Counts turned = counts;
      turned[encoder] += 500;
      return Conjugate(rest) * HfabModel::ComputeOrientation(geometry, turned);
    };
    const double half = std::sqrt(0.5);
    const Quaternion expected[] = { { half, 0.0, -half, 0.0 }, { half, half, 0.0, 0.0 },
      { half, 0.0, 0.0, half } };
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Quaternion off = Conjugate(expected[i]) * by(3 + i);
      EXPECT_NEAR(std::abs(off.W), 1.0, 1e-9) << "encoder " << 3 + i;
    }
  }
}
