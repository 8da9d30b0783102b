// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the border of a volume: values are clamped, the gradient is zero outside, and the strength
 * fades over one kernel radius.
 */

#include "Random.h"
#include "SampledImage.h"
#include "Scene.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace reference;

class Border : public testing::TestWithParam<Estimator>
{
protected:
  static constexpr double Half = 12.0; // half of the cube's side (mm, or voxels)

  static double Slope(const Vec3& x) { return 10.0 * x[0] + 4.0 * x[1] - 7.0 * x[2]; }

  static Vec3 OnAxis(int axis, double position)
  {
    Vec3 point = { { 0.25, -0.5, 0.125 } };
    point[axis] = position;
    return point;
  }

  void Begin(Scene& scene) const
  {
    scene.estimator = this->GetParam();
    scene.image = Sample(Cube(Half, 1.0), Slope);
  }
};

TEST_P(Border, StrengthFadesOverOneKernelRadius)
{
  Scene scene;
  this->Begin(scene);
  SetMaterial(scene, 500.0, 0.0, 0.0, 0.8);
  for (int radius : { 2, 3 })
  {
    scene.kernelRadius = radius;
    for (int axis = 0; axis < 3; ++axis)
    {
      scene.path = { OnAxis(axis, -Half - 2.0) };
      scene.MoveTo(OnAxis(axis, Half + 2.0), 0.05);
      const Trace trace = RunFilter(scene);
      for (std::size_t tick = 1; tick < trace.size(); ++tick)
      {
        const double depth = Half - std::abs(trace[tick - 1].proxy[axis]);
        const double fade = std::clamp(depth / radius, 0.0, 1.0);
        EXPECT_NEAR(trace[tick].surfaceStrength, 0.8 * fade, 1e-12);
        if (depth < 0.0)
        {
          EXPECT_EQ(trace[tick].gradientMagnitude, 0.0);
          EXPECT_LE(Norm(trace[tick].force), 1e-12);
        }
      }
    }
  }
}

// The force must not jump at the box: across the border, it must change no faster than the springs
// of the probe and the fade together allow.
TEST_P(Border, NothingPops)
{
  Scene scene;
  this->Begin(scene);
  // Over 2 mm, the fade acts as a spring of c = 400 N/m in series with k = 500 N/m, which is
  // stiffer inwards and softer outwards (k c / (k - c)). Without the fade, the force would jump by
  // 0.8 N.
  const double strength = 0.8;
  SetMaterial(scene, 500.0, 0.0, 0.0, strength);
  const double step = 0.01;
  const double most = 500.0 * 400.0 / (500.0 - 400.0) * 1e-3 * step;
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    scene.path = { OnAxis(axis, -Half - 3.0) };
    scene.MoveTo(OnAxis(axis, Half + 3.0), step);
    scene.MoveTo(OnAxis(axis, -Half - 3.0), step);
    const Trace trace = RunFilter(scene);
    for (std::size_t tick = 1; tick < trace.size(); ++tick)
    {
      EXPECT_LE(Norm(trace[tick].force - trace[tick - 1].force), 1.01 * most) << "tick " << tick;
      largest = std::max(largest, Norm(trace[tick].force));
    }
  }
  EXPECT_NEAR(largest, strength, 0.01 * strength);
}

// Values outside the volume must equal those of the nearest border point, even at x_s and x_v.
TEST_P(Border, ValuesClamp)
{
  Scene scene;
  this->Begin(scene);
  SetMaterial(scene, 500.0, 0.0, 0.0, 0.0);
  Random random(11);
  for (int n = 0; n < 300; ++n)
  {
    Vec3 inner; // point away from the spline's taps that repeat the border's voxels
    for (int axis = 0; axis < 3; ++axis)
    {
      inner[axis] = random.Uniform(-Half + 2.0, Half - 2.0);
    }
    const int axis = random.Integer(0, 2);
    Vec3 border = inner;
    border[axis] = random.Chance(0.5) ? Half : -Half;
    Vec3 outside = border;
    outside[axis] *= random.Uniform(1.01, 5.0);
    scene.path.push_back(border);
    scene.path.push_back(outside);
  }
  const Trace trace = RunFilter(scene);
  for (std::size_t tick = 1; tick < trace.size(); tick += 2)
  {
    EXPECT_NEAR(trace[tick].value, trace[tick - 1].value, 1e-10);
    if (this->GetParam() != Estimator::CubicBSpline)
    {
      EXPECT_NEAR(trace[tick - 1].value, Slope(trace[tick - 1].tip), 1e-10);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Border, testing::ValuesIn(AllEstimators));
