// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Samples that are not numbers are felt as nothing, and never reach a force.
 */

#include "CompareTraces.h"
#include "RandomScene.h"

#include <gtest/gtest.h>
#include <vtkDataArray.h>

#include <limits>

using namespace reference;

namespace
{
constexpr double Inf = std::numeric_limits<double>::infinity();
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

bool IsFinite(const TickRecord& tick)
{
  bool finite = reference::IsFinite(tick.proxy);
  for (const VectorArray& entry : VectorArrays)
  {
    finite = finite && reference::IsFinite(tick.*entry.member);
  }
  for (const ScalarArray& entry : ScalarArrays)
  {
    finite = finite && std::isfinite(tick.*entry.member);
  }
  return finite;
}

// Not at the border, of which outside samples are made, nor next to it: see AZeroWeightIsNoSample.
vtkIdType InnerVoxel(Random& random, const Geometry& geometry)
{
  vtkIdType id = 0;
  for (int axis = 2; axis >= 0; --axis)
  {
    const int size = geometry.extent[2 * axis + 1] - geometry.extent[2 * axis] + 1;
    id = id * size + random.Integer(2, size - 3);
  }
  return id;
}
} // namespace

class NonFinite : public testing::TestWithParam<Estimator>
{
};

// The reference's sums turn NaN wherever a bad voxel takes part. There the gradient counts as 0,
// which the reference does too; the values are then not compared, only finite. Elsewhere nothing
// may change.
TEST_P(NonFinite, BadVoxelsAreFeltAsNothing)
{
  int touched = 0;
  int compared = 0;
  for (int seed = 0; seed < 30; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(9000 + seed);
    Scene scene;
    scene.estimator = this->GetParam();
    scene.kernelRadius = random.Integer(1, 3);
    const Geometry geometry = RandomGeometry(random, scene.kernelRadius);
    RandomVolume(scene, random, geometry, seed % 2 ? VTK_DOUBLE : VTK_FLOAT);
    RandomMaterial(scene, random, Curves::Linear);
    RandomWalk(scene, random, geometry, 150);
    vtkDataArray* scalars = FeltScalars(scene);
    for (int n = 0; n < 15; ++n)
    {
      const double bad[] = { NaN, Inf, -Inf };
      scalars->SetComponent(InnerVoxel(random, geometry), scene.component, bad[n % 3]);
    }
    const Trace actual = RunFilter(scene);
    const Trace expected = RunReference(scene, &actual, true);
    Trace expectedHere;
    Trace actualHere;
    for (std::size_t tick = 0; tick < actual.size(); ++tick)
    {
      EXPECT_TRUE(IsFinite(actual[tick])) << "tick " << tick;
      EXPECT_NEAR(actual[tick].gradientMagnitude, expected[tick].gradientMagnitude, 1e-6)
        << "tick " << tick;
      if (expected[tick].gradientMagnitude == 0.0)
      {
        EXPECT_EQ(actual[tick].surfaceStrength, 0.0) << "tick " << tick;
        ++touched;
      }
      if (IsFinite(expected[tick]))
      {
        expectedHere.push_back(expected[tick]);
        actualHere.push_back(actual[tick]);
        ++compared;
      }
    }
    const Difference difference = CompareTraces(expectedHere, actualHere);
    EXPECT_LE(difference.worst, 1e-9) << difference.text;
  }
  EXPECT_GT(touched, 100);
  EXPECT_GT(compared, 1000);
}

TEST_P(NonFinite, TheBorderValueStandsIn)
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
    EXPECT_GE(tick.value, 7.0); // a spline may blend it with the neighbours
    EXPECT_LE(tick.value, 100.0);
  }
}

// Outside, a trilinear value is that of the border alone, whatever its inner neighbour holds.
TEST_P(NonFinite, AZeroWeightIsNoSample)
{
  if (this->GetParam() == Estimator::CubicBSpline)
  {
    GTEST_SKIP() << "a spline's value at the border has its inner neighbour in it";
  }
  Scene scene;
  scene.estimator = this->GetParam();
  scene.image =
    Sample(Cube(8.0, 1.0), [](const Vec3& x) { return x[0] == 7.0 ? Inf : 10.0 * x[0]; });
  SetMaterial(scene, 500.0, 0.0, 0.0, 0.0);
  scene.path = { { { 9.0, 0.25, 0.5 } }, { { 8.5, 0.25, 0.5 } } };
  for (const TickRecord& tick : RunFilter(scene))
  {
    EXPECT_NEAR(tick.value, 80.0, 1e-9);
  }
}

TEST_P(NonFinite, NoNumberAtAllOrEnormousOnes)
{
  Random random(5);
  const double contents[] = { NaN, Inf, 1e308 };
  for (double content : contents)
  {
    Scene scene;
    scene.estimator = this->GetParam();
    const Geometry cube = Cube(8.0, 1.0);
    scene.image =
      Sample(cube, [&](const Vec3&) { return random.Chance(0.5) ? content : -content; });
    SetMaterial(scene, 500.0, 0.3, 0.2, 2.0);
    RandomWalk(scene, random, cube, 200);
    for (const TickRecord& tick : RunFilter(scene))
    {
      EXPECT_TRUE(reference::IsFinite(tick.force) && reference::IsFinite(tick.proxy));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, NonFinite, testing::ValuesIn(AllEstimators));
