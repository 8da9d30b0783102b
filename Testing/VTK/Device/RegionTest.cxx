// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a device on a region of a volume: its report of missing data, and the fading of its force.
 */

#include "Rigs/DeviceRig.h"

#include <vtkDataArray.h>
#include <vtkHapticRegionFilter.h>
#include <vtkTable.h>

#include <algorithm>

using namespace devicetest;

namespace
{
class Region : public DeviceTest
{
protected:
  Region()
  {
    this->Crop->SetInputData(MakeRamp(48));
    this->Crop->SetRegion(0, 47, 0, 47, 0, 30);
    this->Filter->SetInputConnection(0, this->Crop->GetOutputPort());
  }
  /// Arms the device, and presses into the ramp well inside the region.
  void Press()
  {
    this->Begin();
    ASSERT_TRUE(this->ArmFully());
    ASSERT_TRUE(this->Lead(20.0, 20.0, 8.0));
    ASSERT_TRUE(this->Lead(20.0, 20.0, 13.0));
    ASSERT_TRUE(this->Wait([&] { return Length(this->Device->GetState()->GetForce()) > 0.5; }));
  }
  bool Says(const char* words)
  {
    return this->Device->GetStatusText().find(words) != std::string::npos;
  }

  vtkNew<vtkHapticRegionFilter> Crop;
};
} // namespace

TEST_F(Region, SaysThatDataAreAwaitedAndGoesOnWhenTheyCome)
{
  vtkNew<vtkTable> table;
  this->Press();
  this->Device->GetState()->Drain(table);
  EXPECT_EQ(this->Device->GetState()->GetResidency(), 1.0);
  EXPECT_EQ(this->Device->GetAbsentTicks(), 0);
  EXPECT_FALSE(this->Says("Waiting for the data"));
  ASSERT_TRUE(this->Lead(20.0, 20.0, 40.0));
  ASSERT_TRUE(this->Wait([&] { return this->Device->GetState()->GetResidency() == 0.0; }));
  EXPECT_TRUE(this->Says("Waiting for the data")) << this->Device->GetStatusText();
  EXPECT_GT(this->Device->GetAbsentTicks(), 0);
  ASSERT_TRUE(this->Wait([&] { return Length(this->Device->GetState()->GetForce()) == 0.0; }));
  EXPECT_NEAR(this->Device->GetState()->GetProxyPosition()[2], 40.0, 1e-6);
  this->Crop->SetRegion(0, 47, 0, 47, 20, 47);
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->Wait([&] { return this->Device->GetState()->GetResidency() == 1.0; }));
  EXPECT_FALSE(this->Says("Waiting for the data"));
  this->Device->ResetStatistics();
  ASSERT_TRUE(this->WaitTicks(3));
  EXPECT_EQ(this->Device->GetAbsentTicks(), 0);
  // The residency must fall and rise in small steps.
  this->Device->GetState()->Drain(table);
  auto* const residency = vtkDataArray::SafeDownCast(table->GetColumnByName("Residency"));
  ASSERT_TRUE(residency && residency->GetNumberOfTuples() > 50);
  double least = 1.0;
  for (vtkIdType i = 1; i < residency->GetNumberOfTuples(); ++i)
  {
    const double now = residency->GetComponent(i, 0);
    EXPECT_LE(std::abs(now - residency->GetComponent(i - 1, 0)), 0.02 * (1.0 + 1e-9));
    least = std::min(least, now);
  }
  EXPECT_EQ(least, 0.0);
}

TEST_F(Region, IsNotRecorded)
{
  this->Press();
  EXPECT_FALSE(this->Device->GetRecorder()->Start(this->File("Region.vtp").c_str()));
  this->ExpectError("region of a larger volume can't be recorded");
  this->Filter->SetInputData(0, this->Image);
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->Device->GetRecorder()->Start(this->File("Region.vtp").c_str()));
  this->Filter->SetInputConnection(0, this->Crop->GetOutputPort());
  EXPECT_FALSE(this->Device->Publish()) << "no region during a recording";
  this->ExpectError("Stop() the recorder first");
  EXPECT_TRUE(this->Device->GetRecorder()->Stop());
  EXPECT_TRUE(this->Device->Publish());
}

TEST_F(Region, FadesOutAndDisarms)
{
  vtkNew<vtkTable> table;
  this->Device->FadeOut(); // the servo does not run yet
  this->Press();
  this->Device->GetState()->Drain(table);
  this->Device->FadeOut();
  ASSERT_TRUE(this->Wait([&] { return this->Device->GetStatus() == vtkHapticDevice::READY; }));
  EXPECT_EQ(Length(this->Device->GetState()->GetForce()), 0.0);
  this->Device->GetState()->Drain(table);
  vtkDataArray* const armed = vtkDataArray::SafeDownCast(table->GetColumnByName("Armed"));
  vtkDataArray* const residency = vtkDataArray::SafeDownCast(table->GetColumnByName("Residency"));
  int falling = 0;
  for (vtkIdType i = 0; i < armed->GetNumberOfTuples(); ++i)
  {
    falling += armed->GetComponent(i, 0) == 1.0 && residency->GetComponent(i, 0) < 1.0;
  }
  EXPECT_EQ(falling, 49) << "of 50 ticks, the last of which disarms";
  EXPECT_EQ(this->Device->GetAbsentTicks(), 0) << "the data were there";
  this->Device->FadeOut(); // the device is disarmed
  ASSERT_TRUE(this->ArmFully());
  EXPECT_EQ(this->Device->GetState()->GetResidency(), 1.0);
  ASSERT_TRUE(this->Lead(20.0, 20.0, 16.0));
  EXPECT_TRUE(this->WaitForce());
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::ACTIVE);
}
