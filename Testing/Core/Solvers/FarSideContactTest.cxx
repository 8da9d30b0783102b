// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a hand on surfaces that take their material from the far side of the edge. The volumes
 * consist of plateaus, whose values are the expected ones. Along a surface, the value changes
 * exponentially, which is the solution of the equation in FarSide.h. A distance field has no far
 * side, so the test expects the same force as with the kernel's values.
 */

#include "Core/Solvers/Precise/FarSide.h"
#include "Rigs/CoreScene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

using namespace coretest;

namespace
{
constexpr double Air = -1000.0;
constexpr double Middle = 20.4; // position in mm and in voxels, because the spacing is 1 mm

double Phi(double x)
{
  return 0.5 * std::erfc(-x / std::sqrt(2.0));
}

/// Returns a volume of value(x, d), where x is in voxels and d is the distance (mm) from the middle
/// along z.
TestVolume MakeVolume(const std::function<double(double, double)>& value, double noise = 0.0)
{
  TestVolume volume(ScalarType::Float64, { 64, 16, 40 });
  std::mt19937 engine(9);
  std::normal_distribution<double> random;
  volume.Fill<double>(
    [&](std::int64_t i, std::int64_t, std::int64_t k)
    {
      const double clean = value(static_cast<double>(i), static_cast<double>(k) - Middle);
      return noise > 0.0 ? clean + noise * random(engine) : clean;
    });
  return volume;
}

HapticModelDescription DescribeFar(const TestVolume& volume)
{
  HapticModelDescription description = Describe(volume);
  description.Material.SurfaceStrength = ConstantPolyline(5.0);
  description.Material.Distinctness = { { 20.0, 0.0 }, { 60.0, 1.0 } };
  description.Settings.Placement = MaterialPlacement::FarSide;
  description.Settings.Alignment = ContactAlignment::Edge;
  return description;
}

/// Moves the tip by 0.05 mm per tick: first down to `depth` (mm) below the middle, then along x.
/// Returns all ticks.
std::vector<TickRecord> Stroke(const HapticModel& model, double depth, double from, double to)
{
  std::vector<TickRecord> trace;
  ServoState state;
  TickRecord record;
  const auto tick = [&](double x, double z)
  {
    Tick(model, state, { 0.001 * x, 0.0081, 0.001 * z }, record);
    trace.push_back(record);
  };
  for (double z = Middle - 8.0; z < Middle + depth; z += 0.05)
  {
    tick(from, z);
  }
  for (double x = from; x < to; x += 0.05)
  {
    tick(x, Middle + depth);
  }
  return trace;
}

const TickRecord& FirstTouch(const std::vector<TickRecord>& trace)
{
  return *std::find_if(
    trace.begin(), trace.end(), [](const TickRecord& r) { return r.NormalForce > 0.0; });
}

bool Holds(const TickRecord& record)
{
  return record.NormalForce > 0.0;
}

/// Returns the standard deviation of the inner value along the stroke, without the first 400 ticks,
/// in which the value settles.
double SpreadOf(const std::vector<TickRecord>& trace)
{
  double sum = 0.0;
  double squares = 0.0;
  const std::size_t first = 400;
  for (std::size_t i = first; i < trace.size(); ++i)
  {
    sum += trace[i].SurfaceValue;
    squares += trace[i].SurfaceValue * trace[i].SurfaceValue;
  }
  const auto count = static_cast<double>(trace.size() - first);
  return std::sqrt(squares / count - (sum / count) * (sum / count));
}
} // namespace

