// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests presses onto a ball with a known surface and known opacity. */

#include "Presses.h"

#include "Methods.h"
#include "Shapes.h"

#include "VTK/Filter/HapticBaker.h"

#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace evaluation;

namespace
{
constexpr double BallRadius = 12.0;

/** Makes a filter that assigns the same frictionless material to all values. */
vtkSmartPointer<vtkVolumeHapticsFilter> MakeFilter(vtkImageData* image, double stiffness,
  double drag = 0.0, double strength = Impenetrable, double scale = 1.0)
{
  auto filter = vtkSmartPointer<vtkVolumeHapticsFilter>::New();
  filter->SetInputDataObject(0, image);
  filter->SetMetersPerWorldUnit(0.001 * scale);
  vtkHapticProperty* const feel = filter->GetProperty();
  SetConstant(feel->GetStiffness(), stiffness);
  SetConstant(feel->GetFriction(), 0.0);
  SetConstant(feel->GetViscosity(), drag);
  SetConstant(feel->GetSurfaceStrength(), strength);
  SetConstant(feel->GetDistinctness(), 1.0);
  return filter;
}

std::shared_ptr<const HapticModel> Bake(vtkVolumeHapticsFilter* filter)
{
  return filter->GetBaker().Bake(1000.0, {}, nullptr);
}

/** Returns a ball of `value` surrounded by 0, with a stiffness (N/m). */
PressedVolume MakeBall(double stiffness, vtkSmartPointer<vtkImageData>& image,
  double radius = BallRadius, double scale = 1.0, double value = 100.0)
{
  image =
    SampleImage([=](const Vector3& x) { return BlurredStep(radius - Norm(x), 1.0, value); }, 20.0);
  PressedVolume ball;
  ball.Model = ball.Shape = ball.Structures = ball.Held =
    Bake(MakeFilter(image, stiffness, 0.0, Impenetrable, scale));
  ball.Level = ball.HeldLevel = 50.0;
  ball.Scale = scale;
  ball.Box = { -BallRadius, BallRadius, -BallRadius, BallRadius, -BallRadius, BallRadius };
  ball.Voxel = { 1.0, 1.0, 1.0 };
  ball.Extinction = [](const Vector3& x) { return Norm(x) < BallRadius ? 50.0 : 0.0; };
  return ball;
}
} // namespace

TEST(Presses, AHardBallIsFeltAndSeenWhereItIs)
{
  vtkSmartPointer<vtkImageData> image;
  const Presses found = PressFromAllSides(MakeBall(1000.0, image), 60);
  EXPECT_GT(found.Count, 30);
  EXPECT_EQ(found.Unfelt, 0);
  EXPECT_NEAR(ComputeMedian(found.OffSurface), 0.0, 0.2);
  EXPECT_LT(FindLargest(found.OffSurface, 1.0), 0.4);
  EXPECT_NEAR(ComputeMedian(found.OffSeen), 0.0, 0.4);
}

TEST(Presses, IsAstrayIfNoStructureIsNear)
{
  vtkSmartPointer<vtkImageData> image;
  PressedVolume ball = MakeBall(1000.0, image);
  EXPECT_EQ(PressFromAllSides(ball, 60).Astray, 0);
  for (const double radius : { 10.5, 9.5 }) // the core is 1.5 or 2.5 voxels deeper
  {
    vtkSmartPointer<vtkImageData> other;
    ball.Structures = MakeBall(1000.0, other, radius).Shape;
    const Presses found = PressFromAllSides(ball, 60);
    EXPECT_EQ(found.Astray, radius < 10.0 ? found.Count : 0);
  }
}

