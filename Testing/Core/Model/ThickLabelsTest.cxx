// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests walls between labels in images with thick slices. Their positions and normals must be those
 * of the labelled shapes (a ball, a plane, a shell), for which there are closed forms.
 */

#include "Core/Field/FineLabels.h"
#include "Core/Model/BakedLabels.h"
#include "Core/Model/LabelWalls.h"
#include "Rigs/CoreScene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <memory>

using namespace coretest;

namespace
{
constexpr double Degree = 57.29577951308232;

/// Returns one of `count` directions that are spread evenly over the sphere.
Vector3 Spread(int i, int count)
{
  const double z = 1.0 - (2.0 * i + 1.0) / count;
  const double angle = 2.399963229728653 * i; // the golden angle
  const double r = std::sqrt(1.0 - z * z);
  return { r * std::cos(angle), r * std::sin(angle), z };
}

Vector3 Thick(double fine, double coarse, int axis)
{
  return { axis == 0 ? coarse : fine, axis == 1 ? coarse : fine, axis == 2 ? coarse : fine };
}

/// An image of a shape in slices (mm), its fine labels, and the walls of both.
class Slices
{
public:
  /// @param size size of the image (mm)
  Slices(const Vector3& spacing, const Vector3& size,
    const std::function<int(const Vector3&)>& label, bool isFine = true,
    ScalarType type = ScalarType::UInt8)
    : Spacing(spacing)
    , Volume(type, { Count(size.X, spacing.X), Count(size.Y, spacing.Y), Count(size.Z, spacing.Z) })
  {
    WithSampleType(type,
      [&](auto t)
      {
        this->Volume.Fill<decltype(t)>(
          [&](std::int64_t i, std::int64_t j, std::int64_t k) {
            return label({ i * spacing.X, j * spacing.Y, k * spacing.Z });
          });
      });
    this->Labels.View = LabelView(this->Volume.View);
    this->Labels.IndexToWorld.Linear = { { { spacing.X, 0, 0 }, { 0, spacing.Y, 0 },
      { 0, 0, spacing.Z } } };
    if (isFine)
    {
      this->Labels.Refine(FineLabels::Make(this->Labels.View, spacing));
    }
    this->Walls = std::make_unique<LabelWalls>(this->Labels.View, this->Labels.Table, 3,
      this->Labels.Fine ? this->Labels.Fine->GetFractions() : nullptr);
    this->WorldToIndex = Inverse(this->Labels.IndexToWorld);
    this->GradientToWorld = Transpose(this->WorldToIndex.Linear);
  }

  LabelWall At(const Vector3& world) const
  {
    LabelWall wall = this->Walls->Compute(this->WorldToIndex(world));
    wall.Gradient = this->GradientToWorld * wall.Gradient;
    return wall;
  }

  /// Searches along a direction. Returns the distance (mm) at which the value falls to 0.
  double FindWall(
    const Vector3& from, const Vector3& direction, double inside, double outside) const
  {
    for (int i = 0; i < 40; ++i)
    {
      const double middle = 0.5 * (inside + outside);
      (this->At(from + middle * direction).Value > 0.0 ? inside : outside) = middle;
    }
    return inside;
  }

  const Vector3 Spacing;
  TestVolume Volume;
  BakedLabels Labels;
  std::unique_ptr<LabelWalls> Walls;

private:
  static std::int64_t Count(double size, double spacing)
  {
    return static_cast<std::int64_t>(std::ceil(size / spacing)) + 1;
  }

  Affine3 WorldToIndex;
  Matrix3 GradientToWorld;
};

struct Errors
{
  double Mean = 0.0;  ///< mean error of the normal (degrees)
  double Worst = 0.0; ///< largest error of the normal (degrees)
  double Shift = 0.0; ///< mean error of the position (mm)
  double Rms = 0.0;   ///< RMS error of the position (mm)
};

Errors MeasureBall(double fine, double coarse, int axis, double ball)
{
  const double margin = 2.0 * coarse + 8.0 * fine;
  const double side = 2.0 * (ball + margin);
  const Vector3 centre = Vector3{ 0.5 * side, 0.5 * side, 0.5 * side } +
    Vector3{ 0.13 * fine, -0.31 * fine, 0.42 * fine };
  const Slices slices(Thick(fine, coarse, axis), { side, side, side },
    [&](const Vector3& x) { return Norm(x - centre) < ball ? 1 : 0; });
  constexpr int count = 1000;
  Errors errors;
  for (int i = 0; i < count; ++i)
  {
    const Vector3 direction = Spread(i, count);
    const double at = slices.FindWall(centre, direction, ball - 5.0 * fine, ball + 4.0 * fine);
    const Vector3 gradient = slices.At(centre + at * direction).Gradient;
    const double angle =
      Degree * std::acos(std::min(1.0, -Dot(gradient, direction) / Norm(gradient)));
    errors.Mean += angle / count;
    errors.Worst = std::max(errors.Worst, angle);
    errors.Shift += (at - ball) / count;
    errors.Rms += (at - ball) * (at - ball) / count;
  }
  errors.Rms = std::sqrt(errors.Rms);
  return errors;
}
} // namespace

