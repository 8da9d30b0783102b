// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that the wall in front of forbidden labels is where geometry requires it, by the closed
 * forms for balls, cylinders and planes.
 */

#include "Core/Model/ForbiddenZone.h"
#include "Rigs/CoreScene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <new>

using namespace coretest;

namespace
{
LabelTable Forbid(std::int64_t label)
{
  LabelledMaterial entry;
  entry.Label = label;
  entry.Material.IsForbidden = true;
  return LabelTable({ entry });
}

TestVolume MakeLabels(std::int64_t side, const std::function<int(const Vector3&)>& label)
{
  TestVolume volume(ScalarType::Int16, { side, side, side });
  volume.Fill<std::int16_t>(
    [&](std::int64_t i, std::int64_t j, std::int64_t k) {
      return label({ double(i), double(j), double(k) });
    });
  return volume;
}

/// Returns one of `count` directions that are spread evenly over the sphere.
Vector3 Direction(int i, int count)
{
  const double z = 1.0 - (2.0 * i + 1.0) / count;
  const double angle = 2.399963229728653 * i; // the golden angle
  const double r = std::sqrt(1.0 - z * z);
  return { r * std::cos(angle), r * std::sin(angle), z };
}
} // namespace

TEST(ForbiddenZone, StandsOffFromABall)
{
  // L5: a stand-off of 2 mm keeps the hand at R + 2 mm +- 0.1 voxel from the centre of a ball of
  // radius R. Voxels are 1 mm.
  for (const double ball : { 8.0, 14.0 })
  {
    const Vector3 centre{ 24.13, 23.69, 24.42 };
    const TestVolume labels =
      MakeLabels(49, [&](const Vector3& x) { return Norm(x - centre) < ball ? 7 : 0; });
    const TestVolume volume(ScalarType::Int16, { 49, 49, 49 });
    auto baked = std::make_shared<BakedLabels>();
    baked->View = LabelView(labels.View);
    baked->Table = Forbid(7);
    baked->Zone = ForbiddenZone::Make(baked->View, baked->Table, baked->IndexToWorld, 2.0);
    ASSERT_NE(baked->Zone, nullptr);
    for (const HapticSolver solver : { HapticSolver::Paper, HapticSolver::Precise })
    {
      HapticModelDescription description = Describe(volume);
      description.Labels = baked;
      description.Settings.Solver = solver;
      const HapticModel model(description);
      double sum = 0.0;
      double square = 0.0;
      double worst = 0.0;
      constexpr int count = 200;
      for (int i = 0; i < count; ++i)
      {
        const Vector3 direction = Direction(i, count);
        ServoState state;
        TickRecord record;
        for (double r = ball + 6.0; r > ball - 1.0; r -= 0.01)
        {
          Tick(model, state, 1e-3 * (centre + r * direction), record);
          if (r > ball + 2.5)
          {
            ASSERT_EQ(Norm(record.Force), 0.0) << "not before the stand-off";
          }
        }
        const double at = Norm(1000.0 * record.Proxy - centre) - ball;
        sum += at / count;
        square += (at - 2.0) * (at - 2.0) / count;
        worst = std::max(worst, std::abs(at - 2.0));
        EXPECT_NEAR(Dot(record.Force, direction),
          500.0 * (1000.0 * Norm(record.Proxy - record.Tip)) * 1e-3, 0.05);
      }
      SCOPED_TRACE(
        testing::Message() << "ball of " << ball << ": mean " << sum << ", worst " << worst);
      EXPECT_NEAR(sum, 2.0, 0.07);
      EXPECT_LT(std::sqrt(square), 0.1);
      EXPECT_LT(worst, 0.25) << "where the ball's voxels end in a step";
    }
  }
}

TEST(ForbiddenZone, KnowsAnisotropicVoxels)
{
  // The forbidden half-space begins at voxel 5.5 along z, which is z = 11 world units with a
  // spacing of 2.
  const TestVolume labels = MakeLabels(24, [](const Vector3& x) { return x.Z >= 6.0 ? 3 : 0; });
  const LabelView view(labels.View);
  Affine3 map;
  map.Linear = { { { 0.5, 0, 0 }, { 0, 1, 0 }, { 0, 0, 2 } } };
  const auto zone = ForbiddenZone::Make(view, Forbid(3), map, 3.0);
  ASSERT_NE(zone, nullptr);
  for (const double z : { 7.0, 8.5, 9.9 })
  {
    const ForbiddenPlace place = zone->Compute({ 12.2, 11.4, z / 2.0 });
    ASSERT_TRUE(place.IsNear);
    EXPECT_NEAR(place.Distance, 11.0 - z, 0.02);
    EXPECT_NEAR(place.Gradient.Z, -2.0, 0.05);
  }
}

