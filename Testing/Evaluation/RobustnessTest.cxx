// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests solver PRECISE on realistic data and motions: thin sheets, ridges, plateaus, saturation,
 * noise.
 */

#include "RobustnessRig.h"
#include "Shapes.h"

using namespace evaluation;
using namespace VolumeHaptics;

namespace
{
/// Returns a material that is distinct only at steep edges.
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
  Candidate candidate{ HapticSolver::Precise, this->GetParam() };
  if (this->GetParam() == GradientEstimator::CentralDifference)
  {
    // Inside the sheet, the samples on both sides have no gradient, so there is no edge.
    candidate = PlacedAsThePaper(candidate);
  }
  Touching touching = TouchingOf(candidate, OnEdges(2.0, 200.0));
  touching.ReleaseTime = 0.0; // the sheet breaks in one tick
  const Trace trace = Play(*Volume(sheet, {}).Bake(touching), path);
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
  // Move along the ridge at a depth of 0.6 mm, which gives 0.3 N at most.
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

TEST_P(Robustness, BehindASaturatedEdgeLiesAPlateauThatHoldsTheHand)
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

INSTANTIATE_TEST_SUITE_P(Estimators, Robustness, AllEstimators);
