// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a shaped tool in the hand. Force and torque must reach the device, and recordings replay
 * bitwise, even if they begin in contact. The tool may change under force.
 */

#include "Rigs/RecordingRig.h"

#include <vtkFieldData.h>
#include <vtkHapticNeedle.h>
#include <vtkHapticPointShell.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlaneSource.h>
#include <vtkSphereSource.h>

#include <cmath>

using namespace devicetest;

namespace
{
class ShellRecording : public Recording
{
protected:
  ShellRecording()
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(2.0);
    // the hand is off the ball's centre, so that the ball rotates
    sphere->SetCenter(1.5, 0.0, 0.0);
    sphere->SetThetaResolution(40);
    sphere->SetPhiResolution(20);
    sphere->Update();
    this->Tool->SetMesh(sphere->GetOutput());
    this->Tool->SetNumberOfPoints(400);
    this->Tool->SetSolidToAbove();
    this->Tool->SetContactValue(800.0);
    this->Filter->SetTool(this->Tool);
  }

  /// Starts the servo, and waits until a worker has distributed the points of the tool.
  void Begin()
  {
    Recording::Begin();
    ASSERT_TRUE(this->Wait([this] { return this->Device->IsPublished(); }));
  }
  bool IsSpreading()
  {
    return this->Device->GetStatusText().find("the points of the tool are spread") !=
      std::string::npos;
  }
  void TurnTool(double angle)
  {
    this->Device->GetVirtualHand()->SetOrientation(
      std::cos(0.5 * angle), 0.6 * std::sin(0.5 * angle), 0.8 * std::sin(0.5 * angle), 0.0);
  }
  bool IsPressed() { return Length(this->Device->GetState()->GetComputedForce()) > 0.1; }

  vtkNew<vtkHapticPointShell> Tool;
};
} // namespace

TEST_F(ShellRecording, ReplaysToTheBit)
{
  this->TurnTool(0.0);
  this->Begin();
  this->StartRecording();
  ASSERT_TRUE(this->Lead(7.0, 7.0, 4.0));
  ASSERT_TRUE(this->Lead(7.0, 7.0, 8.0));
  for (int i = 0; i < 30; ++i)
  {
    this->TurnTool(0.03 * i);
    this->Wander(1);
  }
  this->ExpectSame(0.15);
  EXPECT_FALSE(this->Recorded->GetFieldData()->GetArray("InitialContacts"));
}

TEST_F(ShellRecording, ReplaysFromContactToTheBit)
{
  this->Begin();
  ASSERT_TRUE(this->Lead(7.0, 7.0, 4.0));
  ASSERT_TRUE(this->Lead(7.0, 7.0, 8.0));
  ASSERT_TRUE(this->Wait([this] { return this->IsPressed(); }));
  this->StartRecording();
  this->Wander(20);
  this->Turn(20.0, 1.0); // changes the placement of the device
  this->Wander(20);
  this->ExpectSame(0.15);
  ASSERT_TRUE(this->Recorded->GetFieldData()->GetArray("InitialContacts"));
  EXPECT_GT(this->Recorded->GetFieldData()->GetArray("InitialContacts")->GetNumberOfTuples(), 10);
}

TEST_F(ShellRecording, GivesForceAndTorque)
{
  this->TurnTool(0.0);
  this->Begin();
  ASSERT_TRUE(this->Lead(7.0, 7.0, 4.0));
  ASSERT_TRUE(this->ArmFully());
  ASSERT_TRUE(this->LeadInto(8.0));
  EXPECT_EQ(this->Device->GetMaximumTorque(), 0.25) << "half of the virtual device's";
  ASSERT_TRUE(this->Wait(
    [this]
    {
      return Length(this->Device->GetState()->GetForce()) > 0.15 &&
        Length(this->Device->GetState()->GetTorque()) > 1e-4;
    }));
  // The hand is 1.5 mm left of the ball's centre, so the surface exerts a torque about y.
  EXPECT_GT(this->Device->GetState()->GetTorque()[1], 1e-4);
  EXPECT_LT(this->Device->GetState()->GetForce()[2], -0.15);
  EXPECT_NEAR(this->Device->GetState()->GetTorque()[1],
    this->Device->GetState()->GetComputedTorque()[1], 1e-12);
  const double* const q = this->Device->GetState()->GetToolOrientation();
  EXPECT_NEAR(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3], 1.0, 1e-12);
  this->Device->SetMaximumTorque(1e-5);
  ASSERT_TRUE(
    this->Wait([this] { return Length(this->Device->GetState()->GetTorque()) < 1.1e-5; }));
  EXPECT_GT(Length(this->Device->GetState()->GetTorque()), 0.9e-5);
  this->Device->Disarm();
  ASSERT_TRUE(this->Wait([this] { return Length(this->Device->GetState()->GetTorque()) == 0.0; }));
  EXPECT_GT(Length(this->Device->GetState()->GetComputedTorque()), 1e-4);
  this->Device->ResetMaximumTorque();
  EXPECT_EQ(this->Device->GetMaximumTorque(), 0.25);
}

