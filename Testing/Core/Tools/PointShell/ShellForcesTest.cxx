// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Compares forces and torques of shells with closed forms. A sphere of radius a at a depth delta in
 * a half-space has the area 2 pi a dh between the depths h and h + dh (Archimedes), so
 *
 *   F = integral of p(h) 2 pi a dh = pi kappa a delta^2,
 *
 * If a largest pressure P is reached at d_c = P/kappa, F = pi kappa a d_c (2 delta - d_c).
 */

#include "Rigs/ShellRig.h"

#include <gtest/gtest.h>

using namespace coretest;

namespace
{
constexpr double SphereRadius = 5.0;
/// z (mm) of the ramp's surface. Values above it are solid.
constexpr double Surface = 10.0;

class ShellForces : public testing::Test
{
protected:
  ShellForces() { this->Settings.Level = 100.0 * Surface; }

  /// Lowers a shell by `way` (mm). Returns the sum of its contacts.
  ShellSum Lower(const HapticModel& model, const PointShell& shell, const Vector3& from, double way,
    const Quaternion& turn) const
  {
    const ShellContactFinder finder(model, shell, this->Settings);
    ShellContacts contacts[2] = { ShellContacts(shell.GetSize()), ShellContacts(shell.GetSize()) };
    ShellClearance clearance(shell.GetBlocks().size());
    ShellSum sum;
    constexpr int steps = 8;
    for (int i = 0; i <= steps; ++i)
    {
      const Vector3 at = from + Vector3{ 0.0, 0.0, way * i / steps };
      clearance.Reset();
      finder.Collect(
        { 0.001 * at, turn }, 0.0, false, contacts[i % 2], contacts[1 - i % 2], clearance, sum);
    }
    return sum;
  }
  /// Computes S1 for 200 orientations. Returns the largest relative error of the force.
  double ComputeWorstError(int points, double expected) const
  {
    const HapticModel model(this->Scene);
    const PointShell shell(MakeSphere(SphereRadius, points));
    std::mt19937_64 engine(11);
    double worst = 0.0;
    for (int i = 0; i < 200; ++i)
    {
      const ShellSum sum =
        this->Lower(model, shell, { 11.3, 12.1, Surface - SphereRadius }, 1.0, RandomTurn(engine));
      worst = std::max(worst, std::abs(sum.Gradient[2] / expected - 1.0));
    }
    return worst;
  }

  const TestVolume Volume = MakeRamp();
  HapticModelDescription Scene = Describe(this->Volume);
  ShellSettings Settings;
};
} // namespace

/// S1 of the design: the force is pi kappa a delta^2 = 0.3142 N.
TEST_F(ShellForces, ASphereInAHalfSpace)
{
  const double expected = Pi * Kappa * 5e-3 * 1e-6;
  EXPECT_NEAR(expected, 0.3142, 5e-5);
  EXPECT_LE(this->ComputeWorstError(10000, expected), 0.001);
  EXPECT_LE(this->ComputeWorstError(1000, expected), 0.01);
}

/// S2: a strength of 0.25 N on the default contact area limits the pressure to 10 kPa.
TEST_F(ShellForces, ASphereOnTissueThatYields)
{
  this->Scene.Material.SurfaceStrength = ConstantPolyline(0.25);
  const double most = 0.25 / 2.5e-5 / Kappa;
  const double expected = Pi * Kappa * 5e-3 * most * (2e-3 - most);
  EXPECT_NEAR(expected, 0.2356, 5e-5);
  EXPECT_LE(this->ComputeWorstError(10000, expected), 0.001);
}

/// S3: k (2 mm - delta) = pi kappa a delta^2 gives a depth delta of 1.1578 mm and a force of 0.4211
/// N.
TEST_F(ShellForces, ASphereInTheHand)
{
  ShellHand hand(this->Scene, MakeSphere(SphereRadius, 10000), this->Settings);
  const Vector3 above{ 12.0, 12.0, Surface - SphereRadius - 1.0 };
  hand.Tick(above);
  hand.Lead(above + Vector3{ 0.0, 0.0, 3.0 });
  const auto& record = hand.Rest();
  const double b = 500.0 / (Pi * Kappa * 5e-3);
  const double delta = 0.5 * (std::sqrt(b * b + 4.0 * b * 2e-3) - b);
  EXPECT_NEAR(delta, 1.1578e-3, 5e-8);
  EXPECT_NEAR(record.Force.Z, -500.0 * (2e-3 - delta), 0.4211e-2);
  EXPECT_NEAR(1000.0 * record.Tool.Position.Z, Surface - SphereRadius + 1000.0 * delta, 0.01);
  EXPECT_LE(std::hypot(record.Force.X, record.Force.Y), 1e-3);
  EXPECT_LE(Norm(record.Torque), 1e-5);
  EXPECT_FALSE(record.IsUnfinished);
}

