// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests the replacement for a sample that is NaN or infinite. */

#include "RandomScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using namespace reference;

namespace
{
constexpr double Inf = std::numeric_limits<double>::infinity();
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
} // namespace

class NonFiniteValues : public testing::TestWithParam<Estimator>
{
};

TEST_P(NonFiniteValues, TheBorderValueStandsIn)
{
  for (double bad : { NaN, Inf, -Inf })
  {
    Scene scene;
    scene.estimator = this->GetParam();
    scene.image = Sample(Cube(8.0, 1.0),
      [&](const Vec3& x)
      {
        const double edge = std::max({ std::abs(x[0]), std::abs(x[1]), std::abs(x[2]) });
        return edge > 7.5 ? 7.0 : (edge == 0.0 ? bad : 100.0);
      });
    SetMaterial(scene, 500.0, 0.0, 0.0, 0.0);
    scene.path = { { { 4.0, 0.0, 0.0 } }, {}, {} };
    const TickRecord tick = RunFilter(scene).back();
    EXPECT_EQ(tick.gradientMagnitude, 0.0);
    if (this->GetParam() != Estimator::CubicBSpline)
    {
      EXPECT_EQ(tick.value, 7.0);
    }
    EXPECT_GE(tick.value, 7.0); // a spline may blend the border's value with its neighbours
    EXPECT_LE(tick.value, 100.0);
  }
}

// A value outside the volume equals that of the nearest border point. An invalid voxel with zero
// weight must not change this value. This voxel is the next one inwards for trilinear values, and
// the second one inwards for splines.
TEST_P(NonFiniteValues, AZeroWeightIsNoSample)
{
  const double layer = this->GetParam() == Estimator::CubicBSpline ? 6.0 : 7.0;
  Scene scene;
  scene.estimator = this->GetParam();
  scene.image =
    Sample(Cube(8.0, 1.0), [&](const Vec3& x) { return x[0] == layer ? Inf : 10.0 * x[0]; });
  SetMaterial(scene, 500.0, 0.0, 0.0, 0.0);
  scene.path = { { { 9.0, 0.25, 0.5 } }, { { 8.5, 0.25, 0.5 } } };
  const Trace expected = RunReference(scene);
  const Trace actual = RunFilter(scene);
  for (std::size_t tick = 0; tick < actual.size(); ++tick)
  {
    EXPECT_NEAR(actual[tick].value, expected[tick].value, 1e-9);
  }
}

TEST_P(NonFiniteValues, NoNumberAtAllOrEnormousOnes)
{
  Random random(5);
  for (double content : { NaN, Inf, 1e308 })
  {
    for (Method method : { Method::Proxy, Method::ForceField })
    {
      Scene scene;
      scene.estimator = this->GetParam();
      scene.method = method;
      scene.forceFieldGain = 0.01;
      const Geometry cube = Cube(8.0, 1.0);
      scene.image =
        Sample(cube, [&](const Vec3&) { return random.Chance(0.5) ? content : -content; });
      SetMaterial(scene, 500.0, 0.3, 0.2, 2.0);
      RandomWalk(scene, random, cube, 200);
      for (const TickRecord& tick : RunFilter(scene))
      {
        EXPECT_TRUE(IsFinite(tick.force) && IsFinite(tick.proxy));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, NonFiniteValues, testing::ValuesIn(AllEstimators));
