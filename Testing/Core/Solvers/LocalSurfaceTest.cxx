// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the surfaces that the slow loop fits to known shapes.
 */

#include "Rigs/LocalSurfaceRig.h"

using namespace coretest;

namespace
{
constexpr double Middle = 20.0;

LocalSurface Fit(const HapticModelDescription& description, const Vector3& where,
  const Vector3& ahead = {}, const Vector3& normal = {})
{
  return FitLocalSurface(HapticModel(description), { where, ahead, normal });
}
} // namespace

TEST(LocalSurface, OfARampIsItsLevel)
{
  const TestVolume volume = MakeRamp();
  for (const GradientEstimator estimator : { GradientEstimator::CentralDifference,
         GradientEstimator::Gaussian, GradientEstimator::CubicBSpline })
  {
    HapticModelDescription d = DescribeLocal(volume, 1230.0, LocalSurfaceShape::Quadric);
    d.Estimator = estimator;
    const LocalSurface found = Fit(d, { 10.3, 9.2, 9.0 });
    ASSERT_TRUE(found.IsThere);
    EXPECT_LE(Norm(found.Shape.Centre - Vector3{ 10.3, 9.2, 12.3 }), 1e-6);
    EXPECT_LE(Norm(found.Shape.Gradient - Vector3{ 0.0, 0.0, 1.0 }), 1e-9);
    EXPECT_NEAR(found.Shape.Depth({ 3.0, 17.0, 14.3 }), 2.0, 1e-6);
  }
}

TEST(LocalSurface, OfABallBendsAsItDoesAndOfACavityTheOtherWay)
{
  for (const double sign : { 1.0, -1.0 })
  {
    const TestVolume volume = MakeLocalBall(sign);
    const HapticModelDescription d = DescribeLocal(volume, 100.0, LocalSurfaceShape::Quadric);
    // The fit starts 2 mm from the surface, on the side of lower values.
    const Vector3 out = { 0.6, 0.0, 0.8 };
    const Vector3 centre{ Middle, Middle, Middle };
    const LocalSurface found = Fit(d, centre + (BallRadius + 2.0 * sign) * out);
    ASSERT_TRUE(found.IsThere);
    EXPECT_LE(Norm(found.Shape.Centre - (centre + BallRadius * out)), 0.01);
    EXPECT_LE(Norm(found.Shape.Gradient + sign * out), 0.002);
    for (const Vector3& t : { Vector3{ 0.0, 1.0, 0.0 }, Vector3{ 0.8, 0.0, -0.6 } })
    {
      EXPECT_NEAR(Dot(t, found.Shape.Curvature * t), -sign / BallRadius, 0.03 / BallRadius);
    }
    EXPECT_LE(Norm(found.Shape.Curvature * out), 1e-3 / BallRadius) << "none across itself";
  }
}

TEST(LocalSurface, IsFoundFromOutsideOnlyUnlessItHolds)
{
  const TestVolume volume = MakeRamp();
  HapticModelDescription d = DescribeLocal(volume, 1200.0);
  const Vector3 outside{ 10.0, 10.0, 10.0 };
  const Vector3 inside{ 10.0, 10.0, 14.0 };
  const Vector3 up{ 0.0, 0.0, 1.0 };
  EXPECT_TRUE(Fit(d, outside).IsThere);
  EXPECT_FALSE(Fit(d, inside).IsThere);
  EXPECT_TRUE(Fit(d, inside, {}, up).IsThere);
  d.Settings.Side = SurfaceSide::Lower;
  EXPECT_FALSE(Fit(d, outside).IsThere);
  EXPECT_LE(Norm(Fit(d, inside).Shape.Gradient + up), 1e-9);
  d.Settings.Side = SurfaceSide::Both;
  EXPECT_LE(Norm(Fit(d, outside).Shape.Gradient - up), 1e-9);
  EXPECT_LE(Norm(Fit(d, inside).Shape.Gradient + up), 1e-9);
  // Rounding has put the start on the other side of the surface. The hand must still be held from
  // the side of `up`.
  EXPECT_LE(Norm(Fit(d, { 10.0, 10.0, 12.0 + 1e-6 }, {}, up).Shape.Gradient - up), 1e-9);
}

TEST(LocalSurface, IsLookedForNearbyAndAlongTheWay)
{
  const TestVolume volume = MakeRamp();
  const HapticModelDescription d = DescribeLocal(volume, 1600.0);
  const Vector3 far{ 10.0, 10.0, 5.0 };
  EXPECT_FALSE(Fit(d, far).IsThere);
  EXPECT_TRUE(Fit(d, far, { 0.0, 3.0, 12.0 }).IsThere);
  EXPECT_FALSE(Fit(d, far, { 0.0, 0.0, 10.0 }).IsThere);
  EXPECT_FALSE(Fit(d, far, { 0.0, 0.0, -12.0 }).IsThere);
  EXPECT_TRUE(Fit(d, far, { 0.0, 0.0, 1e100 }).IsThere) << "cut to what is looked at";
  EXPECT_FALSE(Fit(d, far, { HUGE_VAL, 0.0, 0.0 }).IsThere);
}

TEST(LocalSurface, IsNowhereWhereThereIsNone)
{
  const TestVolume volume = MakeRamp();
  EXPECT_FALSE(Fit(DescribeLocal(volume, 1e6), { 10.0, 10.0, 10.0 }).IsThere);
  EXPECT_FALSE(Fit(DescribeLocal(volume, 1200.0), { NaN, 10.0, 10.0 }).IsThere);
  EXPECT_FALSE(Fit(DescribeLocal(volume, 1200.0), { 1e9, 1e9, 1e9 }).IsThere);
  TestVolume broken = MakeRamp();
  broken.Fill<double>([](std::int64_t, std::int64_t, std::int64_t) { return NaN; });
  EXPECT_FALSE(Fit(DescribeLocal(broken, 1200.0), { 10.0, 10.0, 10.0 }).IsThere);
}

TEST(LocalSurface, DoesNotDependOnWhereTheDeviceIsPlaced)
{
  const TestVolume volume = MakeLocalBall(1.0);
  const HapticModel model(DescribeLocal(volume, 100.0, LocalSurfaceShape::Quadric));
  const double s = std::sqrt(0.5);
  const HapticModel moved(model,
    { { { { 300.0 * s, 300.0 * s, 0.0 }, { -300.0 * s, 300.0 * s, 0.0 }, { 0.0, 0.0, 300.0 } } },
      { 1.1, 2.2, 3.3 } },
    {});
  const LocalSurfaceRequest request{ { 32.1, 25.3, 27.7 }, { -1.0, 0.5, 0.2 }, {} };
  const LocalSurface a = FitLocalSurface(model, request);
  const LocalSurface b = FitLocalSurface(moved, request);
  ASSERT_TRUE(a.IsThere);
  EXPECT_TRUE(IsSame(a.Shape.Centre, b.Shape.Centre));
  EXPECT_TRUE(IsSame(a.Shape.Gradient, b.Shape.Gradient));
  EXPECT_TRUE(IsSame(a.Shape.Curvature.Mixed, b.Shape.Curvature.Mixed));
}