/// S4: the force is kappa times the area times the depth of 0.1 mm. A tilt by theta about the
/// middle gives the torque kappa b h^3/12 theta.
TEST_F(ShellForces, AFlatFaceAndItsTilt)
{
  const HapticModel model(this->Scene);
  const PointShell shell(MakeSquare(10.0, 100));
  const Vector3 above{ 12.2, 11.9, Surface - 0.1 };
  const ShellSum flat = this->Lower(model, shell, above, 0.2, {});
  EXPECT_NEAR(flat.Gradient[2], 0.2, 0.2e-2);
  EXPECT_NEAR(flat.Gradient[3], 0.0, 1e-9);
  EXPECT_NEAR(flat.Gradient[4], 0.0, 1e-9);
  const ShellSum tilted = this->Lower(model, shell, above, 0.2, TurnAbout({ 1.0, 0.0, 0.0 }, 1e-3));
  EXPECT_NEAR(tilted.Gradient[2], 0.2, 0.2e-2);
  const double torque = Kappa * 0.01 * 1e-6 / 12.0 * 1e-3;
  EXPECT_NEAR(torque, 1.667e-5, 1e-8);
  // The energy grows with the angle, so the tissue turns the face back.
  EXPECT_NEAR(tilted.Gradient[3], torque, 0.01 * torque);
}

/// S4 with a spring: the tool rotates until the spring's torque, k_r times the remaining angle,
/// equals the torque of the face.
TEST_F(ShellForces, ATiltedFaceTurnsInTheHand)
{
  ShellSettings settings = this->Settings;
  settings.TurningStiffness = 0.02;
  ShellHand hand(this->Scene, MakeSquare(10.0, 100), settings);
  const Quaternion tilt = TurnAbout({ 1.0, 0.0, 0.0 }, 1e-3);
  const Vector3 above{ 12.0, 12.0, Surface - 0.1 };
  hand.Tick(above, tilt);
  hand.Lead(above + Vector3{ 0.0, 0.0, 0.6 }, 0.02, tilt);
  const auto& record = hand.Rest(200);
  // In balance, k (0.5 mm - d) = kappa A d for the depth d.
  EXPECT_NEAR(record.Force.Z, -500.0 * 2000.0 / 2500.0 * 0.5e-3, 2e-3);
  const double face = Kappa * 0.01 * 1e-6 / 12.0;
  const double expected = face * settings.TurningStiffness / (face + settings.TurningStiffness);
  EXPECT_NEAR(record.Torque.X, -1e-3 * expected, 1e-5 * expected);
  EXPECT_NEAR(record.Torque.Y, 0.0, 1e-8);
}

/// S5: without friction, a sphere rotates freely in a hollow sphere, even under pressure.
TEST_F(ShellForces, ASphereTurnsFreelyInASphere)
{
  const TestVolume cavity = MakeCavity(48);
  HapticModelDescription scene = Describe(cavity);
  ShellHand hand(scene, MakeSphere(10.0, 10000), this->Settings);
  const Vector3 middle{ 23.5, 23.5, 23.5 };
  hand.Tick(middle);
  hand.Lead(middle + Vector3{ 0.6, 0.8, 0.0 });
  EXPECT_GT(Norm(hand.Rest().Force), 0.2);
  const double scale = Norm(hand.Record.Force) * 0.01;
  double most = 0.0;
  for (int i = 1; i <= 200; ++i)
  {
    const Quaternion turn = TurnAbout({ 0.3, 0.5, 0.8 }, 0.005 * i);
    most = std::max(most, Norm(hand.Tick(middle + Vector3{ 0.6, 0.8, 0.0 }, turn).Torque));
  }
  EXPECT_LE(most, 0.001 * scale);
}

