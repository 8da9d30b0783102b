// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests that samples that are NaN or infinite have no effect, and never reach a force. */

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

// Returns a random voxel that is at least one voxel away from the border. Border voxels also
// determine the samples outside: see NonFiniteValues.AZeroWeightIsNoSample.
vtkIdType InnerVoxel(Random& random, const Geometry& geometry)
{
  vtkIdType id = 0;
  for (int axis = 2; axis >= 0; --axis)
  {
    const int size = geometry.extent[2 * axis + 1] - geometry.extent[2 * axis] + 1;
    id = id * size + random.Integer(3, size - 4);
  }
  return id;
}
} // namespace

class NonFinite : public testing::TestWithParam<Estimator>
{
};

// The reference's sums become NaN where an invalid voxel contributes. There, the gradient must
// count as 0, also in the reference, and values only have to be finite. Elsewhere, the voxel must
// have no effect.
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

INSTANTIATE_TEST_SUITE_P(All, NonFinite, testing::ValuesIn(AllEstimators));