TEST(ThickLabels, WallsOfABallPointOutwards)
{
  int axis = 0;
  for (const double ratio : { 1.6, 2.4, 5.0, 7.5, 10.0 })
  {
    const Errors errors = MeasureBall(0.4, 0.4 * ratio, axis, 16.0);
    SCOPED_TRACE(testing::Message() << "1:" << ratio << " along axis " << axis << ": mean "
                                    << errors.Mean << ", worst " << errors.Worst << " degrees");
    // For cubic voxels of 0.4 mm, the mean error is 1.35 degrees, and the largest error is 10.5
    // degrees.
    EXPECT_LT(errors.Mean, 2.0);
    EXPECT_LT(errors.Worst, 15.0);
    EXPECT_LT(errors.Rms, 0.25 * 0.4);
    // Smoothing over the voxels moves a ball's wall inward by s^2/R (s is the kernel's deviation, R
    // the radius). The smoothing between slices moves the wall by about the same distance again.
    const double s = 0.355 * 4.0 * 0.4;
    EXPECT_NEAR(errors.Shift, -2.0 * s * s / 16.0, 0.1 * 0.4);
    axis = (axis + 1) % 3;
  }
}

TEST(ThickLabels, WallsOfAPlaneStandWhereItIs)
{
  for (const double tilt : { 0.0, 20.0, 45.0, 70.0, 80.0, 83.0, 85.0 })
  {
    const double aside = std::cos(tilt / Degree);
    const Vector3 normal{ aside * 0.8, aside * 0.6, std::sin(tilt / Degree) };
    const Vector3 middle{ 30.03, 30.11, 30.17 };
    const Slices slices({ 0.4, 0.4, 3.0 }, { 60, 60, 60 },
      [&](const Vector3& x) { return Dot(x - middle, normal) < 0.0 ? 1 : 0; });
    const Vector3 u = UnitAcross(normal);
    const Vector3 v = Cross(normal, u);
    double mean = 0.0;
    constexpr int count = 300;
    for (int i = 0; i < count; ++i)
    {
      const double r = 6.0 * i / count;
      const Vector3 foot = middle + r * std::cos(2.4 * i) * u + r * std::sin(2.4 * i) * v;
      const double at = slices.FindWall(foot, normal, -2.0, 2.0);
      const Vector3 gradient = slices.At(foot + at * normal).Gradient;
      mean += Degree * std::acos(std::min(1.0, -Dot(gradient, normal) / Norm(gradient))) / count;
      ASSERT_NEAR(at, 0.0, 0.25 * 0.4) << "tilt " << tilt;
    }
    EXPECT_LT(mean, 1.0) << "tilt " << tilt;
  }
}

TEST(ThickLabels, AShellThatSlicesShowHasNoHole)
{
  // `Highest` is the largest z of a direction (unit vector) in which the shell's outlines in
  // neighbouring slices of 3 mm still overlap.
  struct Row
  {
    double Thickness;
    double Highest;
  };
  const Vector3 centre{ 27.1, 27.2, 27.3 };
  for (const Row& row : { Row{ 1.2, 0.35 }, Row{ 2.0, 0.55 }, Row{ 3.0, 0.75 } })
  {
    const Slices slices({ 0.4, 0.4, 3.0 }, { 54, 54, 54 },
      [&](const Vector3& x)
      {
        const double r = Norm(x - centre);
        return r < 22.0 && r > 22.0 - row.Thickness ? 1 : 0;
      });
    double mean = 0.0;
    int count = 0;
    for (int i = 0; i < 1000; ++i)
    {
      const Vector3 direction = Spread(i, 1000);
      if (std::abs(direction.Z) > row.Highest)
      {
        continue;
      }
      const double inside = 22.0 - 0.5 * row.Thickness;
      ASSERT_GT(slices.At(centre + inside * direction).Value, 0.0)
        << row.Thickness << " mm, height " << direction.Z;
      const double at = slices.FindWall(centre, direction, inside, 24.0);
      EXPECT_NEAR(at, 22.0, 0.9 * 0.4);
      const Vector3 gradient = slices.At(centre + at * direction).Gradient;
      mean += Degree * std::acos(std::min(1.0, -Dot(gradient, direction) / Norm(gradient)));
      ++count;
    }
    EXPECT_LT(mean / count, 3.0) << row.Thickness << " mm";
  }
}