/// If tool, hand and world are rotated and moved together, force and torque rotate with them. They
/// must not depend on the grid.
TEST_F(ShellForces, AreTheSameWhateverTheOrientation)
{
  // An asymmetric tool is lowered and turned, in two worlds.
  std::vector<ShellPoint> points = MakeSphere(4.0, 500);
  for (ShellPoint& point : points)
  {
    point.Position.X *= 1.5;
    point.Position.Y += 1e-3;
  }
  const auto lead = [&](const HapticModelDescription& scene, const Affine3& world)
  {
    ShellHand hand(scene, points, this->Settings);
    const Quaternion turn = ToQuaternion(world.Linear);
    for (int i = 0; i <= 200; ++i)
    {
      const Vector3 at{ 12.0 + 0.005 * i, 11.0, 4.0 + 0.02 * i };
      hand.TickAt({ 0.001 * world(at), turn * TurnAbout({ 0.2, 1.0, 0.1 }, 1e-3 * i) });
    }
    return hand.Record;
  };
  const ShellRecord expected = lead(this->Scene, {});
  EXPECT_GT(Norm(expected.Force), 0.3);
  EXPECT_GT(Norm(expected.Torque), 1e-4);
  const Affine3 world{ ToMatrix(TurnAbout({ 1.0, 2.0, -0.5 }, 0.7)), { 30.0, -20.0, 5.0 } };
  HapticModelDescription turned = this->Scene;
  turned.IndexToWorld = world;
  const ShellRecord record = lead(turned, world);
  EXPECT_LE(Norm(record.Force - world.Linear * expected.Force), 1e-12 * Norm(expected.Force));
  EXPECT_LE(Norm(record.Torque - world.Linear * expected.Torque), 1e-11 * Norm(expected.Torque));
  // Sample the same ramp on a finer grid.
  TestVolume fine(ScalarType::Float64, { 47, 24, 93 });
  fine.Fill<double>([](std::int64_t, std::int64_t, std::int64_t k) { return 25.0 * k; });
  HapticModelDescription other = Describe(fine);
  other.IndexToWorld.Linear = Matrix3{ { { 0.5, 0, 0 }, { 0, 1, 0 }, { 0, 0, 0.25 } } };
  const ShellRecord again = lead(other, {});
  EXPECT_LE(Norm(again.Force - expected.Force), 0.002 * Norm(expected.Force));
  EXPECT_LE(Norm(again.Torque - expected.Torque), 0.002 * Norm(expected.Torque));
}

/// In this test, values below the level are solid.
TEST_F(ShellForces, TheSolidMayBeBelowTheLevel)
{
  this->Settings.IsBelow = true;
  ShellHand hand(this->Scene, MakeSphere(SphereRadius, 5000), this->Settings);
  const Vector3 below{ 12.0, 12.0, Surface + SphereRadius + 1.0 };
  hand.Tick(below);
  hand.Lead(below - Vector3{ 0.0, 0.0, 3.0 });
  EXPECT_NEAR(hand.Rest().Force.Z, 0.4211, 0.4211e-2);
}

/// The edge is 2 voxels wide, with a plateau behind it, and the tool is pressed deeper.
TEST_F(ShellForces, AToolIsHeldDeeperThanTheEdgeIsWide)
{
  TestVolume edge(ScalarType::Int16, { 40, 40, 40 });
  edge.Fill<std::int16_t>([](std::int64_t, std::int64_t, std::int64_t k)
    { return static_cast<std::int16_t>(std::clamp<std::int64_t>(500 * (k - 18), 0, 1000)); });
  HapticModelDescription scene = Describe(edge);
  scene.DeviceToWorld.Linear = 2000.0 * Matrix3{}; // makes voxels of 0.5 mm
  scene.Material.SurfaceStrength = ConstantPolyline(100.0);
  this->Settings.Level = 500.0; // at 9.5 mm
  ShellHand hand(scene, MakeSphere(4.0, 8000), this->Settings);
  hand.Tick({ 10.0, 10.0, 5.0 });
  hand.Lead({ 10.0, 10.0, 10.5 });
  const auto& record = hand.Rest();
  // In balance, k (5 mm - delta) = pi kappa a delta^2 for the depth delta, as in S3.
  const double b = 500.0 / (Pi * Kappa * 4e-3);
  const double delta = 0.5 * (std::sqrt(b * b + 4.0 * b * 5e-3) - b);
  EXPECT_GT(delta, 2e-3) << "more than four voxels";
  EXPECT_NEAR(record.Force.Z, -500.0 * (5e-3 - delta), 0.01 * 500.0 * (5e-3 - delta));
  EXPECT_FALSE(record.IsUnfinished);
}
