// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * With solver PRECISE, too, the placement of the volume and the grid on which a linear field was
 * sampled must not be felt; and if the material is the same everywhere, a small motion of the tip
 * changes the force by no more than the spring's.
 */

#include "CompareTraces.h"
#include "RandomScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

using namespace reference;

namespace
{
/// The solver ends its search within some thousandths of a voxel in a tick.
constexpr double ToleranceInVoxels = 2e-2;

/// The same walk with its jumps walked: friction remembers the steps that a jump is taken in.
std::vector<Vec3> WithoutJumps(const std::vector<Vec3>& path)
{
  std::vector<Vec3> walked = { path.front() };
  for (const Vec3& goal : path)
  {
    const Vec3 start = walked.back();
    const double steps = std::ceil(Norm(goal - start) / 0.3);
    for (double i = 1.0; i <= steps; i += 1.0)
    {
      walked.push_back(start + (i / steps) * (goal - start));
    }
  }
  return walked;
}

/// N, of a spring that is off by the solver's tolerance.
double Tolerance(const Scene& scene, double stiffness)
{
  double spacing[3];
  scene.image->GetSpacing(spacing);
  return ToleranceInVoxels * *std::max_element(spacing, spacing + 3) * scene.metersPerWorldUnit *
    stiffness;
}

void ExpectSame(const Scene& scene, const Trace& a, const Trace& b, const Mat3& rotation)
{
  int felt = 0;
  for (std::size_t tick = 0; tick < a.size(); ++tick)
  {
    const Vec3 difference = rotation * a[tick].force - b[tick].force;
    EXPECT_LE(Norm(difference), Tolerance(scene, a[tick].stiffness)) << "tick " << tick;
    felt += Norm(a[tick].force) > 0.01;
  }
  EXPECT_GT(felt, 10) << "nothing is felt";
}
} // namespace

TEST(PreciseInvariance, RigidMotionOfVolumeAndPath)
{
  for (int seed = 0; seed < 60; ++seed)
  {
    Random random(7000 + seed);
    Scene scene;
    scene.solver = Solver::Precise;
    scene.estimator = AllEstimators[seed % 3];
    const Geometry geometry = GentleScene(scene, random, 150);
    const Trace first = RunFilter(scene);

    const Mat3 rotation = random.Rotation();
    const Vec3 translation = random.Uniform(0.0, 100.0) * random.UnitVector();
    MoveScene(scene, geometry, rotation, translation);
    SCOPED_TRACE("seed " + std::to_string(seed));
    ExpectSame(scene, first, RunFilter(scene), rotation);
  }
}

TEST(PreciseInvariance, RegriddingALinearField)
{
  for (int seed = 0; seed < 60; ++seed)
  {
    Random random(8000 + seed);
    const Vec3 slope = 0.05 * random.UnitVector();
    const Field linear = [&](const Vec3& x) { return Dot(slope, x); };
    Scene scene;
    scene.solver = Solver::Precise;
    scene.estimator = AllEstimators[seed % 3];
    scene.image = Sample(Cube(24.0, 2.0), linear);
    SetMaterial(scene, 500.0, 0.3, 0.2, 1.2);
    RandomWalk(scene, random, Cube(5.0, 1.0), 150);
    scene.path = WithoutJumps(scene.path);
    const Trace first = RunFilter(scene);
    scene.image = Sample(Cube(25.0, random.Uniform(0.8, 2.2)), linear);
    SCOPED_TRACE("seed " + std::to_string(seed));
    ExpectSame(scene, first, RunFilter(scene), Mat3());
  }
}

TEST(PreciseInvariance, TheForceFollowsTheTipNoStifferThanTheSpring)
{
  for (int seed = 0; seed < 60; ++seed)
  {
    Random random(9000 + seed);
    Scene scene;
    scene.solver = Solver::Precise;
    scene.estimator = AllEstimators[seed % 3];
    // A plane, or a cavity some way off: what is free there is convex, and a projection onto it
    // shortens.
    const Vec3 slope = random.UnitVector();
    const bool isPlane = seed % 2;
    // An edge's strength would grow with the depth in the cavity, and limit 1e9 N to some.
    scene.placesAsThePaper = !isPlane;
    const auto field = [&](const Vec3& x)
    {
      const Vec3 off = x - 20.0 * slope;
      return isPlane ? 10.0 * Dot(slope, x) : Dot(off, off);
    };
    scene.image = Sample(Cube(24.0, 1.0), field);
    const double stiffness = random.Uniform(200.0, 1500.0);
    const double friction = seed % 4 < 2 ? 0.0 : random.Uniform(0.0, 0.6);
    SetMaterial(scene, stiffness, friction, seed % 3 ? 0.3 : 0.0, isPlane ? 1.5 : 1e9);
    RandomWalk(scene, random, Cube(8.0, 1.0), 300);
    const Trace trace = RunFilter(scene);
    // Friction grows with the normal force.
    const double k = 0.001 * stiffness * std::hypot(1.0, friction);
    for (std::size_t tick = 1; tick < trace.size(); ++tick)
    {
      const double step = Norm(trace[tick].tip - trace[tick - 1].tip);
      const double change = Norm(trace[tick].force - trace[tick - 1].force);
      EXPECT_LE(change, k * step + Tolerance(scene, stiffness))
        << "seed " << seed << " tick " << tick;
    }
  }
}