TEST(Presses, APlateauInAirIsAstrayEvenIfTheMaterialHoldsIt)
{
  // A blanket of value 40, below the level of the surface, begins 6 voxels in front of the ball.
  // The materials resist in the blanket, so the hand touches the blanket instead of the ball.
  constexpr double blanket = BallRadius + 6.0;
  vtkSmartPointer<vtkImageData> image;
  PressedVolume ball = MakeBall(1000.0, image);
  ball.Extinction = [](const Vector3&) { return 0.0; };
  const auto covered = SampleImage(
    [](const Vector3& x)
    {
      return BlurredStep(BallRadius - Norm(x), 1.0, 60.0) +
        BlurredStep(blanket - Norm(x), 1.0, 40.0);
    },
    25.0);
  ball.Model = ball.Shape = ball.Structures = ball.Held = Bake(MakeFilter(covered, 1000.0));
  ball.HeldLevel = 20.0;
  const Presses found = PressFromAllSides(ball, 60);
  ASSERT_GT(found.OffSurface.size(), 10u);
  EXPECT_LT(ComputeMedian(found.OffSurface), -4.0);
  EXPECT_EQ(found.Astray, static_cast<int>(found.OffSurface.size()));
  EXPECT_EQ(found.AstrayOfHeld, 0);
  // A plateau between both levels is on the isosurface of neither level.
  const auto plateau = SampleImage([](const Vector3&) { return 40.0; }, 25.0);
  ball.Structures = ball.Held = Bake(MakeFilter(plateau, 1000.0));
  EXPECT_EQ(PressFromAllSides(ball, 60).AstrayOfHeld, found.Astray);
}

TEST(Presses, WhatDragsBeyondTheBorderHasNoFeltPlace)
{
  // The box is full of a medium with drag that continues beyond the box, far from the ball.
  vtkSmartPointer<vtkImageData> image;
  PressedVolume ball = MakeBall(1000.0, image);
  ball.Model = Bake(MakeFilter(image, 1000.0, 0.3));
  const Presses found = PressFromAllSides(ball, 60);
  EXPECT_GT(found.Count, 30);
  EXPECT_EQ(found.Unfelt, 0);
  EXPECT_EQ(found.Astray, 0);
  EXPECT_TRUE(found.OffSurface.empty());
}

TEST(Presses, AGrazeIsNotBehindAnEdge)
{
  // A ball of 10 N/m is unfelt, although presses of 5 mm go behind its edge.
  vtkSmartPointer<vtkImageData> image;
  PressedVolume ball = MakeBall(10.0, image);
  const Presses soft = PressFromAllSides(ball, 60);
  EXPECT_EQ(soft.UnfeltBehindEdge, soft.Count);
  // An edge that is blurred by 4 mm has 2 % of its height 8.2 mm before its middle. Presses that
  // begin there stay in front of the edge's middle.
  PressedVolume wide = MakeBall(10.0, image);
  const auto foot = SampleImage(
    [](const Vector3& x) { return BlurredStep(BallRadius - Norm(x), 4.0, 100.0); }, 25.0);
  wide.Model = wide.Shape = wide.Structures = wide.Held = Bake(MakeFilter(foot, 10.0, 0.0, 0.0));
  wide.Level = wide.HeldLevel = 2.0;
  const Presses found = PressFromAllSides(wide, 60);
  EXPECT_GT(found.Count, 20);
  EXPECT_EQ(found.Unfelt, found.Count);
  EXPECT_EQ(found.UnfeltBehindEdge, 0);
}

TEST(Presses, AStepIsTheHandsOwnOrARelease)
{
  // A shell yields at 2 N. At 0.45 m/s, a spring of 1000 N/m changes by up to 0.45 N per tick. Any
  // larger change is a release, which is gradual.
  vtkSmartPointer<vtkImageData> image;
  PressedVolume ball = MakeBall(1000.0, image);
  const auto filter = MakeFilter(image, 1000.0, 0.0, 2.0);
  ball.Model = Bake(filter);
  const Steps spread = WalkAtRandom(ball, 10, 0.0);
  EXPECT_GT(spread.Largest, 0.2);
  EXPECT_LE(spread.BeyondSpring, 0.25);
  filter->SetReleaseTime(0.0);
  ball.Model = Bake(filter);
  EXPECT_GT(WalkAtRandom(ball, 10, 0.0).BeyondSpring, 1.0);
}

