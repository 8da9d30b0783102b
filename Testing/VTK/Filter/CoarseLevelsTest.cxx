// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests 8-bit ramps with so few grey levels per voxel that rounding dominates their gradients. The
 * force may feel rough, but no tick may change it by 0.25 N, which a hand would perceive as a
 * knock.
 */

#include "Rigs/ApiRig.h"

#include <algorithm>
#include <cmath>
#include <string>

using namespace apitest;

namespace
{
class CoarseLevels : public ApiTest
{
};

constexpr double Slope[3] = { 0.3, 0.2, 0.933 }; // unit vector, direction of the ramp

/// Makes a path that presses in by 3 voxels along the slope, and then slides about 8 voxels across
/// it.
std::vector<Point> PressAndSlide()
{
  const double middle = 24.0;
  std::vector<Point> path =
    Line({ middle - 3.0 * Slope[0], middle - 3.0 * Slope[1], middle - 3.0 * Slope[2] },
      { middle + 3.0 * Slope[0], middle + 3.0 * Slope[1], middle + 3.0 * Slope[2] }, 400);
  const Point last = path.back();
  const std::vector<Point> slide =
    Line(last, { last[0] + 8.0 * Slope[2], last[1], last[2] - 8.0 * Slope[0] }, 800);
  path.insert(path.end(), slide.begin(), slide.end());
  return path;
}
} // namespace

TEST_F(CoarseLevels, MakeNoSteps)
{
  this->Filter->SetPathData(MakePath(PressAndSlide()));
  const int estimators[] = { vtkVolumeHapticsFilter::CENTRAL_DIFFERENCE,
    vtkVolumeHapticsFilter::GAUSSIAN, vtkVolumeHapticsFilter::CUBIC_BSPLINE };
  for (const double levels : { 0.2, 0.5, 1.0, 2.0 })
  {
    this->Image = MakeImage(49, VTK_UNSIGNED_CHAR,
      [levels](const Point& p) {
        return std::round(60.0 + levels * (Slope[0] * p[0] + Slope[1] * p[1] + Slope[2] * p[2]));
      });
    this->Filter->SetInputDataObject(0, this->Image);
    for (const char* const preset : { "", "Micro-CT" })
    {
      *preset ? void(this->Property->ApplyPreset(preset))
              : void(this->Property->DeepCopy(vtkNew<vtkHapticProperty>()));
      for (const int estimator : estimators)
      {
        this->Filter->SetGradientEstimator(estimator);
        this->Filter->Update();
        vtkPolyData* const trace = this->Filter->GetOutput();
        double most = 0.0;
        double force = 0.0;
        for (vtkIdType tick = 1; tick < trace->GetNumberOfPoints(); ++tick)
        {
          double step = 0.0;
          double now = 0.0;
          for (int axis = 0; axis < 3; ++axis)
          {
            const double f = Get(trace, "Force", tick, axis);
            step = std::hypot(step, f - Get(trace, "Force", tick - 1, axis));
            now = std::hypot(now, f);
          }
          most = std::max(most, step);
          force = std::max(force, now);
        }
        EXPECT_LT(most, 0.25) << levels << " levels to a voxel, estimator " << estimator
                              << ", preset " << preset;
        EXPECT_GT(force, 0.5) << "something is felt";
      }
    }
  }
}