TEST(FarSideContact, BeforeAnEdgeNothingHolds)
{
  // The hand meets an edge without noise at positions between the samples. At more than 0.7 blurs
  // in front of its middle, the edge has risen by less than a quarter of its height. Interpolation
  // moves this position by at most one voxel.
  const std::int64_t n = 40;
  for (const double blur : { 0.05, 0.3, 0.6, 1.3 })
  {
    for (const Vector3& normal : { Vector3{ 0, 0, 1 }, { 0.6, 0, 0.8 }, { 0.48, 0.6, 0.64 } })
    {
      for (const double sign : { 1.0, -1.0 })
      {
        const Vector3 centre{ 20.3, 20.2 + 0.2 * sign, 20.1 + 0.3 * sign };
        TestVolume volume(ScalarType::Float64, { n, n, n });
        volume.Fill<double>(
          [&](std::int64_t i, std::int64_t j, std::int64_t k)
          {
            const Vector3 from = Vector3{ double(i), double(j), double(k) } - centre;
            return sign * (Air + 1060.0 * Phi(Dot(from, normal) / blur));
          });
        HapticModelDescription description = DescribeFar(volume);
        description.Settings.Side = sign > 0.0 ? SurfaceSide::Higher : SurfaceSide::Lower;
        for (const GradientEstimator estimator : { GradientEstimator::CentralDifference,
               GradientEstimator::Gaussian, GradientEstimator::CubicBSpline })
        {
          for (const int radius : { 1, 2, 3, 6 })
          {
            SCOPED_TRACE(testing::Message()
              << "blur " << blur << ", normal " << normal.X << " " << normal.Y << " " << normal.Z
              << ", sign " << sign << ", estimator " << int(estimator) << ", radius " << radius);
            description.Estimator = estimator;
            description.KernelRadius = radius;
            const HapticModel model(description);
            ServoState state;
            TickRecord record;
            double before = 0.0;
            for (double at = -9.0; at < 1.5; at += 0.1)
            {
              Tick(model, state, 0.001 * (centre + at * normal), record);
              const double proxy = Dot(1000.0 * record.Proxy - centre, normal);
              before = proxy < -1.0 - 0.7 * blur ? std::max(before, Norm(record.Force)) : before;
            }
            EXPECT_EQ(before, 0.0) << "N";
            EXPECT_GT(Norm(record.Force), 0.1) << "behind it";
          }
        }
      }
    }
  }
}

TEST(FarSideContact, SkinIsWhatLiesBehindItFromItsFirstTouchOn)
{
  const double height = 1060.0;
  const TestVolume volume =
    MakeVolume([&](double, double z) { return Air + height * Phi(z / 1.5); });
  HapticModelDescription description = DescribeFar(volume);
  for (const ContactAlignment alignment :
    { ContactAlignment::Edge, ContactAlignment::Distinctness })
  {
    description.Settings.Alignment = alignment;
    const HapticModel model(description);
    const TickRecord touch = FirstTouch(Stroke(model, 2.0, 12.0, 13.0));
    EXPECT_NEAR(touch.MediumValue, Air, 0.025 * height);
    if (alignment == ContactAlignment::Edge)
    {
      EXPECT_NEAR(touch.SurfaceValue, Air + height, 0.025 * height);
      EXPECT_NEAR(1000.0 * touch.Proxy.Z, Middle, 0.05);
    }
  }
  description.Settings.Placement = MaterialPlacement::Kernel;
  const HapticModel model(description);
  EXPECT_LT(FirstTouch(Stroke(model, 2.0, 12.0, 13.0)).SurfaceValue, Air + 0.95 * height)
    << "the blur is wide enough to matter";
}

// The edges are twice as wide as the widest edge whose plateaus a walk reaches.
TEST(FarSideContact, AWideEdgeIsFeltInItsMiddle)
{
  for (const double blur : { 2.0, 3.0, 4.0 })
  {
    for (const double slant : { 0.0, 0.6 })
    {
      SCOPED_TRACE(testing::Message() << blur << ", " << slant);
      const double across = std::sqrt(1.0 - slant * slant);
      const auto distance = [&](double x, double z) { return slant * (x - 30.0) + across * z; };
      const TestVolume volume =
        MakeVolume([&](double x, double z) { return 10000.0 * Phi(distance(x, z) / blur); });
      HapticModelDescription description = DescribeFar(volume);
      const double steepest = 10000.0 / (blur * std::sqrt(2.0 * 3.14159265358979323846));
      description.Material.Distinctness = { { 0.05 * steepest, 0.0 }, { 0.1 * steepest, 1.0 } };
      const TickRecord touch = FirstTouch(Stroke(HapticModel(description), 2.0, 30.0, 30.1));
      EXPECT_NEAR(distance(1000.0 * touch.Proxy.X, 1000.0 * touch.Proxy.Z - Middle), 0.0, 0.1);
    }
  }
}

