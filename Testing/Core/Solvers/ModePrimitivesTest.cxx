// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests modes on sampled fields with closed forms: vortices, fronts, shear and twisting fibres.
 */

#include "Rigs/ModeGrid.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

using namespace modegrid;

namespace
{
Vector3 AtAngle(double radius, double angle)
{
  return { radius * std::cos(angle), radius * std::sin(angle), 0.0 };
}

/// Returns a vortex around z. `speed(r)` is its speed at a distance r (mm).
template <typename F>
ModeGrid MakeVortex(F&& speed)
{
  return ModeGrid(96, 96, 8, 0.5, 3,
    [&](const Vector3& x, double* v)
    {
      const double r = std::hypot(x.X, x.Y);
      v[0] = -speed(r) * x.Y / r;
      v[1] = speed(r) * x.X / r;
    });
}
} // namespace

TEST(ModePrimitives, AVortexHoldsTheHandInAsStronglyAsItTurns)
{
  // P5: a Lamb-Oseen vortex with the curl 2 exp(-r^2/100 mm^2). The strength is proportional to the
  // curl, 2 N at a curl of 2.
  ModeGrid vortex = MakeVortex([](double r) { return 100.0 / r * -std::expm1(-r * r / 100.0); });
  vortex.Bake(ModeKind::VortexTube, { { 0.0, 0.0 }, { 2.0, 2.0 } });
  const double radii[4] = { 0.0, 5.0, 10.0, 20.0 };
  const double tips[4] = { 3.98, 8.1152, 11.4715, 20.0733 };
  const double forces[4] = { 1.99, 1.5576, 0.7358, 0.0366 };
  for (int i = 0; i < 4; ++i)
  {
    for (const double angle : { 0.3, 2.9 })
    {
      vortex.StartAt({});
      for (int tick = 1; tick <= 400; ++tick)
      {
        vortex.Move(AtAngle(tips[i] * tick / 400.0, angle));
      }
      // On the core line, the proxy stays within 0.01 voxel of the line. Elsewhere, the strength is
      // that of the flow, blurred by the sampler.
      EXPECT_NEAR(Norm(vortex.Motion.Proxy), 1e-3 * radii[i], i == 0 ? 5e-6 : 2e-5);
      EXPECT_NEAR(Norm(vortex.Motion.Force), forces[i], 0.005 * forces[i] + 1e-4);
      EXPECT_NEAR(
        Norm(vortex.Motion.Force - vortex.Field->ForceOf(0, vortex.Memory.Forces)), 0.0, 1e-12);
    }
  }
  // On the way back to the core, the proxy is free.
  for (int tick = 0; tick <= 400; ++tick)
  {
    vortex.Move(AtAngle(20.0 - 19.0 * tick / 400.0, 2.9));
  }
  EXPECT_LT(Norm(vortex.Motion.Force), 1e-3);
  EXPECT_NEAR(Norm(vortex.Motion.Proxy), 1e-3, 1e-5);
}

TEST(ModePrimitives, AHandThatWandersEndsOnAnObliqueCore)
{
  // P5: a Lamb-Oseen vortex around a line that meets no axis and no grid point. The hand begins 6
  // mm from the line and wanders within 3 mm of a point on the line. The proxy moves freely towards
  // the line, and is held against motion away from it.
  const Vector3 axis{ 0.48, -0.6, 0.64 };
  const Vector3 place{ 0.37, -0.21, 0.13 };
  const Vector3 across{ 0.8, 0.64, 0.0 };
  ModeGrid vortex(48, 48, 48, 0.5, 3,
    [&](const Vector3& x, double* v)
    {
      const Vector3 around = Cross(axis, x - place);
      const double square = Dot(around, around);
      const Vector3 flow = (100.0 / square * -std::expm1(-square / 100.0)) * around;
      v[0] = flow.X;
      v[1] = flow.Y;
      v[2] = flow.Z;
    });
  vortex.Bake(ModeKind::VortexTube, { { 0.0, 0.0 }, { 2.0, 2.0 } });
  Vector3 tip = place + (6.0 / Norm(across)) * across;
  vortex.StartAt(tip);
  const auto findDistance = [&] { return Norm(Cross(axis, 1e3 * vortex.Motion.Proxy - place)); };
  vortex.Move(tip);
  EXPECT_NEAR(findDistance(), 6.0, 0.01);
  std::mt19937_64 engine(8);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int way = 0; way < 100; ++way)
  {
    Vector3 to{ uniform(engine), uniform(engine), uniform(engine) };
    to = place + (3.0 * std::abs(uniform(engine)) / Norm(to)) * to;
    const Vector3 from = tip;
    for (int tick = 1; tick <= 50; ++tick)
    {
      tip = from + (tick / 50.0) * (to - from);
      vortex.Move(tip);
    }
  }
  EXPECT_LT(findDistance(), 0.01 * 0.5) << "a hundredth of a voxel";
  // The proxy moves freely along the core, and is held across it.
  vortex.Move(place + 2.0 * axis + (2.0 / Norm(across)) * across);
  EXPECT_NEAR(Norm(vortex.Motion.Force), 1.0, 0.01);
  EXPECT_NEAR(Dot(1e3 * vortex.Motion.Proxy - place, axis), 2.0, 0.01);
}

