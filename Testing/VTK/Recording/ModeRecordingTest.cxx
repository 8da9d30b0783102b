// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Modes that a hand feels on a device: recordings replay to the bit, and a mode that comes while
 * the hand is off its place comes softly.
 */

#include "Rigs/RecordingRig.h"

#include <vtkDoubleArray.h>
#include <vtkHapticSurfaceMode.h>
#include <vtkHapticVectorFollowMode.h>
#include <vtkHapticVectorFrontMode.h>

using namespace devicetest;

namespace
{
class ModeRecording : public Recording
{
protected:
  ModeRecording()
  {
    vtkNew<vtkDoubleArray> flow;
    flow->SetName("flow");
    flow->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < this->Image->GetNumberOfPoints(); ++i)
    {
      double p[3];
      this->Image->GetPoint(i, p);
      flow->InsertNextTuple3(7.0 - p[1], p[0] - 7.0, 0.3 * p[2]);
    }
    this->Image->GetPointData()->AddArray(flow);
    this->Follow->SetArrayName("flow");
    this->Front->SetArrayName("flow");
    this->Follow->GetStrength()->AddPoint(0.0, 0.0);
    this->Follow->GetStrength()->AddPoint(3.0, 1.5);
    this->Filter->AddMode(this->Follow);
    this->Filter->SetMethodToPrimitives();
  }

  vtkNew<vtkHapticVectorFollowMode> Follow;
  vtkNew<vtkHapticVectorFrontMode> Front;
};
} // namespace

TEST_F(ModeRecording, ReplaysToTheBit)
{
  vtkNew<vtkHapticSurfaceMode> surface;
  this->Front->TwoSidedOn();
  SetConstant(this->Front->GetStrength(), 0.3);
  SetConstant(this->Filter->GetProperty()->GetSurfaceStrength(), 0.6);
  this->Filter->AddMode(this->Front);
  this->Filter->AddMode(surface);
  this->Begin();
  this->Wander(10); // so that forces and rate are something when the recording begins
  this->StartRecording();
  this->Wander(20);
  this->Turn(30.0, 1.0);
  this->Wander(20);
  this->ExpectSame();
}

TEST_F(ModeRecording, AModeThatComesUnderTheHandComesSoftly)
{
  // A spring to a line that the hand left 3 mm ago would be 1.5 N at once.
  this->Filter->RemoveAllModes();
  SetConstant(this->Front->GetStrength(), 3.0);
  this->Front->TwoSidedOn();
  this->Front->ActiveOff();
  this->Filter->AddMode(this->Front);
  SetConstant(this->Follow->GetStrength(), 3.0);
  this->Filter->AddMode(this->Follow);
  this->Begin();
  ASSERT_TRUE(this->ArmFully());
  ASSERT_TRUE(this->Lead(9.0, 7.0, 5.0));
  const double held = Length(this->Device->GetForce());
  EXPECT_GT(held, 0.3);
  // The line goes: the hand is free, and force rises anew when another mode comes.
  this->Follow->ActiveOff();
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->Wait([this] { return Length(this->Device->GetForce()) < 1e-6; }));
  ASSERT_TRUE(this->Lead(10.0, 7.0, 5.0));
  this->Front->ActiveOn();
  this->Follow->ActiveOn();
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->Lead(10.0, 9.0, 5.0));
  ASSERT_TRUE(this->Wait([this] { return Length(this->Device->GetForce()) > 0.3; }));
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::ACTIVE) << this->Device->GetStatusText();
}
