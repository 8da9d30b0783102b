// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A hand on surfaces whose materials belong to their far side. The volumes are built from values of
 * plateaus, which are also what is expected; steps along a surface are bounded by the equation in
 * FarSide.h.
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
constexpr double Middle = 20.4; // mm, and voxels

double Phi(double x)
{
  return 0.5 * std::erfc(-x / std::sqrt(2.0));
}

/// Samples of a function of x (voxels) and of the distance from the middle along z.
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

/// Ticks of 0.05 mm: from above to a depth (mm) under the middle, then along x.
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

/// The standard deviation of the inner value along the stroke, once it has settled.
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

TEST(FarSideContact, NoMaterialStepsAlongASurface)
{
  // Two materials side by side, without a ramp between them.
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
  // Skin that holds 1 N, and 6 mm behind it bone.
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
  // With two-sided surfaces a proxy without lag does not know its side, and may be a tick late.
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