TEST(FarSideContact, NoMaterialStepsAlongASurface)
{
  // Two materials are side by side, without a ramp between them.
  const double soft = 0.0;
  const double firm = 120.0;
  const TestVolume volume = MakeVolume(
    [&](double x, double z) { return Air + ((x < 30.0 ? soft : firm) - Air) * Phi(z / 1.2); });
  HapticModelDescription description = DescribeFar(volume);
  description.Material.Stiffness = { { soft, 300.0 }, { firm, 600.0 } };
  const auto largestStep = [&](const HapticModel& model)
  {
    const std::vector<TickRecord> trace = Stroke(model, 2.0, 15.0, 55.0);
    double largest = 0.0;
    for (std::size_t i = 1; i < trace.size(); ++i)
    {
      if (Holds(trace[i - 1]) && Holds(trace[i]))
      {
        const double voxels = 1000.0 * Norm(trace[i].Proxy - trace[i - 1].Proxy);
        const double bound =
          (firm - soft + 30.0) * (voxels + 1e-3) / (voxels + 1e-3 + FarSide::PathLength);
        largest =
          std::max(largest, std::abs(trace[i].SurfaceValue - trace[i - 1].SurfaceValue) / bound);
      }
    }
    EXPECT_GT(trace.back().SurfaceValue - trace[400].SurfaceValue, 0.5 * (firm - soft));
    EXPECT_GT(Norm(trace.back().Force), 0.5);
    return largest;
  };
  EXPECT_LT(largestStep(HapticModel(description)), 1.0);
  description.Settings.Placement = MaterialPlacement::Kernel;
  EXPECT_GT(largestStep(HapticModel(description)), 1.5) << "the scene has a step";
}

TEST(FarSideContact, TheMediumFollowsOverItsOwnPath)
{
  // Two media are side by side in front of one bone. At a distance s past their border, the
  // medium's value must be M = M1 + (M0 - M1) exp(-s/L), where M0 and M1 are the values that
  // strokes through only one medium find.
  const double border = 19.5;
  const auto strokeOver = [](const std::function<double(double)>& medium)
  {
    const TestVolume volume = MakeVolume(
      [&](double x, double z) { return medium(x) + (1000.0 - medium(x)) * Phi(z / 1.2); });
    return Stroke(HapticModel(DescribeFar(volume)), 2.0, 10.0, 55.0);
  };
  const std::vector<TickRecord> before = strokeOver([](double) { return -100.0; });
  const std::vector<TickRecord> after = strokeOver([](double) { return 0.0; });
  const std::vector<TickRecord> across =
    strokeOver([&](double x) { return x < border ? -100.0 : 0.0; });
  ASSERT_EQ(across.size(), after.size());
  int judged = 0;
  for (std::size_t i = 0; i < across.size(); ++i)
  {
    const double way = 1000.0 * across[i].Proxy.X - border;
    if (!Holds(across[i]) || std::abs(way) < 2.0 || 1000.0 * across[i].Tip.X < 13.0)
    {
      continue; // skip positions where samples of both media are mixed
    }
    const double left = way > 0.0 ? std::exp(-way / FarSide::MediumPathLength) : 1.0;
    const double expected =
      after[i].MediumValue + left * (before[i].MediumValue - after[i].MediumValue);
    ASSERT_NEAR(across[i].MediumValue, expected, 6.0) << way;
    ++judged;
  }
  EXPECT_GT(judged, 600);
}