TEST(ForbiddenZone, StandsOffFromASlab)
{
  // A forbidden layer of four voxels, from z = 11.5 to 15.5. Its two faces are close together.
  const TestVolume labels =
    MakeLabels(28, [](const Vector3& x) { return x.Z > 11.5 && x.Z < 15.5 ? 1 : 0; });
  const LabelView view(labels.View);
  const auto zone = ForbiddenZone::Make(view, Forbid(1), Affine3{}, 2.0);
  ASSERT_NE(zone, nullptr);
  EXPECT_NEAR(zone->Compute({ 13.2, 14.1, 9.5 }).Distance, 2.0, 0.05);
  EXPECT_NEAR(zone->Compute({ 13.2, 14.1, 17.5 }).Distance, 2.0, 0.05);
  EXPECT_LT(zone->Compute({ 13.2, 14.1, 13.5 }).Distance, -1.0);
}

TEST(ForbiddenZone, StandsOffFromAVessel)
{
  // Cylinders along x with radii of 2.5 and 1.5 voxels. Smoothing alone would make them thinner.
  for (const double radius : { 2.5, 1.5 })
  {
    const TestVolume labels = MakeLabels(
      32, [&](const Vector3& x) { return std::hypot(x.Y - 16.2, x.Z - 15.9) < radius ? 1 : 0; });
    const LabelView view(labels.View);
    const auto zone = ForbiddenZone::Make(view, Forbid(1), Affine3{}, 2.0);
    ASSERT_NE(zone, nullptr);
    for (int i = 0; i < 60; ++i)
    {
      const double angle = 0.1047 * i;
      const double r = radius + 2.0;
      const ForbiddenPlace place =
        zone->Compute({ 12.0 + 0.1 * i, 16.2 + r * std::cos(angle), 15.9 + r * std::sin(angle) });
      ASSERT_TRUE(place.IsNear);
      EXPECT_NEAR(place.Distance, 2.0, 0.45) << radius << ", " << angle;
    }
  }
}

TEST(ForbiddenZone, KeepsThinVesselsAndSpecks)
{
  // A line along x that is one voxel thick, and a single voxel. The zone must cover at least half a
  // voxel around each of them.
  const TestVolume labels = MakeLabels(40,
    [](const Vector3& x) {
      return (x.Y == 10.0 && x.Z == 10.0) || (x.X == 30.0 && x.Y == 30.0 && x.Z == 30.0) ? 1 : 0;
    });
  const LabelView view(labels.View);
  const auto zone = ForbiddenZone::Make(view, Forbid(1), Affine3{}, 2.0);
  ASSERT_NE(zone, nullptr);
  EXPECT_NEAR(zone->Compute({ 20.0, 13.0, 10.0 }).Distance, 2.5, 0.2);
  EXPECT_NEAR(zone->Compute({ 20.4, 10.0, 7.0 }).Distance, 2.5, 0.2);
  EXPECT_NEAR(zone->Compute({ 30.0, 30.0, 33.0 }).Distance, 2.5, 0.2);
  EXPECT_NEAR(zone->Compute({ 32.0, 32.0, 30.0 }).Distance, std::sqrt(8.0) - 0.5, 0.2);
}

TEST(ForbiddenZone, IsNotThereWithoutForbiddenLabels)
{
  const TestVolume labels = MakeLabels(12, [](const Vector3& x) { return x.Z > 5.0 ? 1 : 0; });
  const LabelView view(labels.View);
  EXPECT_EQ(ForbiddenZone::Make(view, LabelTable(), Affine3{}, 2.0), nullptr);
  EXPECT_EQ(ForbiddenZone::Make(view, Forbid(2), Affine3{}, 2.0), nullptr);
  EXPECT_THROW(ForbiddenZone::Make(view, Forbid(1), Affine3{}, 1e9), std::bad_alloc);
  const auto zone = ForbiddenZone::Make(view, Forbid(1), Affine3{}, 1.0);
  ASSERT_NE(zone, nullptr);
  EXPECT_FALSE(zone->Compute({ 6.0, 6.0, -1000.0 }).IsNear);
  EXPECT_FALSE(zone->Compute({ std::nan(""), 6.0, 6.0 }).IsNear);
}

TEST(ForbiddenZone, EndsWhenItIsTold)
{
  const TestVolume labels = MakeLabels(30,
    [](const Vector3& x) {
      return Norm(x - Vector3{ 14, 14, 14 }) < 6.0 ? 7 : 0;
    });
  const auto make = [&](int most)
  {
    int asked = 0;
    const auto zone = ForbiddenZone::Make(
      LabelView(labels.View), Forbid(7), Affine3{}, 2.0, [&] { return ++asked <= most; });
    EXPECT_TRUE(zone || asked == most + 1) << "it is not asked again";
    return std::make_pair(zone != nullptr, asked);
  };
  const auto [isMade, asked] = make(1000000);
  EXPECT_TRUE(isMade);
  EXPECT_GT(asked, 4 * 30) << "for every slice of every pass";
  for (const int most : { 0, 1, 29, 30, 59, 60, asked / 2, asked - 1 })
  {
    EXPECT_FALSE(make(most).first) << most;
  }
  EXPECT_TRUE(make(asked).first);
}