TEST(ModePrimitives, ARankineVortexEndsAtItsRadius)
{
  // P6: a Rankine vortex has a curl of 2 within 10 mm and no curl outside.
  ModeGrid vortex = MakeVortex([](double r) { return r < 10.0 ? r : 100.0 / r; });
  vortex.Bake(ModeKind::VortexTube, { { 1.0, 0.0 }, { 1.0, 2.0 } });
  vortex.StartAt({ 0.1, 0.0, 0.0 });
  double last = 0.0;
  for (double tip = 0.0; tip < 20.0; tip += 0.01)
  {
    vortex.Move({ tip, 0.0, 0.0 });
    const double r = 1e3 * Norm(vortex.Motion.Proxy);
    if (tip > 4.2 && r < 9.0)
    {
      ASSERT_NEAR(Norm(vortex.Motion.Force), 2.0, 1e-3) << r;
    }
    last = Norm(vortex.Motion.Force) > 1.0 ? r : last;
  }
  EXPECT_NEAR(last, 10.0, 0.5) << "within the kernel's voxel";
  EXPECT_LT(Norm(vortex.Motion.Force), 1e-3);
}

TEST(ModePrimitives, FrontsHoldAcrossAndSlideAlong)
{
  // The field v = x has spheres as fronts. It is linear, so the sampler reproduces it exactly.
  ModeGrid grid(56, 56, 56, 1.0, 3,
    [](const Vector3& x, double* v)
    {
      v[0] = x.X;
      v[1] = x.Y;
      v[2] = x.Z;
    });
  grid.Bake(ModeKind::TwoSidedFront, { { 0.0, 0.0 }, { 1.0, 2.0 } });
  grid.StartAt(AtAngle(20.0, 0.0));
  for (const double radius : { 18.0, 22.0 })
  {
    for (int tick = 0; tick <= 10000; ++tick)
    {
      const double angle = 2.0 * HalfTurn * tick / 1000.0;
      const double c = std::cos(0.5);
      const Vector3 tip = AtAngle(radius, angle);
      grid.Move({ tip.X, c * tip.Y, std::sin(0.5) * tip.Y });
    }
    EXPECT_NEAR(Norm(grid.Motion.Proxy), 0.020, 1e-6) << "10 turns on the sphere";
    EXPECT_NEAR(Norm(grid.Motion.Force), 1.0, 1e-3);
  }
  // The front is one-sided: the proxy moves freely outwards, along v, and is held inwards.
  grid.Bake(ModeKind::VectorFront, { { 0.0, 0.0 }, { 1.0, 2.0 } });
  grid.StartAt({ 15.0, 0.0, 0.0 });
  grid.Move({ 17.0, 0.0, 0.0 });
  EXPECT_LT(Norm(grid.Motion.Force), 1e-4);
  grid.Move({ 15.0, 0.0, 0.0 });
  EXPECT_NEAR(grid.Motion.Force.X, 1.0, 1e-4);
}