TEST(FarSideContact, TheDragDoesNotStepWhereTheSurfaceIsLeft)
{
  const double slow = 0.0;
  const double thick = 60.0;
  const double steepest = 0.4 / (thick - slow); // N per unit of the scalar: slope of the drag
  const double border = 19.5;
  const TestVolume volume = MakeVolume(
    [&](double x, double z)
    {
      const double medium = x < border ? slow : thick;
      return medium + (1000.0 - medium) * Phi(z / 1.2);
    });
  HapticModelDescription description = DescribeFar(volume);
  description.Material.Viscosity = { { slow, 0.1 }, { thick, 0.5 }, { 200.0, 0.5 },
    { 900.0, 0.0 } };
  const HapticModel model(description);
  std::vector<Vector3> tips;
  const auto moveTo = [&](double x, double z)
  {
    const Vector3 goal = { 0.001 * x, 0.0081, 0.001 * z };
    const Vector3 from = tips.empty() ? goal : tips.back();
    const int steps = std::max(1, static_cast<int>(std::ceil(Norm(goal - from) / 5e-5)));
    for (int i = 1; i <= steps; ++i)
    {
      tips.push_back(from + (static_cast<double>(i) / steps) * (goal - from));
    }
  };
  moveTo(12.0, Middle - 5.0);
  moveTo(12.0, Middle + 1.5);
  moveTo(22.5, Middle + 1.5);
  moveTo(24.0, Middle - 2.5);
  ServoState state;
  TickRecord last;
  TickRecord record;
  bool hasTouched = false;
  double leftWith = -1.0;
  int judged = 0;
  for (const Vector3& tip : tips)
  {
    Tick(model, state, tip, record);
    const bool isLeft = hasTouched && !Holds(record);
    if (isLeft && tip.X > 0.0225)
    {
      leftWith = leftWith < 0.0 ? last.Viscosity : leftWith;
      const double voxels = 1000.0 * Norm(record.Proxy - last.Proxy) + 1e-3;
      const double bound = steepest * (thick - slow + 30.0) * voxels / FarSide::MediumPathLength;
      ASSERT_LT(std::abs(record.Viscosity - last.Viscosity), bound) << 1000.0 * tip.Z - Middle;
      ++judged;
    }
    hasTouched = hasTouched || Holds(record);
    last = record;
  }
  EXPECT_GT(judged, 10);
  EXPECT_GT(leftWith, 0.1);
  EXPECT_LT(leftWith, 0.35) << "the medium was not reached yet";
}

TEST(FarSideContact, DragWithoutAContactIsThatOfItsOwnPlace)
{
  // The tip moves out through the skin like a needle. In the air outside, the drag must be that of
  // air and not that of the tissue.
  const double height = 1050.0;
  const TestVolume volume =
    MakeVolume([&](double, double z) { return Air + height * Phi(z / 1.2); });
  HapticModelDescription description = DescribeFar(volume);
  description.Material.Viscosity = { { Air, 0.05 }, { Air + height, 0.3 } };
  const HapticModel model(description);
  ServoState state;
  TickRecord record;
  int judged = 0;
  for (double z = Middle + 6.0; z > Middle - 8.0; z -= 0.05)
  {
    Tick(model, state, { 0.0301, 0.0081, 0.001 * z }, record);
    EXPECT_EQ(record.NormalForce, 0.0);
    if (std::abs(1000.0 * record.Proxy.Z - Middle) < 0.5)
    {
      EXPECT_NEAR(record.MediumValue, Air, 0.03 * height) << z;
      EXPECT_GT(record.DragForce, 0.0);
      ++judged;
    }
  }
  EXPECT_GT(judged, 10);
}

TEST(FarSideContact, NoiseSpreadsTheValuesLessThanAtTheKernel)
{
  const TestVolume volume =
    MakeVolume([](double, double z) { return Air + 1060.0 * Phi(z / 1.2); }, 25.0);
  HapticModelDescription description = DescribeFar(volume);
  const double far = SpreadOf(Stroke(HapticModel(description), 2.0, 10.0, 55.0));
  description.Settings.Placement = MaterialPlacement::Kernel;
  const double kernel = SpreadOf(Stroke(HapticModel(description), 2.0, 10.0, 55.0));
  EXPECT_LT(far, 0.6 * kernel);
  EXPECT_GT(kernel, 8.0);
}

