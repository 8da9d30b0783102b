// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests solver PRECISE on unusual input: a step of a material function, a volume without a
 * gradient, flat voxels, and the border.
 */

#include "RobustnessRig.h"
#include "Shapes.h"

#include <algorithm>

using namespace evaluation;
using namespace VolumeHaptics;

class OddInput : public Robustness
{
};

TEST_P(OddInput, AStepOfAFunctionIsFoundAndHeld)
{
  HapticMaterial material = MakeMaterial(500.0, 0.0, 0.0, 2.0);
  material.SurfaceStrength = { { 500.0, 0.0 }, { 500.0, 2.0 } };
  const Path path = Press(8.0, 0.1);
  const Trace trace = this->Feel([](const Vector3& x) { return 100.0 * x.Z; }, {}, material, path);
  // The value is 500 at z = 5 mm. It is read at x_s, 2 mm ahead of the proxy, so the step is felt
  // at z = 3 mm. The step holds until the spring is 4 mm long.
  for (std::size_t i = 0; i < trace.size(); ++i)
  {
    const double expected = std::clamp(0.5 * (path[i].Z - 3.0), 0.0, 2.0);
    EXPECT_NEAR(Norm(trace[i].Force), expected, 1e-3) << path[i].Z;
  }
}

TEST_P(OddInput, WithoutAGradientThereIsNoSurface)
{
  const Trace trace =
    this->Feel([](const Vector3&) { return 100.0; }, {}, MakeMaterial(500.0, 0.3), Press(8.0, 0.1));
  for (const TickRecord& tick : trace)
  {
    EXPECT_EQ(Norm(tick.Force), 0.0);
  }
}

TEST_P(OddInput, FlatVoxelsAreNoObstacle)
{
  Sampling sampling;
  sampling.Spacing = { 0.5, 0.5, 5.0 };
  Path path = { 2.0 * OddNormal };
  MoveTo(path, 4.0 * OddNormal, 0.1);
  MoveTo(path, 4.0 * OddNormal + 10.0 * OddAside, 0.2);
  const Trace trace = this->Feel([](const Vector3& x) { return 100.0 * Dot(x, OddNormal); },
    sampling, MakeMaterial(500.0, 0.0, 0.0, Impenetrable), path);
  for (std::size_t i = 25; i < trace.size(); ++i)
  {
    EXPECT_NEAR(Norm(trace[i].Force + OddNormal), 0.0, 1e-3) << "tick " << i;
  }
}

TEST_P(OddInput, AcrossTheBorderNothingPops)
{
  // The volume ends at a radius of 24 mm.
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

INSTANTIATE_TEST_SUITE_P(Estimators, OddInput, AllEstimators);
