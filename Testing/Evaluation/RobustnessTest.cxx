// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Solver PRECISE on what data and hands are like: thin sheets, ridges, plateaus, noise, saturation, steps in
 * the functions, no gradient at all, flat voxels, the border.
 */

#include "Figure.h"
#include "Shapes.h"

#include <gtest/gtest.h>

using namespace evaluation;
using namespace VolumeHaptics;

namespace
{
class Robustness : public testing::TestWithParam<GradientEstimator>
{
protected:
  Trace Feel(
    const Field& field, const Sampling& sampling, const HapticMaterial& material, const Path& path)
  {
    const Volume volume(field, sampling);
    return Play(
      *volume.Bake(TouchingOf({ HapticSolver::Precise, this->GetParam() }, material)), path);
  }
};

Path Press(double depth, double step = 0.05)
{
  Path path = { { 0.3, 0.2, -8.0 } };
  MoveTo(path, { 0.3, 0.2, depth }, step);
  return path;
}

/// An edge that counts where it is steep.
HapticMaterial OnEdges(double strength, double steepest)
{
  HapticMaterial material = MakeMaterial(500.0, 0.0, 0.0, strength);
  material.Distinctness = { { 0.1 * steepest, 0.0 }, { 0.5 * steepest, 1.0 } };
  return material;
}
} // namespace

TEST_P(Robustness, ASheetOfOneVoxelHoldsAndBreaksOnce)
{
  const auto sheet = [](const Vector3& x) { return std::abs(x.Z) < 0.5 ? 1000.0 : 0.0; };
  const Path path = Press(12.0);
  const Trace trace = this->Feel(sheet, {}, OnEdges(2.0, 200.0), path);
  double largest = 0.0;
  int breaks = 0;
  for (std::size_t i = 1; i < trace.size(); ++i)
  {
    const double force = Norm(trace[i].Force);
    largest = std::max(largest, force);
    breaks += force < 0.5 * Norm(trace[i - 1].Force) && Norm(trace[i - 1].Force) > 1.0 ? 1 : 0;
    EXPECT_TRUE(force > 1.9 || ProxyOf(trace[i]).Z < 0.0 || breaks == 1) << "tick " << i;
  }
  EXPECT_NEAR(largest, 2.0, 0.02);
  EXPECT_EQ(breaks, 1);
  EXPECT_LT(Norm(trace.back().Force), 1e-9);
}

TEST_P(Robustness, ARidgeIsSlidOverWithoutChatter)
{
  const auto ridge = [](const Vector3& x) { return 100.0 * (x.Z - 0.5 * std::abs(x.X)); };
  // Along it, 0.6 mm deep, which is 0.3 N at most.
  Path path = { { -8.0, 0.2, -4.0 } };
  for (double x = -8.0; x <= 8.0; x += 0.05)
  {
    path.push_back({ x, 0.2, 0.5 * std::abs(x) - 8.0 + 0.6 });
  }
  const Trace trace = this->Feel(ridge, {}, MakeMaterial(500.0, 0.0, 0.0, Impenetrable), path);
  for (std::size_t i = 2; i < trace.size(); ++i)
  {
    const Vector3 change = trace[i].Force - trace[i - 1].Force;
    EXPECT_LT(Norm(change), 0.1) << "tick " << i;
  }
}

TEST_P(Robustness, BehindASaturatedEdgeLiesAPlateauThatNobodyFallsThrough)
{
  const auto saturated = [](const Vector3& x) { return 400.0 * BlurredStep(x.Z, 1.5, 1.0) - 50.0; };
  Sampling sampling;
  sampling.Type = ScalarType::UInt8;
  const Path path = Press(4.0);
  const Trace trace = this->Feel(saturated, sampling, OnEdges(Impenetrable, 100.0), path);
  for (const TickRecord& tick : trace)
  {
    EXPECT_LT(ProxyOf(tick).Z, 1.0);
  }
  EXPECT_GT(Norm(trace.back().Force), 1.5);
}

