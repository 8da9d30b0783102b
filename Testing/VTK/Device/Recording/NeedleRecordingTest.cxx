// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a needle in the hand. Recordings must replay bitwise, with and without an orientation, and
 * also if they begin with the needle in tissue. The tool may change under force.
 */

#include "Rigs/RecordingRig.h"

#include <vtkFieldData.h>
#include <vtkHapticNeedle.h>
#include <vtkPiecewiseFunction.h>

using namespace devicetest;

namespace
{
class NeedleRecording : public Recording
{
protected:
  NeedleRecording()
  {
    this->Needle->GetShaftFriction()->AddPoint(500.0, 0.0);
    this->Needle->GetShaftFriction()->AddPoint(501.0, 30.0);
    this->Needle->GetCuttingForce()->AddPoint(500.0, 0.0);
    this->Needle->GetCuttingForce()->AddPoint(501.0, 0.2);
    SetConstant(this->Filter->GetProperty()->GetSurfaceStrength(), 0.0);
    this->Filter->SetTool(this->Needle);
  }

  double ComputeDepth()
  {
    this->Device->GetState()->GetNeedleTrack(this->Track);
    return this->Track->GetFieldData()->GetArray("Depth")->GetComponent(0, 0);
  }

  vtkNew<vtkHapticNeedle> Needle;
  vtkNew<vtkPolyData> Track;
};
} // namespace

TEST_F(NeedleRecording, ReplaysToTheBit)
{
  this->Begin();
  ASSERT_TRUE(this->Lead(7.0, 7.0, 4.0));
  ASSERT_TRUE(this->Lead(7.0, 7.0, 9.0));
  ASSERT_TRUE(this->Wait([this] { return this->ComputeDepth() > 1.0; }));
  this->StartRecording();
  this->Wander(30);
  this->Turn(30.0, 1.0);
  this->Wander(20);
  this->ExpectSame(0.15);
}

TEST_F(NeedleRecording, ReplaysWithItsOrientationToTheBit)
{
  this->Device->GetVirtualHand()->SetOrientation(0.0, 1.0, 0.0, 0.0);
  this->Begin();
  this->StartRecording();
  ASSERT_TRUE(this->Lead(7.0, 7.0, 4.0));
  ASSERT_TRUE(this->Lead(7.0, 7.0, 9.0));
  for (int i = 0; i < 20; ++i)
  {
    const double a = 0.02 * i;
    this->Device->GetVirtualHand()->SetOrientation(std::sin(a), std::cos(a), 0.0, 0.0);
    this->Wander(1);
  }
  this->Device->GetVirtualHand()->SetOrientation(0.0, 0.0, 0.0, 0.0);
  this->Wander(10);
  this->ExpectSame(0.15);
}

TEST_F(NeedleRecording, TheToolMayChangeUnderForce)
{
  this->Begin();
  ASSERT_TRUE(this->ArmFully());
  ASSERT_TRUE(this->Lead(7.0, 7.0, 4.0));
  ASSERT_TRUE(this->Lead(7.0, 7.0, 9.0));
  ASSERT_TRUE(this->Wait([this] { return this->ComputeDepth() > 1.0; }));
  EXPECT_GT(Length(this->Device->GetState()->GetForce()), 0.15);
  this->Filter->SetTool(nullptr);
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->Wait([this] { return this->ComputeDepth() == 0.0; }));
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::ACTIVE) << this->Device->GetStatusText();
  this->Filter->SetTool(this->Needle);
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->Lead(7.0, 7.0, 4.0)); // starts in front of the tissue
  ASSERT_TRUE(this->Lead(7.0, 7.0, 11.0));
  ASSERT_TRUE(this->Wait([this] { return this->ComputeDepth() > 0.5; }));
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::ACTIVE) << this->Device->GetStatusText();
}
