// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The hand must not feel the placement of the volume, nor the grid on which a linear field was
 * sampled.
 */

#include "CompareTraces.h"
#include "RandomScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

using namespace reference;

namespace
{
Trace MovedBack(const Trace& trace, const Mat3& rotation, const Vec3& translation)
{
  Trace back = trace;
  for (TickRecord& tick : back)
  {
    tick.proxy = TransposedTimes(rotation, tick.proxy - translation);
    tick.tip = TransposedTimes(rotation, tick.tip - translation);
    tick.force = TransposedTimes(rotation, tick.force);
    tick.normal = TransposedTimes(rotation, tick.normal);
  }
  return back;
}
} // namespace

// The waves are long against the depth: if the tip is deeper than the surface's radius of
// curvature, the paper's solver chatters (T13), and chatter doubles any rounding at every tick.
TEST(Invariance, RigidMotionOfVolumeAndPath)
{
  double worst = 0.0;
  for (int seed = 0; seed < 60; ++seed)
  {
    Random random(7000 + seed);
    Scene scene;
    scene.estimator = AllEstimators[seed % 3];
    scene.side = Side(seed / 3 % 3);
    const Geometry geometry = GentleScene(scene, random, 150);
    const Trace first = RunFilter(scene);

    const Mat3 rotation = random.Rotation();
    const Vec3 translation = random.Uniform(0.0, 100.0) * random.UnitVector();
    MoveScene(scene, geometry, rotation, translation);
    const Trace second = MovedBack(RunFilter(scene), rotation, translation);
    const Difference difference = CompareForces(first, second);
    EXPECT_LE(difference.worst, 1e-12) << "seed " << seed << ": " << difference.text;
    worst = std::max(worst, difference.worst);
  }
  std::cout << "worst relative change of a force by rigid motion: " << worst << std::endl;
}

// Other spacings change r = KernelRadius x the largest spacing, the reach of x_s and x_v, and so
// which material is looked up: if the material varies, the largest spacing has to stay.
TEST(Invariance, RegriddingALinearField)
{
  double worst = 0.0;
  for (int seed = 0; seed < 90; ++seed)
  {
    const bool constantMaterial = seed % 2;
    Random random(8000 + seed);
    const Vec3 slope = 0.05 * random.UnitVector();
    const Field linear = [&](const Vec3& x) { return Dot(slope, x); };
    Scene scene;
    scene.estimator = AllEstimators[seed % 3];
    scene.image = Sample(Cube(24.0, 2.0), linear);
    GentleMaterial(scene, -1.0, 1.0);
    if (constantMaterial)
    {
      SetMaterial(scene, 500.0, 0.3, 0.2, 1.2);
    }
    Geometry walk = Cube(5.0, 1.0);
    RandomWalk(scene, random, walk, 150);
    for (Vec3& point : scene.path)
    {
      point = (6.0 / std::max(6.0, Norm(point))) * point; // far from every border
    }
    const Trace first = RunFilter(scene);

    Geometry other;
    other.direction = random.Rotation(random.Chance(0.5));
    for (int axis = 0; axis < 3; ++axis)
    {
      other.spacing[axis] = random.Uniform(0.8, constantMaterial ? 3.0 : 2.0);
    }
    other.spacing[seed % 3] = constantMaterial ? other.spacing[seed % 3] : 2.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int n = int(std::ceil(24.0 / other.spacing[axis]));
      other.extent[2 * axis] = random.Integer(-4, 4);
      other.extent[2 * axis + 1] = other.extent[2 * axis] + 2 * n;
    }
    other.origin = random.UnitVector() - other.Centre();
    scene.image = Sample(other, linear);
    const Difference difference = CompareForces(first, RunFilter(scene));
    EXPECT_LE(difference.worst, 1e-12) << "seed " << seed << ": " << difference.text;
    worst = std::max(worst, difference.worst);
  }
  std::cout << "worst relative change of a force by re-gridding: " << worst << std::endl;
}