TEST(Presses, WalksAreSlowWhereASpringIsStiff)
{
  // 0.45 mm per tick at 1000 N/m change the force by 0.45 N, and 0.18 mm by 0.18 N, both without a
  // jump.
  vtkSmartPointer<vtkImageData> image;
  const PressedVolume ball = MakeBall(1000.0, image);
  const Steps fast = WalkAtRandom(ball, 3, 0.0);
  EXPECT_GT(fast.Largest, 0.25);
  EXPECT_EQ(fast.Beyond, 0.0);
  const Steps slow = WalkAtRandom(ball, 3, 1000.0);
  EXPECT_GT(slow.Largest, 0.1);
  EXPECT_LT(slow.Largest, 0.25);
}

TEST(Presses, WhatIsSoftIsUnfelt)
{
  vtkSmartPointer<vtkImageData> image;
  const Presses found = PressFromAllSides(MakeBall(10.0, image), 60); // 0.05 N at 5 mm
  EXPECT_GT(found.Count, 30);
  EXPECT_EQ(found.Unfelt, found.Count);
  EXPECT_EQ(found.UnfeltThoughSeen, found.Count);
  EXPECT_TRUE(found.OffSurface.empty());
  EXPECT_TRUE(found.OffSeen.empty());
  EXPECT_EQ(found.OffSeenTouched.size(), static_cast<std::size_t>(found.Count)); // 0.01 N in 1 mm
  EXPECT_NEAR(ComputeMedian(found.OffSeenTouched), 0.0, 0.4);
}

TEST(Presses, WhatIsHiddenIsNotSeenThoughUnfelt)
{
  vtkSmartPointer<vtkImageData> image;
  PressedVolume ball = MakeBall(10.0, image);
  ball.Extinction = [](const Vector3& x) { return Norm(x) < BallRadius - 3.0 ? 50.0 : 0.0; };
  const Presses found = PressFromAllSides(ball, 60);
  EXPECT_EQ(found.Unfelt, found.Count);
  EXPECT_EQ(found.UnfeltThoughSeen, 0);
}

TEST(Presses, ReachTwoVoxelsBehindTheSurfaceOfCoarseVoxels)
{
  // Voxels are 5 mm, and the ball resists only 1.8 voxels behind the surface, which is 9 mm in the
  // hand's space.
  constexpr double scale = 5.0;
  vtkSmartPointer<vtkImageData> image;
  PressedVolume ball = MakeBall(1000.0, image, BallRadius, scale);
  vtkSmartPointer<vtkImageData> other;
  ball.Model = MakeBall(1000.0, other, BallRadius - 1.8, scale).Model;
  const Presses found = PressFromAllSides(ball, 60);
  EXPECT_GT(found.Count, 30);
  EXPECT_EQ(found.Unfelt, 0);
  EXPECT_NEAR(ComputeMedian(found.OffSurface), 1.8, 0.3);
}

TEST(Presses, GlassIsSeenThrough)
{
  // An opaque core of 9 mm is in clear glass. A ray at a distance b from the middle passes through
  // sqrt(12^2 - b^2) - sqrt(9^2 - b^2) of glass: 3 mm for b = 0, and 5.5 mm at 45 degrees to the
  // normal, where b = 12 / sqrt(2). The ray reaches half of its opacity within 0.1 mm of the core.
  // The felt place is off by a fraction of a voxel.
  vtkSmartPointer<vtkImageData> image;
  PressedVolume ball = MakeBall(1000.0, image);
  ball.Extinction = [](const Vector3& x) { return Norm(x) < 9.0 ? 50.0 : 0.0; };
  const Presses found = PressFromAllSides(ball, 60);
  ASSERT_FALSE(found.OffSeen.empty());
  for (const double behind : found.OffSeen)
  {
    EXPECT_GT(behind, 2.6);
    EXPECT_LT(behind, 5.9);
  }
  // A ray meets the core at 45 degrees where b = 9 / sqrt(2), behind 3.81 mm of glass.
  constexpr double edge = 3.81;
  const auto countBelow = [](const std::vector<double>& values, double most)
  { return std::count_if(values.begin(), values.end(), [=](double v) { return v < most; }); };
  EXPECT_GE(countBelow(found.OffSeenStraight, edge + 0.3), countBelow(found.OffSeen, edge - 0.3));
  EXPECT_LT(FindLargest(found.OffSeenStraight, 1.0), edge + 0.3);
  EXPECT_GT(FindLargest(found.OffSeen, 1.0), edge + 0.3);
}

