// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests points that do not determine a placement, or only one that is impossible for a device. */

#include "CalibrationRig.h"

#include <limits>

using namespace calibrationtest;

TEST_F(Calibration, NeverMirrors)
{
  // A mirror image fits these points exactly, whereas the best rigid motion does not.
  const Point device[] = { { 0.0, 0.0, 0.0 }, { 0.1, 0.0, 0.0 }, { 0.0, 0.08, 0.0 },
    { 0.0, 0.0, 0.06 } };
  for (const Point& x : device)
  {
    const Point world{ -1000.0 * x[0], 1000.0 * x[1], 1000.0 * x[2] };
    this->AddPoint(x, world);
  }
  ASSERT_TRUE(this->Compute());
  EXPECT_GT(this->GetDeviceToWorld()->Determinant(), 0.0);
  EXPECT_GT(this->Largest, 10.0);
}

TEST_F(Calibration, ADeviceCanPublishTheMatrix)
{
  this->Place(1000.0);
  this->Touch(6, 3.0);
  ASSERT_TRUE(this->Compute());
  vtkNew<vtkVolumeHapticsFilter> filter;
  const vtkSmartPointer<vtkImageData> image = MakeRamp();
  filter->SetInputData(image);
  this->Device->SetVolumeHaptics(filter);
  EXPECT_TRUE(this->Device->Publish());
  EXPECT_TRUE(this->Log.Errors.empty());
}

TEST_F(Calibration, PointsThatDoNotSay)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  this->Place(1000.0);
  this->Touch(5);
  ASSERT_TRUE(this->Compute());
  vtkNew<vtkMatrix4x4> before;
  before->DeepCopy(this->GetDeviceToWorld());

  this->AddPoints({ { 0, 0, 0 }, { 1, 0, 0 } });
  this->ExpectError("three or more");
  this->AddPoints({ { 5, 5, 5 }, { 5, 5, 5 }, { 5, 5, 5 } });
  this->ExpectError("one place");
  this->AddPoints({ { 0, 0, 0 }, { 1, 1, 0 }, { 2, 2, 0.01 }, { 3, 3, 0 } });
  this->ExpectError("one line");
  this->AddPoints({ { 0, 0, 0 }, { 1, nan, 0 }, { 0, 2, 0 } });
  this->ExpectError("Point 1 of the device is not finite");
  this->AddPoints({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 2, 0 } });
  this->FixedScale = nan;
  this->ExpectError("scale");
  this->FixedScale = 0.0;
  this->Known->InsertNextPoint(1.0, 2.0, 3.0);
  this->ExpectError("3 touched points and 4 known ones");

  // The touched points are good, but the known points lie on a line.
  this->RemovePoints();
  for (int i = 0; i < 3; ++i)
  {
    const Point device{ 0.1 * i, 0.1 * i * i, 0.0 };
    const Point world{ 100.0 * i, 0.0, 0.0 };
    this->AddPoint(device, world);
  }
  this->ExpectError("of the world lie on one line");
  for (int i = 0; i < 16; ++i)
  {
    EXPECT_EQ(this->GetDeviceToWorld()->GetData()[i], before->GetData()[i]);
  }
}