TEST(FarSideContact, ANewContactBeginsWithTheMaterialOfItsOwnPlace)
{
  // The skin holds up to 1 N. The bone is 6 mm behind the skin.
  const TestVolume volume = MakeVolume(
    [](double, double z) { return Air + 1050.0 * Phi(z / 0.8) + 1000.0 * Phi((z - 6.0) / 0.8); });
  HapticModelDescription description = DescribeFar(volume);
  description.Material.SurfaceStrength = { { 100.0, 1.0 }, { 900.0, 1e6 } };
  const HapticModel model(description);
  const std::vector<TickRecord> trace = Stroke(model, 11.0, 30.0, 31.0);
  double onSkin = 0.0;
  for (const TickRecord& record : trace)
  {
    onSkin = record.SurfaceValue < 500.0 ? std::max(onSkin, record.NormalForce) : onSkin;
    EXPECT_LT(1000.0 * record.Proxy.Z, Middle + 6.5) << "it fell through the bone";
  }
  EXPECT_NEAR(onSkin, 1.0, 0.02);
  EXPECT_NEAR(trace.back().SurfaceValue, 1050.0, 50.0);
  EXPECT_NEAR(1000.0 * trace.back().Proxy.Z, Middle + 6.0, 0.3);
  EXPECT_NEAR(trace.back().NormalForce, 500.0 * 0.005, 0.15);
}

// A hand moves from air to a wall whose edge is 5 voxels wide. One knob is ahead, beside the hand's
// path, and another one behind, on the other side. The normal therefore turns, and along it the
// second knob is soon behind the hand. The wall rises from -1000 to 1000, and the hand moves to the
// place where the value is 1863.
TEST(FarSideContact, AnEdgeDoesNotMoveAheadOfTheHand)
{
  constexpr double at = 30.0;
  const auto knob = [](double x, double z, double size)
  { return std::exp(-0.5 * (x * x + z * z) / (size * size)); };
  const auto value = [&](double x, double z)
  {
    return Air + 2000.0 * Phi(z / 2.4) + 2300.0 * knob(x - at + 3.7, z - 3.8, 2.8) +
      1300.0 * knob(x - at - 5.0, z + 3.0, 2.1);
  };
  constexpr double depth = 4.0;
  ASSERT_GT(value(at, depth), 1800.0);
  ASSERT_LT(value(at, -8.0), -990.0);
  const TestVolume volume = MakeVolume(value);
  double most = 0.0;
  for (const TickRecord& tick : Stroke(HapticModel(DescribeFar(volume)), depth, at, at))
  {
    most = std::max(most, tick.NormalForce);
  }
  EXPECT_GT(most, 0.1) << "what a hand feels";
}

TEST(FarSideContact, StructuresOfLowerValuesFeelAsThoseOfHigherOnes)
{
  const auto value = [](double x, double z)
  { return Air + (1060.0 + 60.0 * std::sin(0.4 * x)) * Phi(z / 1.1); };
  const TestVolume volume = MakeVolume(value);
  const TestVolume mirrored = MakeVolume([&](double x, double z) { return -value(x, z); });
  HapticModelDescription higher = DescribeFar(volume);
  higher.Material.Friction = ConstantPolyline(0.3);
  higher.Material.Stiffness = { { 0.0, 300.0 }, { 120.0, 500.0 } };
  HapticModelDescription lower = DescribeFar(mirrored);
  lower.Material = higher.Material;
  lower.Material.Stiffness = { { -120.0, 500.0 }, { 0.0, 300.0 } };
  lower.Settings.Side = SurfaceSide::Lower;
  HapticModelDescription both = lower;
  both.Settings.Side = SurfaceSide::Both;
  const auto expected = Stroke(HapticModel(higher), 2.0, 15.0, 45.0);
  // With two-sided surfaces, a proxy without a lag does not know its side of the surface, so the
  // contact may begin one tick late.
  const double late = 500.0 * 5e-5;
  for (const auto& [description, tolerance] :
    { std::pair(lower, 1e-6), std::pair(both, 1.2 * late) })
  {
    const auto found = Stroke(HapticModel(description), 2.0, 15.0, 45.0);
    ASSERT_EQ(found.size(), expected.size());
    double largest = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      ASSERT_LT(Norm(found[i].Force - expected[i].Force), tolerance) << i;
      largest = std::max(largest, Norm(found[i].Force));
    }
    EXPECT_GT(largest, 0.6);
  }
}

