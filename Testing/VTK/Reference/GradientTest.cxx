// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that every estimator reproduces the gradient and the values of a linear field, on any grid.
 */

#include "RandomScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

using namespace reference;

namespace
{
struct Linear
{
  Vec3 slope;
  double offset;

  double operator()(const Vec3& x) const { return Dot(this->slope, x) + this->offset; }
};

// Returns random world positions whose kernels do not reach the border.
std::vector<Vec3> InnerPoints(Random& random, const Geometry& geometry, int radius, int count)
{
  std::vector<Vec3> points(count);
  for (Vec3& point : points)
  {
    Vec3 index;
    for (int axis = 0; axis < 3; ++axis)
    {
      index[axis] = random.Uniform(
        geometry.extent[2 * axis] + radius + 1, geometry.extent[2 * axis + 1] - radius - 1);
    }
    point = geometry.World(index);
  }
  return points;
}

void ExpectLinear(Scene& scene, const Linear& field)
{
  const double steepness = Norm(field.slope);
  double valueScale = 0.0;
  for (const Vec3& point : scene.path)
  {
    valueScale = std::max(valueScale, std::abs(field(point)));
  }
  // Without resistance, the proxy is at the tip, where the next tick reads its gradient.
  SetMaterial(scene, 500.0, 0.0, 0.0, 0.0);
  const Trace trace = RunFilter(scene);
  for (std::size_t tick = 1; tick < trace.size(); ++tick)
  {
    EXPECT_NEAR(trace[tick].gradientMagnitude, steepness, 1e-10 * steepness);
    EXPECT_LE(Norm(steepness * trace[tick].normal - field.slope), 1e-10 * steepness);
    EXPECT_NEAR(trace[tick].value, field(trace[tick].tip), 1e-10 * valueScale);
  }

  scene.method = Method::ForceField;
  scene.forceFieldGain = 0.5;
  const Trace forces = RunFilter(scene);
  EXPECT_EQ(Norm(forces[0].force), 0.0);
  for (std::size_t tick = 1; tick < forces.size(); ++tick)
  {
    EXPECT_LE(Norm(forces[tick].force + 0.5 * field.slope), 0.5e-10 * steepness);
    EXPECT_NEAR(forces[tick].value, field(forces[tick].tip), 1e-10 * valueScale);
  }
}
} // namespace

class Gradient : public testing::TestWithParam<Estimator>
{
};

TEST_P(Gradient, LinearFieldsAreExactOnAnyGrid)
{
  for (int radius = 1; radius <= 6; ++radius)
  {
    for (int seed = 0; seed < 8; ++seed)
    {
      SCOPED_TRACE("radius " + std::to_string(radius) + " seed " + std::to_string(seed));
      Random random(100 * radius + seed);
      const Geometry geometry = RandomGeometry(random, radius);
      const Linear field = { random.Uniform(0.1, 50.0) * random.UnitVector(), 20.0 };
      Scene scene;
      scene.estimator = this->GetParam();
      scene.kernelRadius = radius;
      scene.image = Sample(geometry, field);
      scene.path = InnerPoints(random, geometry, radius, 60);
      ExpectLinear(scene, field);
    }
  }
}

// The direction matrix must be invertible, but need not be orthonormal, as with a tilted gantry.
TEST_P(Gradient, LinearFieldsAreExactOnShearedGrids)
{
  for (int seed = 0; seed < 8; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(900 + seed);
    Geometry geometry = RandomGeometry(random, 2);
    geometry.direction.column[1] =
      geometry.direction.column[1] + random.Uniform(-0.5, 0.5) * geometry.direction.column[2];
    const Linear field = { random.UnitVector(), 20.0 };
    Scene scene;
    scene.estimator = this->GetParam();
    scene.image = Sample(geometry, field);
    scene.path = InnerPoints(random, geometry, 2, 60);
    ExpectLinear(scene, field);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Gradient, testing::ValuesIn(AllEstimators));