TEST(ModePrimitives, ShearHasALineAlongItsStretching)
{
  ModeGrid grid(10, 10, 10, 2.0, 3, [](const Vector3& x, double* v) { v[0] = 3.0 * x.Y; });
  grid.Bake(ModeKind::Shear, { { 0.0, 0.0 }, { 10.0, 10.0 } });
  const PrimitiveSet set = grid.At({ 1.3, -2.0, 0.7 });
  ASSERT_EQ(set.GetSize(), 1);
  EXPECT_EQ(set[0].Kind, PrimitiveKind::Line);
  EXPECT_NEAR(set[0].Strength, 1.5, 1e-12);
  EXPECT_NEAR(std::abs(Dot(set[0].Direction, { std::sqrt(0.5), std::sqrt(0.5), 0.0 })), 1.0, 1e-14);
  // The strength fades within two voxels of the border; at 1 mm (one voxel) from the border, a
  // quarter remains.
  EXPECT_NEAR(grid.At({ 8.0, 0.0, 0.0 })[0].Strength, 0.25 * 1.5, 1e-12);
  EXPECT_EQ(grid.At({ 9.01, 0.0, 0.0 })[0].Strength, 0.0);
}

TEST(ModePrimitives, TensorsAreInterpolatedAndNotTheirFibres)
{
  // P9: the fibres turn linearly along z, from the angle `From` (degrees) at the bottom to `To` at
  // the top. The eigenvalues are 1, 0.2, and 0.1 along z.
  struct Case
  {
    double From, To, Fraction, Angle, Kept;
  };
  for (const Case& of :
    { Case{ 30.0, 0.0, 0.5, 15.0, 0.866025 }, { 60.0, 20.0, 0.25, 51.380, 0.831 },
      { 80.0, 0.0, 0.25, 75.287, 0.522 }, { 60.0, -60.0, 0.5, 90.0, 0.5 } })
  {
    for (const int components : { 6, 9 })
    {
      ModeGrid grid(8, 8, 9, 1.0, components,
        [&](const Vector3& x, double* t)
        {
          const double fraction = (x.Z + 4.0) / 8.0;
          double c = 0.0;
          double s = 0.0;
          for (const auto& [degrees, weight] :
            { std::pair{ of.From, 1.0 - fraction }, std::pair{ of.To, fraction } })
          {
            c += weight * std::cos(2.0 * degrees * HalfTurn / 180.0);
            s += weight * std::sin(2.0 * degrees * HalfTurn / 180.0);
          }
          const double xx = 0.6 + 0.4 * c;
          const double yy = 0.6 - 0.4 * c;
          const double xy = 0.4 * s;
          const double six[6] = { xx, yy, 0.1, xy, 0.0, 0.0 };
          const double nine[9] = { xx, xy, 0.0, xy, yy, 0.0, 0.0, 0.0, 0.1 };
          std::copy_n(components == 6 ? six : nine, components, t);
        });
      grid.Bake(
        ModeKind::TensorFollow, { { 0.0, 0.0 }, { 1.0, 1.0 } }, { { 0.0, 0.0 }, { 1.0, 1.0 } });
      const PrimitiveSet set = grid.At({ 0.2, -0.3, 8.0 * of.Fraction - 4.0 });
      ASSERT_EQ(set.GetSize(), 3);
      const Vector3& fibre = set[0].Direction;
      double angle = std::atan2(fibre.Y, fibre.X) * 180.0 / HalfTurn;
      angle = angle < 0.0 ? angle + 180.0 : angle;
      EXPECT_NEAR(angle, of.Angle, 1e-3);
      // `Kept` is the fraction of the anisotropy that remains after interpolation: the eigenvalues
      // are l1 and l2 = 0.6 +- 0.4 Kept, and l3 = 0.1.
      const double l1 = 0.6 + 0.4 * of.Kept;
      EXPECT_NEAR(set[0].Strength, 0.8 * of.Kept / l1, 1e-3);
      EXPECT_NEAR(set[1].Strength, (0.5 - 0.4 * of.Kept) / l1, 1e-3);
      EXPECT_NEAR(std::abs(set[1].Direction.Z), 1.0, 1e-12);
      EXPECT_NEAR(Norm(set[1].Direction + set[2].Direction), 0.0, 1e-15);
    }
  }
}

