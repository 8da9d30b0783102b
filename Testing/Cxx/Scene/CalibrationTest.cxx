// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A known placement of the device is found from points that it touched.
 */

#include "../Device/DeviceRig.h"

#include <vtkHapticCalibration.h>
#include <vtkMath.h>
#include <vtkTransform.h>

#include <limits>
#include <random>

using namespace apitest;

namespace
{
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
} // namespace

TEST_F(Calibration, FindsAPlacementExactly)
{
  for (int trial = 0; trial < 60; ++trial)
  {
    const int points[] = { 3, 4, 10 };
    const double scale = trial % 2 ? 1000.0 : 750.0;
    this->Place(scale);
    do
    {
      this->Touch(points[trial % 3]);
      this->Calibrator->SetFixedScale(trial % 4 ? 0.0 : scale);
    } while (!this->Calibrator->Compute()); // a needle of a triangle
    for (int i = 0; i < 16; ++i)
    {
      EXPECT_NEAR(this->Calibrator->GetDeviceToWorld()->GetData()[i],
        this->Truth->GetMatrix()->GetData()[i], 1e-9 * scale)
        << "trial " << trial << " element " << i;
    }
    EXPECT_LT(this->Calibrator->GetResidual(), 1e-9 * scale);
    EXPECT_LT(this->Calibrator->GetLargestResidual(), 1e-9 * scale);
  }
}

TEST_F(Calibration, ResidualIsThatOfTheMatrix)
{
  for (const double fixed : { 0.0, 990.0 })
  {
    this->Place(1000.0);
    this->Touch(10, 2.0);
    this->Calibrator->SetFixedScale(fixed);
    ASSERT_TRUE(this->Calibrator->Compute());
    double sum2 = 0.0;
    double largest = 0.0;
    for (const auto& [device, world] : this->Pairs)
    {
      const double x[4] = { device[0], device[1], device[2], 1.0 };
      double y[4];
      this->Calibrator->GetDeviceToWorld()->MultiplyPoint(x, y);
      const double distance = std::hypot(y[0] - world[0], y[1] - world[1], y[2] - world[2]);
      sum2 += distance * distance;
      largest = std::max(largest, distance);
    }
    EXPECT_NEAR(this->Calibrator->GetResidual(), std::sqrt(sum2 / 10.0), 1e-9);
    EXPECT_NEAR(this->Calibrator->GetLargestResidual(), largest, 1e-9);
    EXPECT_GT(largest, 0.1);
    EXPECT_LT(this->Calibrator->GetResidual(), 4.0);
    const double scale = std::cbrt(this->Calibrator->GetDeviceToWorld()->Determinant());
    EXPECT_NEAR(scale, fixed > 0.0 ? fixed : 1000.0, fixed > 0.0 ? 1e-9 : 30.0);
  }
}

TEST_F(Calibration, NeverMirrors)
{
  // Only one mirror image fits perfectly; the best motion does not.
  const Point device[] = { { 0.0, 0.0, 0.0 }, { 0.1, 0.0, 0.0 }, { 0.0, 0.08, 0.0 },
    { 0.0, 0.0, 0.06 } };
  for (const Point& x : device)
  {
    const Point world{ -1000.0 * x[0], 1000.0 * x[1], 1000.0 * x[2] };
    this->Calibrator->AddPoint(x.data(), world.data());
  }
  ASSERT_TRUE(this->Calibrator->Compute());
  EXPECT_GT(this->Calibrator->GetDeviceToWorld()->Determinant(), 0.0);
  EXPECT_GT(this->Calibrator->GetResidual(), 10.0);
}

TEST_F(Calibration, ADeviceTakesTheMatrix)
{
  this->Place(1000.0);
  this->Touch(6, 3.0);
  ASSERT_TRUE(this->Calibrator->Compute());
  vtkNew<vtkVolumeHapticsFilter> filter;
  const vtkSmartPointer<vtkImageData> image = MakeRamp();
  filter->SetInputData(image);
  vtkNew<vtkHapticDevice> device;
  MessageLog deviceLog(device);
  device->SetVolumeHaptics(filter);
  device->SetDeviceToWorld(this->Calibrator->GetDeviceToWorld());
  EXPECT_TRUE(device->Publish());
  EXPECT_TRUE(deviceLog.Errors.empty());
}

TEST_F(Calibration, PointsThatDoNotSay)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  this->Place(1000.0);
  this->Touch(5);
  ASSERT_TRUE(this->Calibrator->Compute());
  vtkNew<vtkMatrix4x4> before;
  before->DeepCopy(this->Calibrator->GetDeviceToWorld());

  this->AddPoints({ { 0, 0, 0 }, { 1, 0, 0 } });
  EXPECT_EQ(this->Calibrator->GetNumberOfPoints(), 2);
  this->ExpectError("three or more");
  this->AddPoints({ { 5, 5, 5 }, { 5, 5, 5 }, { 5, 5, 5 } });
  this->ExpectError("one place");
  this->AddPoints({ { 0, 0, 0 }, { 1, 1, 0 }, { 2, 2, 0.01 }, { 3, 3, 0 } });
  this->ExpectError("one line");
  this->AddPoints({ { 0, 0, 0 }, { 1, nan, 0 }, { 0, 2, 0 } });
  this->ExpectError("Point 1 of the device is not finite");
  this->AddPoints({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 2, 0 } });
  this->Calibrator->SetFixedScale(nan);
  this->ExpectError("FixedScale");
  this->Calibrator->SetFixedScale(0.0);

  // Good in the one space, bad in the other.
  this->Calibrator->RemoveAllPoints();
  for (int i = 0; i < 3; ++i)
  {
    const Point device{ 0.1 * i, 0.1 * i * i, 0.0 };
    const Point world{ 100.0 * i, 0.0, 0.0 };
    this->Calibrator->AddPoint(device.data(), world.data());
  }
  this->ExpectError("of the world lie on one line");
  for (int i = 0; i < 16; ++i)
  {
    EXPECT_EQ(this->Calibrator->GetDeviceToWorld()->GetData()[i], before->GetData()[i]);
  }
}