// T1 and T2 of the specification, in a volume that is so small that every position is less than
// three kernel radii from the border.
TEST(FarSideContact, AnEvenRampIsFeltAsWithTheKernel)
{
  const TestVolume ramp = MakeRamp(12);
  HapticModelDescription description = Describe(ramp);
  description.Material.SurfaceStrength = ConstantPolyline(2.0);
  description.Material.Friction = { { 0.0, 0.1 }, { 1200.0, 0.5 } };
  description.Settings.Placement = MaterialPlacement::Kernel;
  description.Settings.Alignment = ContactAlignment::Distinctness;
  const HapticModel kernel(description);
  description.Settings.Placement = MaterialPlacement::FarSide;
  description.Settings.Alignment = ContactAlignment::Edge;
  const HapticModel far(description);
  ServoState states[2];
  TickRecord records[2];
  for (int i = 0; i <= 100; ++i)
  {
    // The tip moves 5 mm in and out again, and sideways at the same time.
    const double depth = 0.1 * (i <= 50 ? i : 100 - i);
    const Vector3 tip = { 0.005 + 2e-5 * i, 0.006, 0.001 * (4.0 + depth) };
    Tick(kernel, states[0], tip, records[0]);
    Tick(far, states[1], tip, records[1]);
    EXPECT_NEAR(Norm(records[1].Force - records[0].Force), 0.0, 1e-9) << depth << " mm deep";
    if (i <= 50)
    {
      EXPECT_NEAR(records[1].NormalForce, std::min(2.0, 0.5 * depth), 1e-9) << depth << " mm deep";
    }
  }
}

namespace
{
/// A body whose distance field is the volume. Depth() returns the depth (in mm and in voxels) below
/// its surface.
struct Body
{
  const char* Name;
  double (*Depth)(const Vector3&);
};

constexpr double Half = 28.6; // centre (mm) of the bodies along each axis
constexpr double Pi = 3.14159265358979323846;

const Body Bodies[] = {
  { "ball",
    [](const Vector3& x) {
      return 10.0 - Norm(x - Vector3{ Half, Half, Half });
    } },
  { "small ball",
    [](const Vector3& x) {
      return 6.0 - Norm(x - Vector3{ Half, Half, Half });
    } },
  { "hollow",
    [](const Vector3& x) {
      return Norm(x - Vector3{ Half, Half, Half }) - 10.0;
    } },
  { "ball in a field that ends 10 voxels from it",
    [](const Vector3& x) {
      return std::max(-10.0, 15.0 - Norm(x - Vector3{ Half, Half, Half }));
    } },
  { "ring",
    [](const Vector3& x)
    {
      const Vector3 d = x - Vector3{ Half, Half, Half };
      return 7.0 - std::hypot(std::hypot(d.X, d.Y) - 17.0, d.Z);
    } },
  // The gyroid's radii of curvature are at least 11 voxels. Its gradient on the surface is 1 to
  // 1.23 per voxel.
  { "gyroid",
    [](const Vector3& x)
    {
      const double k = 2.0 * Pi / 60.0;
      const Vector3 d = k * (x - Vector3{ Half, Half, Half });
      return (std::sin(d.X) * std::cos(d.Y) + std::sin(d.Y) * std::cos(d.Z) +
               std::sin(d.Z) * std::cos(d.X)) /
        (std::sqrt(2.0) * k);
    } },
};

Vector3 Slope(const Body& body, const Vector3& x)
{
  const double h = 1e-4;
  const auto along = [&](const Vector3& e)
  { return (body.Depth(x + h * e) - body.Depth(x - h * e)) / (2.0 * h); };
  return { along({ 1, 0, 0 }), along({ 0, 1, 0 }), along({ 0, 0, 1 }) };
}

/// Moves `x` along the gradient to a depth (mm). Returns the new position.
Vector3 AtDepth(const Body& body, Vector3 x, double depth)
{
  for (int i = 0; i < 20; ++i)
  {
    const Vector3 slope = Slope(body, x);
    x += ((depth - body.Depth(x)) / Dot(slope, slope)) * slope;
  }
  return x;
}
} // namespace

