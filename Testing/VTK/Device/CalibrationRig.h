// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Fixture for a device with a known placement, and the points that it touches. */
#ifndef CalibrationRig_h
#define CalibrationRig_h

#include "Rigs/ApiRig.h"

#include <vtkHapticDevice.h>
#include <vtkMatrix4x4.h>
#include <vtkPoints.h>
#include <vtkTransform.h>

#include <random>

namespace calibrationtest
{
using namespace apitest;

class Calibration : public testing::Test
{
protected:
  Calibration()
  {
    this->Touched->SetDataTypeToDouble();
    this->Known->SetDataTypeToDouble();
  }

  double Draw(double size)
  {
    return std::uniform_real_distribution<double>(-size, size)(this->Random);
  }

  /// Sets a random placement with this scale (world units per metre).
  void Place(double scale)
  {
    this->Truth->Identity();
    this->Truth->Translate(this->Draw(300.0), this->Draw(300.0), this->Draw(300.0));
    this->Truth->RotateWXYZ(this->Draw(180.0), this->Draw(1.0), this->Draw(1.0), this->Draw(1.0));
    this->Truth->Scale(scale, scale, scale);
  }

  /// Touches random points within the reach of a device (m), with random errors of up to `error`
  /// (world units).
  void Touch(int points, double error = 0.0)
  {
    this->RemovePoints();
    for (int i = 0; i < points; ++i)
    {
      const Point device{ this->Draw(0.1), this->Draw(0.1), this->Draw(0.1) };
      Point world;
      this->Truth->TransformPoint(device.data(), world.data());
      world[i % 3] += error > 0.0 ? this->Draw(error) : 0.0;
      this->AddPoint(device, world);
    }
  }

  void RemovePoints()
  {
    this->Touched->Reset();
    this->Known->Reset();
    this->Pairs.clear();
  }

  void AddPoint(const Point& device, const Point& world)
  {
    this->Touched->InsertNextPoint(device.data());
    this->Known->InsertNextPoint(world.data());
    this->Pairs.emplace_back(device, world);
  }

  /// Fits the placement. Returns false if the points do not determine it.
  bool Compute()
  {
    this->Largest = this->Device->FitDeviceToWorld(this->Touched, this->Known, this->FixedScale);
    return this->Largest >= 0.0;
  }
  vtkMatrix4x4* GetDeviceToWorld() { return this->Device->GetDeviceToWorld(); }

  void ExpectError(const char* words)
  {
    EXPECT_FALSE(this->Compute());
    ASSERT_EQ(this->Log.Errors.size(), 1U);
    EXPECT_NE(this->Log.Errors[0].find(words), std::string::npos) << this->Log.Errors[0];
    this->Log.Errors.clear();
  }

  void AddPoints(const std::vector<Point>& points)
  {
    this->RemovePoints();
    for (const Point& x : points)
    {
      this->AddPoint(x, x);
    }
  }

  std::mt19937 Random{ 5 };
  vtkNew<vtkTransform> Truth;
  std::vector<std::pair<Point, Point>> Pairs;
  vtkNew<vtkPoints> Touched;
  vtkNew<vtkPoints> Known;
  double FixedScale = 0.0;
  double Largest = 0.0;
  vtkNew<vtkHapticDevice> Device;
  MessageLog Log{ this->Device };
};
} // namespace calibrationtest

#endif
