// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that the residency takes all samples into account that a tick reads: kernels, x_s and
 * x_v, and the walk to the far side of an edge.
 *
 * The test compares random strokes in random boxes with the same strokes in the whole volume, so it
 * detects any read outside the box. The length of a walk is three kernel radii, in voxels along the
 * normal (FarSide.h). Documentation/method.md describes how the residency falls.
 */

#include "Core/Regions/Residency.h"
#include "Core/Tools/PointShell/BakedShell.h"
#include "RegionRig.h"

#include <cmath>
#include <random>

using namespace servotest;

namespace
{
/// Returns a ball with an edge so wide that the solver's walks through it reach their full length.
const TestVolume& WideBall()
{
  static const TestVolume ball = MakeBall(3.0);
  return ball;
}

HapticModelDescription DescribeWideBall(HapticSolver solver, MaterialPlacement placement)
{
  HapticModelDescription d = DescribeBall(HapticMethod::Proxy, solver, placement);
  d.View = WideBall().View;
  return d;
}

/// Random numbers that are the same in every run.
class Dice
{
public:
  explicit Dice(std::uint64_t seed)
    : Engine(seed)
  {
  }

  double Draw(double low, double high)
  {
    return low + (high - low) * static_cast<double>(this->Engine() >> 11) * 0x1p-53;
  }
  Vector3 DrawDirection()
  {
    for (;;)
    {
      const Vector3 v{ this->Draw(-1.0, 1.0), this->Draw(-1.0, 1.0), this->Draw(-1.0, 1.0) };
      if (Norm(v) > 0.1 && Norm(v) < 1.0)
      {
        return (1.0 / Norm(v)) * v;
      }
    }
  }
  /// Returns the tips (m) of a stroke into the ball along a radius, then aside and deeper.
  std::vector<Vector3> DrawStroke()
  {
    const Vector3 out = this->DrawDirection();
    const Vector3 aside = Cross(out, this->DrawDirection());
    const double depth = this->Draw(0.3, 4.0);
    std::vector<Vector3> tips;
    for (int i = 0; i < 60; ++i)
    {
      const double in = std::min(1.0, 0.05 * i);
      const double along = 0.1 * std::max(0, i - 20);
      tips.push_back(1e-3 * ((26.0 - (2.0 + depth) * in - 0.1 * along) * out + along * aside));
    }
    return tips;
  }

private:
  std::mt19937_64 Engine;
};

/// A box of samples in the ball's volume: the part that is loaded.
struct Box
{
  /// Draws the box around a position, with up to `most` voxels on each side.
  Box(const Vector3& index, double most, Dice& dice)
  {
    const double at[3] = { index.X, index.Y, index.Z };
    for (int a = 0; a < 3; ++a)
    {
      const auto side = [&](double voxels)
      { return std::clamp<std::int64_t>(std::llround(at[a] + voxels), 0, Samples - 1); };
      this->First[a] = side(-dice.Draw(6.0, most));
      this->Last[a] = side(dice.Draw(6.0, most));
    }
  }

  /// Returns whether a position is outside the box, but still inside the volume.
  bool IsLeftAt(const Vector3& index) const
  {
    const double at[3] = { index.X, index.Y, index.Z };
    bool isLeft = false;
    for (int a = 0; a < 3; ++a)
    {
      isLeft = isLeft || (this->First[a] > 0 && at[a] < double(this->First[a])) ||
        (this->Last[a] < Samples - 1 && at[a] > double(this->Last[a]));
    }
    return isLeft;
  }