TEST_P(Robustness, NoiseOfACTNeitherLeaksNorPushes)
{
  Sampling sampling;
  sampling.Type = ScalarType::Int16;
  sampling.Noise = 20.0;
  Path path = Press(2.0, 0.1);
  for (int i = 0; i < 20; ++i)
  {
    MoveTo(path, { i % 2 ? 10.0 : -10.0, 0.7 * (i - 10), 2.0 }, 0.1);
  }
  const Trace trace = this->Feel([](const Vector3& x) { return BlurredStep(x.Z, 1.0, 1000.0); },
    sampling, OnEdges(Impenetrable, 400.0), path);
  for (std::size_t i = 0; i < trace.size(); ++i)
  {
    EXPECT_LT(ProxyOf(trace[i]).Z, 1.0);
    EXPECT_TRUE(path[i].Z > -4.0 || Norm(trace[i].Force) < 0.05) << "in the air, tick " << i;
  }
}

TEST_P(Robustness, AStepOfAFunctionIsFoundAndHeld)
{
  HapticMaterial material = MakeMaterial(500.0, 0.0, 0.0, 2.0);
  material.SurfaceStrength = { { 500.0, 0.0 }, { 500.0, 2.0 } };
  const Path path = Press(8.0, 0.1);
  const Trace trace = this->Feel([](const Vector3& x) { return 100.0 * x.Z; }, {}, material, path);
  // x_s is 2 mm ahead: the step stands at z = 3 mm and holds 4 mm of spring.
  for (std::size_t i = 0; i < trace.size(); ++i)
  {
    const double expected = std::clamp(0.5 * (path[i].Z - 3.0), 0.0, 2.0);
    EXPECT_NEAR(Norm(trace[i].Force), expected, 1e-3) << path[i].Z;
  }
}

TEST_P(Robustness, WithoutAGradientThereIsNoSurface)
{
  const Trace trace =
    this->Feel([](const Vector3&) { return 100.0; }, {}, MakeMaterial(500.0, 0.3), Press(8.0, 0.1));
  for (const TickRecord& tick : trace)
  {
    EXPECT_EQ(Norm(tick.Force), 0.0);
  }
}

TEST_P(Robustness, FlatVoxelsAreNoObstacle)
{
  Sampling sampling;
  sampling.Spacing = { 0.5, 0.5, 5.0 };
  Path path = { 2.0 * OddNormal };
  MoveTo(path, 4.0 * OddNormal, 0.1);
  const Vector3 aside = (1.0 / std::sqrt(5.0)) * Vector3{ 2.0, 1.0, 0.0 };
  MoveTo(path, 4.0 * OddNormal + 10.0 * aside, 0.2);
  const Trace trace = this->Feel([](const Vector3& x) { return 100.0 * Dot(x, OddNormal); },
    sampling, MakeMaterial(500.0, 0.0, 0.0, Impenetrable), path);
  for (std::size_t i = 25; i < trace.size(); ++i)
  {
    EXPECT_NEAR(Norm(trace[i].Force + OddNormal), 0.0, 1e-3) << "tick " << i;
  }
}

TEST_P(Robustness, AcrossTheBorderNothingPops)
{
  // The volume ends at 24 mm.
  Path path = { { 30.0, 0.2, 0.0 } };
  MoveTo(path, { 20.0, 0.2, 1.0 }, 0.1);
  MoveTo(path, { 30.0, 0.2, 1.0 }, 0.1);
  const Trace trace = this->Feel(
    [](const Vector3& x) { return 100.0 * x.Z; }, {}, MakeMaterial(500.0, 0.0, 0.0, 2.0), path);
  for (std::size_t i = 1; i < trace.size(); ++i)
  {
    EXPECT_LE(Norm(trace[i].Force - trace[i - 1].Force), 0.15) << "tick " << i;
  }
  EXPECT_EQ(Norm(trace.back().Force), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Estimators, Robustness,
  testing::Values(GradientEstimator::CentralDifference, GradientEstimator::Gaussian,
    GradientEstimator::CubicBSpline));