TEST(ModePrimitives, SingularTensorsAndMissingVectorsAreNotFelt)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double value : { 0.0, -1.0, nan })
  {
    ModeGrid tensors(8, 8, 8, 1.0, 6,
      [&](const Vector3&, double* t)
      {
        std::fill_n(t, 6, 0.0);
        t[0] = t[1] = t[2] = value;
      });
    tensors.Bake(ModeKind::TensorFollow, ConstantPolyline(2.0), ConstantPolyline(2.0));
    EXPECT_EQ(tensors.At({}).SumStrengths(), 0.0);
    EXPECT_EQ(tensors.At({}).GetSize(), 3) << "and all keep their places";
    EXPECT_EQ(tensors.At({ 50.0, 0.0, 0.0 }).GetSize(), 3);
    ModeGrid vectors(
      8, 8, 8, 1.0, 3, [&](const Vector3&, double* v) { v[0] = value == -1.0 ? 0.0 : value; });
    for (const ModeKind kind : { ModeKind::VectorFollow, ModeKind::VectorFront,
           ModeKind::TwoSidedFront, ModeKind::VortexTube, ModeKind::Shear })
    {
      vectors.Bake(kind, { { 0.0, 0.0 }, { 1.0, 2.0 } }, { { 0.0, 0.0 }, { 1.0, 2.0 } });
      EXPECT_EQ(vectors.At({}).SumStrengths(), 0.0);
      EXPECT_EQ(vectors.At({}).GetSize(), FactsOf(kind).Primitives);
      vectors.StartAt({});
      vectors.Move({ 1.0, 0.5, 0.0 });
      EXPECT_EQ(Norm(vectors.Motion.Force), 0.0);
    }
    EXPECT_TRUE(tensors.Field->Add(*tensors.Baked));
    EXPECT_FALSE(tensors.Field->Add(*tensors.Baked)) << "eight primitives at most";
    EXPECT_EQ(tensors.Field->GetCount(), 3) << "it keeps its number";
    EXPECT_EQ(tensors.At({}).GetSize(), 6);
    // A mode for tensors must refuse a vector field.
    vectors.Mode.Kind = ModeKind::TensorFollow;
    EXPECT_FALSE(BakedMode(vectors.Mode, vectors.IndexToWorld).IsValid());
  }
}

TEST(ModePrimitives, TurnWithTheirData)
{
  // P11: the same array in a rotated world, with its components along the image axes.
  std::mt19937_64 engine(4);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  ModeGrid grid(12, 12, 12, 1.0, 3,
    [&](const Vector3& x, double* v)
    {
      v[0] = 1.0 + std::sin(0.4 * x.Y);
      v[1] = std::cos(0.3 * x.Z);
      v[2] = 0.5 * std::sin(0.5 * x.X);
    });
  ModeGrid turned(12, 12, 12, 1.0, 3, [](const Vector3&, double*) {});
  std::copy(grid.Samples.begin(), grid.Samples.end(), turned.Samples.begin());
  const Vector3 a{ 0.36, 0.48, -0.8 };
  const Vector3 b{ -0.8, 0.6, 0.0 };
  const Matrix3 turn = Matrix3::FromColumns(a, b, Cross(a, b));
  turned.IndexToWorld = Compose({ turn, {} }, grid.IndexToWorld);
  turned.Mode.Axes = VectorAxes::Image;
  for (const ModeKind kind :
    { ModeKind::VectorFollow, ModeKind::TwoSidedFront, ModeKind::VortexTube, ModeKind::Shear })
  {
    grid.Bake(kind, { { 0.0, 0.0 }, { 1.0, 1.5 } }, ConstantPolyline(0.2));
    turned.Bake(kind, { { 0.0, 0.0 }, { 1.0, 1.5 } }, ConstantPolyline(0.2));
    double worst = 0.0;
    Vector3 tip;
    for (int tick = 0; tick < 2000; ++tick)
    {
      tip += 0.2 * Vector3{ uniform(engine), uniform(engine), uniform(engine) } - 0.02 * tip;
      grid.Move(tip);
      turned.Move(turn * tip);
      worst = std::max(worst, Norm(turn * grid.Motion.Force - turned.Motion.Force));
    }
    EXPECT_LT(worst, 1e-12) << "mode " << int(kind);
  }
}