TEST(Presses, HalfOfTheOpacityOfALookAlongAWay)
{
  // An eye at (-20, 0, 0) looks along x into fog of 0.1 per mm that begins at -12. The 42 mm within
  // reach have the opacity 1 - exp(-4.2), and half of that within the first -10 ln(1 - 0.5 (1 -
  // exp(-4.2))) = 6.782 mm, which end at -5.218: 4.782 behind -10.
  PressedVolume fog;
  fog.Voxel = { 0.5, 1.0, 1.0 };
  fog.Scale = 2.0; // mm per unit
  fog.Extinction = [](const Vector3& x) { return x.X > -6.0 ? 0.2 : 0.0; };
  const auto behind = MeasureSeenBehind(fog, { -10.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 });
  ASSERT_TRUE(behind);
  EXPECT_NEAR(*behind, 4.782, 0.1); // voxels of 1 mm along x
  fog.Extinction = [](const Vector3&) { return 0.0; };
  EXPECT_FALSE(MeasureSeenBehind(fog, { -10.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }));
}

TEST(Presses, TheHandComesByAllThatTheEyeSees)
{
  // A skin around the ball, 60 mm in front of it, has a value below the level of the surface. The
  // skin is seen and felt first, although the ball has the rays' own surface.
  constexpr double skin = 17.0;
  constexpr double unit = 12.0; // mm
  const vtkSmartPointer<vtkImageData> image = SampleImage(
    [](const Vector3& x)
    {
      const double off = Norm(x) - skin;
      return BlurredStep(BallRadius - Norm(x), 1.0, 100.0) + 45.0 * std::exp(-2.0 * off * off);
    },
    20.0);
  vtkNew<vtkVolumeHapticsFilter> filter;
  filter->SetInputDataObject(0, image);
  filter->SetMetersPerWorldUnit(0.001 * unit);
  vtkHapticProperty* const feel = filter->GetProperty();
  SetConstant(feel->GetStiffness(), 1000.0);
  SetConstant(feel->GetViscosity(), 0.0);
  SetConstant(feel->GetSurfaceStrength(), Impenetrable);
  SetConstant(feel->GetDistinctness(), 1.0);
  PressedVolume ball;
  ball.Model = ball.Shape = ball.Structures = ball.Held =
    filter->GetBaker().Bake(1000.0, {}, nullptr);
  ball.Level = ball.HeldLevel = 50.0;
  ball.Scale = unit;
  ball.Box = { -BallRadius, BallRadius, -BallRadius, BallRadius, -BallRadius, BallRadius };
  ball.Voxel = { 1.0, 1.0, 1.0 };
  ball.Extinction = [](const Vector3& x)
  { return Norm(x) < BallRadius || std::abs(Norm(x) - skin) < 0.5 ? 50.0 : 0.0; };
  const Presses found = PressFromAllSides(ball, 30);
  ASSERT_GT(found.Count, 10);
  EXPECT_EQ(found.Unfelt, 0);
  EXPECT_LT(FindLargest(found.OffSeen, 0.95), 1.0);
}

TEST(Presses, FractionsOfMagnitudes)
{
  EXPECT_EQ(FindLargest({ -3.0, 1.0, 2.0 }, 1.0), 3.0);
  EXPECT_EQ(FindLargest({ -3.0, 1.0, 2.0 }, 0.5), 2.0);
  EXPECT_EQ(ComputeMedian({ -3.0, 1.0, 2.0 }), 1.0);
  EXPECT_EQ(ComputeMedian({}), 0.0);
}
