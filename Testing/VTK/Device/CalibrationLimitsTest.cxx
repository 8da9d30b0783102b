// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Points that say nothing of a placement, or of none that a device could have.
 */

#include "CalibrationRig.h"

#include <vtkHapticDevice.h>

#include <limits>

using namespace calibrationtest;

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