  Index First;
  Index Last;
};

/// Numbers of ticks with force, by their residency.
struct Counts
{
  int Whole = 0; ///< residency 1
  int Part = 0;  ///< residency between 0 and 1
};

/// Strokes in the box and in the whole volume. Expects that ticks are equal, to the bit, wherever
/// the residency is not 0.
void CompareStroke(
  const HapticModelDescription& d, const Box& box, const std::vector<Vector3>& tips, Counts& counts)
{
  const HapticModel whole(d);
  const HapticModel region(Crop(d, box.First, box.Last, WideBall()));
  ServoState state;
  ServoState regionState;
  TickRecord record;
  TickRecord felt;
  const auto tool = ToolMemory::Provide(*whole.Baked, nullptr);
  const auto regionTool = ToolMemory::Provide(*region.Baked, nullptr);
  const auto result = LocalSurfaceResult::Simulated();
  for (const Vector3& tip : tips)
  {
    const double residency = ComputeResidency(region, regionState, tip);
    if (residency == 0.0)
    {
      return;
    }
    Tick(whole, state, tip, record, result, nullptr, tool.get());
    Tick(region, regionState, tip, felt, result, nullptr, regionTool.get());
    ASSERT_TRUE(IsSame(felt.Force, record.Force)) << Norm(felt.Force - record.Force);
    ASSERT_TRUE(IsSame(felt.Proxy, record.Proxy));
    ASSERT_EQ(felt.SurfaceValue, record.SurfaceValue);
    ASSERT_EQ(felt.MediumValue, record.MediumValue);
    const bool isFelt = Norm(record.Force) > 0.01;
    counts.Whole += isFelt && residency == 1.0 ? 1 : 0;
    counts.Part += isFelt && residency < 1.0 ? 1 : 0;
  }
}

/// Selects kernel radius, estimator and alignment by a number.
void ChooseKernel(int number, HapticModelDescription& d)
{
  d.KernelRadius = 1 + number % 3;
  d.Estimator = number % 2 ? GradientEstimator::Gaussian : GradientEstimator::CubicBSpline;
  d.Settings.Alignment = number % 5 ? ContactAlignment::Edge : ContactAlignment::Distinctness;
}

Vector3 ToIndex(const HapticModelDescription& d, const Vector3& tip)
{
  return Inverse(d.IndexToWorld)(d.DeviceToWorld(tip));
}

Counts CompareStrokes(HapticModelDescription d, double most, Dice& dice)
{
  Counts counts;
  for (int i = 0; i < 300 && !testing::Test::HasFatalFailure(); ++i)
  {
    ChooseKernel(i, d);
    const std::vector<Vector3> tips = dice.DrawStroke();
    CompareStroke(d, Box(ToIndex(d, tips[tips.size() / 2]), most, dice), tips, counts);
  }
  return counts;
}

/// Returns labels with a ball of label 1 in voxels of 5 mm, in the same world as the other ball.
std::shared_ptr<const BakedLabels> MakeCoarseLabels()
{
  constexpr std::int64_t side = 20;
  const auto labels =
    std::make_shared<TestVolume>(ScalarType::UInt8, TestVolume::Size{ side, side, side });
  BakedLabels baked;
  baked.IndexToWorld.Linear = 5.0 * Matrix3{};
  baked.IndexToWorld.Offset = { -47.0, -48.0, -47.5 };
  labels->Fill<std::uint8_t>(
    [&](std::int64_t i, std::int64_t j, std::int64_t k) {
      return Norm(baked.IndexToWorld({ double(i), double(j), double(k) })) < 25.0 ? 1 : 0;
    });
  baked.View = LabelView(labels->View);
  baked.Samples = labels;
  return std::make_shared<const BakedLabels>(baked);
}

double Smooth(double t)
{
  const double x = std::clamp(t, 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}
} // namespace

TEST(RegionReach, TheForceIsThatOfTheWholeAsLongAsItsSamplesAreThere)
{
  Dice dice(21);
  const Counts counts =
    CompareStrokes(DescribeWideBall(HapticSolver::Precise, MaterialPlacement::FarSide), 26.0, dice);
  EXPECT_GT(counts.Whole, 1000);
  EXPECT_GT(counts.Part, 300);
}

TEST(RegionReach, MaterialsOfTheKernelNeedNoMoreThanTheKernel)
{
  Dice dice(22);
  for (const HapticSolver solver : { HapticSolver::Paper, HapticSolver::Precise })
  {
    const Counts counts =
      CompareStrokes(DescribeWideBall(solver, MaterialPlacement::Kernel), 20.0, dice);
    EXPECT_GT(counts.Whole, 1000);
    EXPECT_GT(counts.Part, 300);
  }
}

TEST(RegionReach, WallsOfCoarseLabelsReadAsFarAsTheirVoxelsAreLarge)
{
  Dice dice(23);
  HapticModelDescription d = DescribeWideBall(HapticSolver::Precise, MaterialPlacement::Kernel);
  d.Labels = MakeCoarseLabels();
  d.Settings.Geometry = SurfaceGeometry::Labels;
  const Counts counts = CompareStrokes(d, 34.0, dice);
  EXPECT_GT(counts.Whole, 1000);
  EXPECT_GT(counts.Part, 300);
}

TEST(RegionReach, AToolWithAShapeReadsAroundAllOfIt)
{
  Dice dice(24);
  HapticModelDescription d = DescribeWideBall(HapticSolver::Precise, MaterialPlacement::Kernel);
  std::vector<ShellPoint> points;
  for (int i = 0; i < 300; ++i)
  {
    points.push_back({ 2.5 * dice.DrawDirection(), 0.26 });
  }
  ShellDescription tool;
  tool.Points = std::make_shared<const PointShell>(std::move(points));
  tool.Touch.ContactArea = 25.0;
  tool.Touch.Level = HapticModel(d).ValueAtDevice({ 0.022, 0.0, 0.0 });
  d.Tool = std::make_shared<const BakedShell>(tool);
  const Counts counts = CompareStrokes(d, 40.0, dice);
  EXPECT_GT(counts.Whole, 1000);
  EXPECT_GT(counts.Part, 300);
}

TEST(RegionReach, NothingIsFeltWhereAWalkWouldLeaveTheRegion)
{
  Dice dice(25);
  HapticModelDescription d = DescribeWideBall(HapticSolver::Precise, MaterialPlacement::FarSide);
  int leaving = 0;
  int byWalkAlone = 0; // ticks that would have force with kernel materials
  for (int i = 0; i < 300; ++i)
  {
    ChooseKernel(i, d);
    const HapticModel whole(d);
    const std::vector<Vector3> tips = dice.DrawStroke();
    ServoState state;
    TickRecord record;
    for (const Vector3& tip : tips)
    {
      Tick(whole, state, tip, record);
    }
    const Vector3 at = whole.DeviceToIndex(state.Proxy);
    const Vector3 along = whole.DeviceToIndex.Linear * record.Normal;
    const Vector3 walk = (3.0 * d.KernelRadius / Norm(along)) * along;
    for (int n = 0; n < 20; ++n)
    {
      const Box box(at, 16.0, dice);
      if (!box.IsLeftAt(at + walk) && !box.IsLeftAt(at - walk))
      {
        continue;
      }
      HapticModelDescription cropped = Crop(d, box.First, box.Last, WideBall());
      ASSERT_EQ(ComputeResidency(HapticModel(cropped), state, tips.back()), 0.0);
      ++leaving;
      cropped.Settings.Placement = MaterialPlacement::Kernel;
      byWalkAlone += ComputeResidency(HapticModel(cropped), state, tips.back()) > 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(leaving, 300);
  EXPECT_GT(byWalkAlone, 100);
}

TEST(RegionReach, FallsOverFourVoxelsThatEndThreeBeforeTheFarthestSample)
{
  Dice dice(24);
  const double spacing[3] = { 1.0, 0.9, 1.1 };
  int between = 0;
  for (int i = 0; i < 60; ++i)
  {
    const bool isPaper = i % 3 == 0;
    const bool isFar = i % 2 == 0;
    HapticModelDescription d =
      DescribeBall(HapticMethod::Proxy, isPaper ? HapticSolver::Paper : HapticSolver::Precise,
        isFar ? MaterialPlacement::FarSide : MaterialPlacement::Kernel);
    d.KernelRadius = 1 + i % 4;
    const int axis = i % 5 % 3;
    Index last = { Samples - 1, Samples - 1, Samples - 1 };
    last[axis] = 40;
    const HapticModel region(Crop(d, { 0, 0, 0 }, last));
    const double radius = d.KernelRadius;
    const double aside = radius * 1.1 / spacing[axis]; // distance of x_s (voxels)
    const double walk = isFar && !isPaper ? 3.0 * radius : 0.0;
    const double reach = std::max({ radius, aside, walk }) + 3.0;
    for (int n = 0; n < 50; ++n)
    {
      double at[3] = { 30.0, 31.0, 32.0 };
      at[axis] = dice.Draw(15.0, 42.0);
      const Vector3 tip = region.WorldToDevice(region.Baked->IndexToWorld({ at[0], at[1], at[2] }));
      const double expected = Smooth((40.0 - at[axis] - reach) / 4.0);
      ASSERT_NEAR(ComputeResidency(region, ServoState{}, tip), expected, 1e-9) << i;
      between += expected > 0.0 && expected < 1.0 ? 1 : 0;
    }
  }
  EXPECT_GT(between, 100);
}