TEST(FarSideContact, ADistanceFieldOfCoarseVoxelsIsFeltAsWithTheKernel)
{
  constexpr double steepness = 100.0; // per voxel
  std::mt19937 engine(5);
  std::normal_distribution<double> normal;
  for (const Body& body : Bodies)
  {
    SCOPED_TRACE(body.Name);
    TestVolume volume(ScalarType::Float32, { 58, 58, 58 });
    volume.Fill<float>(
      [&](std::int64_t i, std::int64_t j, std::int64_t k) {
        return steepness * body.Depth({ double(i), double(j), double(k) });
      });
    HapticModelDescription description = DescribeFar(volume);
    description.Material.SurfaceStrength = { { 0.0, 0.0 }, { 20.0, 5.0 } };
    const HapticModel far(description);
    PlaceAsThePaper(description);
    const HapticModel kernel(description);
    double farthest = 0.0;
    int held = 0;
    for (int stroke = 0; stroke < 6; ++stroke)
    {
      const Vector3 start = { Half + 12.0 * normal(engine), Half + 12.0 * normal(engine),
        Half + 12.0 * normal(engine) };
      Vector3 tip = AtDepth(body, start, -5.0);
      Vector3 way = { normal(engine), normal(engine), normal(engine) };
      ServoState states[2];
      TickRecord records[2];
      for (int i = 0; i < 900; ++i)
      {
        // The surface is felt one kernel radius (2 mm) outside the body, so a tip on the body's
        // surface is 2 mm deep.
        const double depth = std::min(-5.0 + 0.05 * i, 0.0);
        way += 0.02 * Vector3{ normal(engine), normal(engine), normal(engine) };
        tip = AtDepth(body, tip + (0.05 / Norm(way)) * way, depth);
        const double border =
          std::min({ tip.X, tip.Y, tip.Z, 57.0 - tip.X, 57.0 - tip.Y, 57.0 - tip.Z });
        if (border < 9.0)
        {
          break;
        }
        Tick(kernel, states[0], 0.001 * tip, records[0]);
        Tick(far, states[1], 0.001 * tip, records[1]);
        farthest = std::max(farthest, 1000.0 * Norm(records[1].Proxy - records[0].Proxy));
        held += Holds(records[1]);
      }
    }
    EXPECT_LT(farthest, 0.05);
    EXPECT_GT(held, 900);
  }
}