TEST(ThickLabels, SheetsAcrossTheSlicesStayAsTheyAre)
{
  for (const int voxels : { 1, 2, 3, 6 })
  {
    const auto label = [&](const Vector3& x)
    {
      const double i = std::round(x.X / 0.5);
      return i >= 20 && i < 20 + voxels ? 3 : 1;
    };
    const Slices fine({ 0.5, 0.5, 4.0 }, { 24, 12, 40 }, label);
    const Slices image({ 0.5, 0.5, 4.0 }, { 24, 12, 40 }, label, false);
    ASSERT_TRUE(fine.Labels.Fine);
    for (int i = 0; i < 200; ++i)
    {
      const Vector3 at{ 8.0 + 0.03 * i, 6.1, 15.0 + 0.07 * i };
      const LabelWall expected = image.At(at);
      const LabelWall found = fine.At(at);
      ASSERT_EQ(found.IsThere, expected.IsThere);
      // For slices of about four voxels or more, boundaries are smoothed, and fractions are stored
      // in steps of 1/254.
      ASSERT_NEAR(found.Value, expected.Value, voxels < 4 ? 1e-6 : 1.0 / 254.0)
        << voxels << " voxels at " << at.X;
    }
  }
}

TEST(ThickLabels, ASliceOfOneVoxelEndsHalfway)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto along = [axis](const Vector3& x) { return axis == 0 ? x.X : axis == 1 ? x.Y : x.Z; };
    const Vector3 spacing = Thick(0.5, 4.0, axis);
    const Slices fine(
      spacing, { 40, 40, 40 }, [&](const Vector3& x) { return along(x) == 20.0 ? 7 : 2; });
    const Vector3 normal{ axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0 };
    const Vector3 middle{ 20, 20, 20 };
    EXPECT_GT(fine.At(middle).Value, 0.9);
    EXPECT_NEAR(fine.FindWall(middle, normal, 0.0, 4.0), 2.0, 0.25);
    EXPECT_NEAR(fine.FindWall(middle, -normal, 0.0, 4.0), 2.0, 0.25);
  }
}

TEST(ThickLabels, ImagesWithoutThickSlicesStayAsTheyAre)
{
  for (const Vector3& spacing : { Vector3{ 1, 1, 1 }, Vector3{ 0.5, 0.7, 0.75 } })
  {
    const Slices slices(spacing, { 10, 10, 10 }, [](const Vector3& x) { return x.X < 5 ? 1 : 0; });
    EXPECT_FALSE(slices.Labels.Fine);
    EXPECT_EQ(slices.Labels.View.GetView().Data, slices.Volume.View.Data);
  }
  const Slices one({ 1, 1, 5 }, { 10, 10, 0 }, [](const Vector3&) { return 1; });
  EXPECT_FALSE(one.Labels.Fine) << "a single slice";
}

TEST(ThickLabels, AnyImageOfTheSameLabelsHasTheSameFineOnes)
{
  const auto label = [](const Vector3& x) { return Norm(x - Vector3{ 9, 8, 12 }) < 6.3 ? -3 : 5; };
  const Vector3 spacing{ 0.6, 0.6, 2.4 };
  const Vector3 size{ 18, 16, 24 };
  const Slices first(spacing, size, label, true, ScalarType::Int16);
  const VolumeView& expected = first.Labels.View.GetView();
  const std::int64_t voxels =
    expected.Dimensions[0] * expected.Dimensions[1] * expected.Dimensions[2];
  EXPECT_EQ(expected.Dimensions[2], 4 * 10 + 1);
  EXPECT_EQ(expected.Type, ScalarType::Int16) << "the narrowest that holds them";
  for (const ScalarType type : { ScalarType::Int64, ScalarType::Float32, ScalarType::Int8 })
  {
    const Slices other(spacing, size, label, true, type);
    const VolumeView& found = other.Labels.View.GetView();
    ASSERT_EQ(found.Type, expected.Type);
    EXPECT_EQ(std::memcmp(found.Data, expected.Data, 2 * static_cast<std::size_t>(voxels)), 0);
    EXPECT_EQ(std::memcmp(other.Labels.Fine->GetFractions(), first.Labels.Fine->GetFractions(),
                static_cast<std::size_t>(voxels)),
      0);
  }
}

