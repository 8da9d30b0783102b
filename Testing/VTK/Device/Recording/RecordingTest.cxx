// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that the filter's trace of a recording on its second port is bitwise identical to the
 * recording.
 */

#include "Rigs/RecordingRig.h"

using namespace devicetest;

TEST_F(Recording, GivesTheSameTraceAndSaysWhatItIs)
{
  this->Begin();
  this->StartRecording();
  this->Wander(60);
  this->ExpectSame();
  for (const char* name : { "DeviceId", "Settings", "Units", "VolumeHash" })
  {
    EXPECT_TRUE(this->Recorded->GetFieldData()->GetAbstractArray(name)) << name;
  }
}

TEST_F(Recording, MayBeginInContactWithADeviceThatIsMovedAndArmed)
{
  this->Begin();
  this->Device->Arm();
  this->Wander(30);
  this->StartRecording();
  for (int i = 0; i < 12; ++i)
  {
    this->Wander(4);
    this->Turn(7.0 * i, 0.3 * i);
  }
  this->ExpectSame();
}

TEST_F(Recording, HoldsThatTheProxyBeginsAtTheTipWhenItIsArmed)
{
  this->Begin();
  this->Wander(30);
  this->StartRecording();
  this->Wander(10);
  ASSERT_TRUE(this->Lead(7.0, 7.0, 9.0));
  this->Device->Arm();
  ASSERT_TRUE(this->WaitTicks(10));
  EXPECT_EQ(Length(this->Device->GetState()->GetComputedForce()), 0.0);
  this->Wander(60);
  this->ExpectSame();
  vtkPointData* const points = this->Recorded->GetPointData();
  vtkDataArray* const armed = points->GetArray("Armed");
  vtkIdType first = 0;
  while (first < armed->GetNumberOfTuples() && armed->GetComponent(first, 0) == 0.0)
  {
    ++first;
  }
  ASSERT_GT(first, 0);
  ASSERT_LT(first, armed->GetNumberOfTuples());
  EXPECT_GT(Length(points->GetArray("Force")->GetTuple3(first - 1)), 0.0);
  EXPECT_EQ(points->GetArray("Enabled")->GetComponent(first, 0), 1.0);
  EXPECT_EQ(Length(points->GetArray("Force")->GetTuple3(first)), 0.0);
}

TEST_F(Recording, MayBeInterrupted)
{
  this->Begin();
  this->Wander(30);
  this->StartRecording();
  this->Wander(10);
  this->Device->SetVolumeHaptics(nullptr);
  ASSERT_TRUE(this->Device->Publish());
  this->Wander(10);
  this->Device->SetVolumeHaptics(this->Filter);
  ASSERT_TRUE(this->Device->Publish());
  this->Wander(60);
  this->ExpectSame();
}

TEST_F(Recording, OfAForceFieldWithDamping)
{
  this->Filter->SetMethodToForceField();
  this->Filter->SetForceFieldGain(0.01);
  this->Filter->SetForceFieldDamping(2.0);
  this->Begin();
  this->Wander(20);
  this->StartRecording();
  this->Wander(20);
  this->Turn(30.0, 1.0);
  this->Wander(20);
  this->ExpectSame();
}

TEST_F(Recording, OfALocalSurfaceSaysWhenTheSlowLoopAnswered)
{
  this->Filter->SetMethodToLocalSurface();
  this->Filter->SetLocalSurfaceShapeToQuadric();
  this->Filter->SetIsoValue(700.0);
  this->Begin();
  this->Wander(30);
  this->StartRecording();
  for (int i = 0; i < 8; ++i)
  {
    this->Wander(8);
    this->Turn(7.0 * i, 0.3 * i);
  }
  this->ExpectSame();
  vtkDataArray* const renewed = this->Recorded->GetPointData()->GetArray("Renewed");
  vtkIdType count = 0;
  for (vtkIdType i = 0; i < renewed->GetNumberOfTuples(); ++i)
  {
    count += renewed->GetComponent(i, 0) != 0.0 ? 1 : 0;
  }
  EXPECT_GT(count, 2);
}

TEST_F(Recording, KnowsTheRateOfTheDevice)
{
  this->Filter->SetMethodToForceField();
  this->Filter->SetForceFieldGain(0.01);
  this->Filter->SetForceFieldDamping(2.0);
  this->Device->SetServoRate(2000.0);
  this->Begin();
  this->StartRecording();
  this->Wander(40);
  this->ExpectSame();
}

TEST_F(Recording, GoesOnAfterAFault)
{
  this->BeginFast();
  this->StartRecording();
  this->Wander(20);
  this->Device->GetVirtualHand()->SetPosition(7.0, 600.0, 5.0);
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetStatus() == vtkHapticDevice::FAULT; }));
  this->Device->GetVirtualHand()->SetPosition(7.0, 7.0, 7.0);
  ASSERT_TRUE(this->WaitTicks(500));
  this->Device->Arm();
  this->Wander(30);
  this->ExpectSame();
  vtkDataArray* const enabled = this->Recorded->GetPointData()->GetArray("Enabled");
  EXPECT_EQ(enabled->GetRange()[1], 1.0) << "the re-entry is in the recording";
  vtkPointData* const points = this->Recorded->GetPointData();
  vtkDataArray* const share = points->GetArray("Share");
  for (vtkIdType i = 0; i < share->GetNumberOfTuples(); ++i)
  {
    const double fault = points->GetArray("Fault")->GetComponent(i, 0);
    const double reason = points->GetArray("Reason")->GetComponent(i, 0);
    const double passes = share->GetComponent(i, 0);
    // Reason 2 is OverSpeed, and reason 10 is Rising.
    ASSERT_EQ(reason, fault != 0.0 ? 2.0 : passes < 1.0 ? 10.0 : 0.0) << i;
    ASSERT_TRUE(fault == 0.0 || passes == 0.0) << i;
  }
  EXPECT_GT(share->GetRange()[1], 0.01) << "the ramp is in the recording";
}

TEST_F(Recording, NeedsSomethingToBeFelt)
{
  this->Device->SetVolumeHaptics(nullptr);
  this->Begin();
  EXPECT_FALSE(this->Device->GetRecorder()->Start(this->Name.c_str()));
  this->ExpectError("SetVolumeHaptics() a filter first");
}