TEST(FarSideContact, ARampOfRoundedSamplesHoldsAsFirmlyAsAnExactOne)
{
  // A ball without an edge: the values rise evenly by 10 per voxel. The surface is where the hand
  // first touches the ramp. At 1 mm below it, the tip feels 500 N/m times 1 mm, and a press of 5 N
  // must not break through.
  const double radius = 100.0;
  const double expected = 500.0 * 1e-3;
  const Vector3 out = (1.0 / std::sqrt(14.0)) * Vector3{ 2.0, 1.0, 3.0 };
  const Vector3 across = (1.0 / std::sqrt(5.0)) * Vector3{ 1.0, -2.0, 0.0 };
  const Vector3 along = Cross(out, across);
  const Vector3 centre = Vector3{ 24.0, 24.0, 24.0 } - radius * out;
  for (const bool isRounded : { false, true })
  {
    TestVolume volume(ScalarType::Float64, { 49, 49, 49 });
    volume.Fill<double>(
      [&](std::int64_t i, std::int64_t j, std::int64_t k)
      {
        const Vector3 to = Vector3{ double(i), double(j), double(k) } - centre;
        const double value = 2000.0 - Dot(to, to) / 20.0;
        return isRounded ? std::floor(value) : value;
      });
    HapticModelDescription description = DescribeFar(volume);
    description.Material.Distinctness = { { 0.1, 0.0 }, { 1.0, 1.0 } };
    const HapticModel model(description);
    for (double turn = 0.0; turn < 3.0; turn += 0.2)
    {
      const Vector3 aside = std::cos(turn) * across + std::sin(turn) * along;
      ServoState state;
      TickRecord record;
      const auto tick = [&](double angle, double depth)
      {
        const Vector3 direction = std::cos(angle) * out + std::sin(angle) * aside;
        Tick(model, state, 0.001 * (centre + (radius - depth) * direction), record);
      };
      const double first = -0.16;
      for (double depth = 0.0; depth < 1.0; depth += 0.05)
      {
        tick(first, depth);
      }
      for (double angle = first; angle < -first; angle += 0.0005)
      {
        tick(angle, 1.0);
        ASSERT_NEAR(record.NormalForce, expected, 0.1 * expected)
          << (isRounded ? "rounded, " : "exact, ") << angle << ", " << turn;
      }
    }
  }
}

TEST(FarSideContact, APressIsTheSameInTicksOfAnyLength)
{
  // A ball of 30 mm radius, whose wall has a strength of T = 2 N (eq. 12) and a stiffness of 500
  // N/m. The force must be min(k lag, T), however far the tip moves in one tick. Behind the wall of
  // 2 mm, the values are constant and hold nothing. The hand may touch the wall up to two voxels
  // (the kernel's reach) outside 30 mm.
  constexpr double stiffness = 0.5; // N/mm
  constexpr double strength = 2.0;  // N
  constexpr double radius = 30.0;
  constexpr double reach = 2.0;
  const Vector3 out = (1.0 / 2.3) * Vector3{ 1.0, 2.0, -0.54 }; // any direction
  const Vector3 middle = { 36.0, 36.0, 36.0 };
  for (const bool isEven : { false, true })
  {
    TestVolume volume(ScalarType::Float32, { 73, 73, 73 });
    volume.Fill<float>(
      [&](std::int64_t i, std::int64_t j, std::int64_t k)
      {
        const double depth = radius - Norm(Vector3{ double(i), double(j), double(k) } - middle);
        return static_cast<float>(1000.0 * (isEven ? depth : std::clamp(depth, -1.0, 1.0)));
      });
    HapticModelDescription description = DescribeFar(volume);
    description.Material.SurfaceStrength = ConstantPolyline(strength);
    description.Material.ScalarVisibility = { { -100.0, 0.0 }, { 100.0, 1.0 } };
    const HapticModel model(description);
    for (const double depth : { 1.5, 2.5, 3.5, 11.5 })
    {
      for (const int ticks : { 1, 2, 3, 12, 100, 2000 })
      {
        SCOPED_TRACE(testing::Message()
          << (isEven ? "even" : "a wall") << ", " << depth << " mm deep in " << ticks << " ticks");
        ServoState state;
        TickRecord record;
        const auto tick = [&](double height)
        { Tick(model, state, 0.001 * (middle + (radius + height) / Norm(out) * out), record); };
        tick(5.0);
        for (int i = 1; i <= ticks; ++i)
        {
          tick(5.0 - (5.0 + depth) * i / ticks);
        }
        for (int i = 0; i < 200; ++i) // rests until the force has faded after the leap
        {
          tick(-depth);
        }
        const double lag = 1000.0 * Norm(record.Tip - record.Proxy);
        const double force = Norm(record.Force);
        if (depth > 10.0 && !isEven)
        {
          EXPECT_EQ(force, 0.0);
          continue;
        }
        EXPECT_NEAR(force, std::min(stiffness * lag, strength), 1e-3);
        EXPECT_GT(lag, std::min(depth, strength / stiffness) - 0.5);
        EXPECT_LT(lag, std::min(depth + reach, strength / stiffness + 0.01));
      }
    }
  }
}