TEST(ThickLabels, OnlyChangedSlicesAreFoundAgain)
{
  Slices slices({ 0.5, 0.5, 2.0 }, { 16, 16, 60 },
    [](const Vector3& x) {
      return Norm(x - Vector3{ 8, 8, 30 }) < 7.0 ? 2 : 0;
    });
  const std::shared_ptr<const FineLabels> last = slices.Labels.Fine;
  EXPECT_EQ(last->GetSlicesFound(), 31);
  const LabelView view(slices.Volume.View);
  const auto same = FineLabels::Make(view, slices.Spacing, nullptr, last.get());
  EXPECT_EQ(same->GetSlicesFound(), 0);
  // Paint a stroke of label 9 in one slice.
  auto* const data = static_cast<std::uint8_t*>(const_cast<void*>(slices.Volume.View.Data));
  for (int i = 10; i < 20; ++i)
  {
    data[i * slices.Volume.View.Stride[0] + 12 * slices.Volume.View.Stride[1] +
      14 * slices.Volume.View.Stride[2]] = 9;
  }
  const auto again = FineLabels::Make(view, slices.Spacing, nullptr, last.get());
  const auto fresh = FineLabels::Make(view, slices.Spacing);
  EXPECT_EQ(again->GetSlicesFound(), 4) << "whose labels depend on the slice";
  const VolumeView& found = again->GetView().GetView();
  const auto voxels =
    static_cast<std::size_t>(found.Dimensions[0] * found.Dimensions[1] * found.Dimensions[2]);
  EXPECT_EQ(std::memcmp(found.Data, fresh->GetView().GetView().Data, voxels), 0);
  EXPECT_EQ(std::memcmp(again->GetFractions(), fresh->GetFractions(), voxels), 0);
}

TEST(ThickLabels, MemoryIsBounded)
{
  const Slices slices(
    { 0.5, 0.5, 4.0 }, { 16, 16, 60 }, [](const Vector3& x) { return x.X < 8.0 ? 2 : 0; });
  const std::int64_t* const n = slices.Volume.View.Dimensions;
  const std::int64_t voxels = n[0] * n[1] * n[2];
  const LabelView view(slices.Volume.View);
  EXPECT_EQ(FineLabels::Make(view, slices.Spacing)->GetSteps().Z, 8.0);
  const auto fewer = FineLabels::Make(view, slices.Spacing, nullptr, nullptr, 3 * voxels);
  EXPECT_EQ(fewer->GetSteps().Z, 3.0);
  EXPECT_LE(fewer->GetMemorySize(), 7 * static_cast<std::size_t>(voxels));
  EXPECT_FALSE(FineLabels::Make(view, slices.Spacing, nullptr, nullptr, voxels));
}

TEST(ThickLabels, AHandGlidesOverABall)
{
  const Vector3 centre{ 27.1, 27.2, 27.3 };
  constexpr double ball = 22.0;
  const Slices slices({ 0.4, 0.4, 3.0 }, { 54, 54, 54 },
    [&](const Vector3& x) { return Norm(x - centre) < ball ? 1 : 0; });
  LabelledMaterial entry;
  entry.Label = 1;
  entry.Material.Value = { 500.0, 0.0, 8.0, 0.0 };
  entry.Material.IsSet = { true, true, true, true };
  auto labels = std::make_shared<BakedLabels>(slices.Labels);
  labels->Table = LabelTable({ entry });
  HapticModelDescription description = Describe(slices.Volume);
  description.IndexToWorld.Linear = { { { 0.4, 0, 0 }, { 0, 0.4, 0 }, { 0, 0, 3.0 } } };
  description.Labels = labels;
  description.Settings.Geometry = SurfaceGeometry::Labels;
  const HapticModel model(description);
  ServoState state;
  TickRecord record;
  Vector3 last;
  double leaning = 0.0;
  constexpr int first = 100;
  constexpr int ticks = 1200;
  for (int i = 0; i <= ticks; ++i)
  {
    const double angle = 0.0025 * std::max(0, i - 80) - 1.4; // along a meridian
    const Vector3 out{ 0.6 * std::cos(angle), 0.8 * std::cos(angle), std::sin(angle) };
    const double depth = std::min(2.0, -2.0 + 0.05 * i);
    Tick(model, state, 0.001 * (centre + (ball - depth) * out), record);
    if (i > first)
    {
      // The force is the stiffness k times the depth of 2 mm, and changes without steps.
      ASSERT_NEAR(Norm(record.Force), 1.0, 0.15) << i;
      ASSERT_LT(Norm(record.Force - last), 0.04) << i;
      leaning += Degree * std::acos(std::min(1.0, Dot(record.Force, out) / Norm(record.Force)));
    }
    last = record.Force;
  }
  EXPECT_LT(leaning / (ticks - first), 2.0) << "degrees, mean";
}
