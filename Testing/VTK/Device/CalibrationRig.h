// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A device at a known place, and points that it touches.
 */
#ifndef CalibrationRig_h
#define CalibrationRig_h

#include "Rigs/ApiRig.h"

#include <vtkHapticCalibration.h>
#include <vtkMatrix4x4.h>
#include <vtkTransform.h>

#include <random>

namespace calibrationtest
{
using namespace apitest;

class Calibration : public testing::Test
{
protected:
  double Draw(double size)
  {
    return std::uniform_real_distribution<double>(-size, size)(this->Random);
  }

  /// A placement that no axis or unit is special to.
  void Place(double scale)
  {
    this->Truth->Identity();
    this->Truth->Translate(this->Draw(300.0), this->Draw(300.0), this->Draw(300.0));
    this->Truth->RotateWXYZ(this->Draw(180.0), this->Draw(1.0), this->Draw(1.0), this->Draw(1.0));
    this->Truth->Scale(scale, scale, scale);
  }

  /// Points in the reach of a device (m), with an error in the world (world units).
  void Touch(int points, double error = 0.0)
  {
    this->Calibrator->RemoveAllPoints();
    this->Pairs.clear();
    for (int i = 0; i < points; ++i)
    {
      const Point device{ this->Draw(0.1), this->Draw(0.1), this->Draw(0.1) };
      Point world;
      this->Truth->TransformPoint(device.data(), world.data());
      world[i % 3] += error > 0.0 ? this->Draw(error) : 0.0;
      this->Calibrator->AddPoint(device.data(), world.data());
      this->Pairs.emplace_back(device, world);
    }
  }

  void ExpectError(const char* words)
  {
    EXPECT_FALSE(this->Calibrator->Compute());
    ASSERT_EQ(this->Log.Errors.size(), 1U);
    EXPECT_NE(this->Log.Errors[0].find(words), std::string::npos) << this->Log.Errors[0];
    this->Log.Errors.clear();
  }

  void AddPoints(const std::vector<Point>& points)
  {
    this->Calibrator->RemoveAllPoints();
    for (const Point& x : points)
    {
      this->Calibrator->AddPoint(x.data(), x.data());
    }
  }

  std::mt19937 Random{ 5 };
  vtkNew<vtkTransform> Truth;
  std::vector<std::pair<Point, Point>> Pairs;
  vtkNew<vtkHapticCalibration> Calibrator;
  MessageLog Log{ this->Calibrator };
};
} // namespace calibrationtest

#endif