/// While the points of the tool are computed, the hand must use the earlier model: here a point.
TEST_F(ShellRecording, PointsAreSpreadInTheBackground)
{
  this->Filter->SetTool(nullptr);
  this->Begin();
  ASSERT_TRUE(this->Lead(7.0, 7.0, 4.0));
  ASSERT_TRUE(this->ArmFully());
  ASSERT_TRUE(this->LeadInto(8.0));
  const double force = Length(this->Device->GetState()->GetForce());
  EXPECT_GT(force, 0.15);
  this->Tool->SetNumberOfPoints(20000);
  this->Filter->SetTool(this->Tool);
  ASSERT_TRUE(this->Device->Publish());
  EXPECT_FALSE(this->Device->IsPublished());
  EXPECT_TRUE(this->IsSpreading()) << this->Device->GetStatusText();
  ASSERT_TRUE(this->WaitTicks(20));
  EXPECT_EQ(Length(this->Device->GetState()->GetToolOrientation()), 0.0);
  EXPECT_NEAR(Length(this->Device->GetState()->GetForce()), force, 0.05 * force);
  // Further changes of settings must not wait for the worker.
  this->Filter->SetTool(nullptr);
  ASSERT_TRUE(this->Device->Publish());
  EXPECT_TRUE(this->Device->IsPublished());
  EXPECT_FALSE(this->IsSpreading());
  this->Tool->SetNumberOfPoints(1000);
  this->Filter->SetTool(this->Tool);
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->Wait([this] { return this->Device->IsPublished(); }));
  ASSERT_TRUE(this->WaitTicks(5));
  EXPECT_NE(Length(this->Device->GetState()->GetToolOrientation()), 0.0);
  // The points are available now, so the next model needs no worker.
  this->Filter->GetProperty()->GetFriction()->AddPoint(0.0, 0.1);
  ASSERT_TRUE(this->Device->Publish());
  EXPECT_TRUE(this->Device->IsPublished());
  EXPECT_TRUE(this->Log.Errors.empty());
}

/// An error in a mesh must be reported after the worker has found it.
TEST_F(ShellRecording, ABadMeshIsAnErrorOfTheBackground)
{
  this->Filter->SetTool(nullptr);
  this->Begin();
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(20, 20);
  plane->Update();
  this->Tool->SetMesh(plane->GetOutput());
  this->Tool->SetNumberOfPoints(10000);
  this->Filter->SetTool(this->Tool);
  ASSERT_TRUE(this->Device->Publish());
  EXPECT_TRUE(this->IsSpreading());
  const auto isTold = [this]
  {
    const auto& errors = this->FilterLog.Errors.empty() ? this->Log.Errors : this->FilterLog.Errors;
    return !errors.empty() && errors[0].find("is not closed") != std::string::npos;
  };
  ASSERT_TRUE(this->Wait(isTold));
  EXPECT_FALSE(this->IsSpreading());
  EXPECT_EQ(this->FilterLog.Errors.size() + this->Log.Errors.size(), 1u);
  this->FilterLog.Errors.clear();
  this->Log.Errors.clear();
}

TEST_F(ShellRecording, TheToolMayChangeUnderForce)
{
  this->Begin();
  ASSERT_TRUE(this->Lead(7.0, 7.0, 4.0));
  ASSERT_TRUE(this->ArmFully());
  ASSERT_TRUE(this->LeadInto(8.0));
  EXPECT_GT(Length(this->Device->GetState()->GetForce()), 0.15);
  vtkNew<vtkHapticNeedle> needle;
  for (vtkHapticTool* const next :
    { static_cast<vtkHapticTool*>(nullptr), static_cast<vtkHapticTool*>(needle.Get()) })
  {
    this->Filter->SetTool(next);
    ASSERT_TRUE(this->Device->Publish());
    ASSERT_TRUE(this->WaitTicks(20));
    EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::ACTIVE) << this->Device->GetStatusText();
    EXPECT_EQ(Length(this->Device->GetState()->GetToolOrientation()), 0.0);
    this->Filter->SetTool(this->Tool);
    ASSERT_TRUE(this->Device->Publish());
    ASSERT_TRUE(this->Lead(7.0, 7.0, 4.0));
    ASSERT_TRUE(this->WaitFullyArmed());
    ASSERT_TRUE(this->LeadInto(8.0));
    ASSERT_TRUE(this->Wait([this] { return Length(this->Device->GetState()->GetForce()) > 0.15; }));
  }
  // A change of the material under force must preserve the contact.
  SetConstant(this->Filter->GetProperty()->GetStiffness(), 700.0);
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->WaitTicks(20));
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::ACTIVE) << this->Device->GetStatusText();
  EXPECT_GT(Length(this->Device->GetState()->GetComputedForce()), 0.15);
}
