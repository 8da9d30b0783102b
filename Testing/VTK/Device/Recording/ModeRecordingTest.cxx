// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests modes on a device. Recordings must replay bitwise. If a mode becomes active while the hand
 * is away from the mode's line, its force must rise gradually.
 */

#include "Rigs/RecordingRig.h"

#include <vtkDoubleArray.h>
#include <vtkHapticGuideMode.h>
#include <vtkHapticMode.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <vector>

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
    this->Front->SetKindToVectorFront();
    this->Front->SetArrayName("flow");
    this->Follow->GetStrength()->AddPoint(0.0, 0.0);
    this->Follow->GetStrength()->AddPoint(3.0, 1.5);
    this->Filter->AddMode(this->Follow);
    this->Filter->SetMethodToPrimitives();
  }

  vtkNew<vtkHapticMode> Follow;
  vtkNew<vtkHapticMode> Front;
};

Point GetPoint(vtkDataArray* array, vtkIdType row)
{
  return { array->GetComponent(row, 0), array->GetComponent(row, 1), array->GetComponent(row, 2) };
}
} // namespace

TEST_F(ModeRecording, ReplaysToTheBit)
{
  vtkNew<vtkHapticMode> surface;
  surface->SetKindToSurface();
  this->Front->TwoSidedOn();
  SetConstant(this->Front->GetStrength(), 0.3);
  SetConstant(this->Filter->GetProperty()->GetSurfaceStrength(), 0.6);
  this->Filter->AddMode(this->Front);
  this->Filter->AddMode(surface);
  this->Begin();
  this->Wander(10); // gives the recording an initial force and speed
  this->StartRecording();
  this->Wander(20);
  this->Turn(30.0, 1.0);
  this->Wander(20);
  this->ExpectSame();
}

TEST_F(ModeRecording, OtherModesReplayToTheBit)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(3.0, 6.0, 5.0);
  points->InsertNextPoint(8.0, 8.0, 7.0);
  points->InsertNextPoint(11.0, 7.0, 6.0);
  vtkNew<vtkPolyData> path;
  path->SetPoints(points);
  vtkNew<vtkDoubleArray> tensor;
  tensor->SetName("tensor");
  tensor->SetNumberOfComponents(6);
  for (vtkIdType i = 0; i < this->Image->GetNumberOfPoints(); ++i)
  {
    const double lean = 0.05 * this->Image->GetPoint(i)[0];
    const double fibre[6] = { 1.0, 0.3 + lean * lean, 0.3, lean, 0.0, 0.1 };
    tensor->InsertNextTuple(fibre);
  }
  this->Image->GetPointData()->AddArray(tensor);
  vtkNew<vtkHapticMode> vortex;
  vortex->SetKindToVortex();
  vortex->SetArrayName("flow");
  SetConstant(vortex->GetStrength(), 0.4);
  vtkNew<vtkHapticMode> ridge;
  ridge->SetKindToRidge();
  SetConstant(ridge->GetStrength(), 0.3);
  vtkNew<vtkHapticGuideMode> guide;
  guide->SetPath(path);
  SetConstant(guide->GetStrength(), 0.5);
  vtkNew<vtkHapticMode> shear;
  shear->SetKindToShear();
  shear->SetArrayName("flow");
  SetConstant(shear->GetStrength(), 0.8);
  vtkNew<vtkHapticMode> fibres;
  fibres->SetKindToTensorFollow();
  fibres->SetArrayName("tensor");
  SetConstant(fibres->GetStrength(), 1.5);
  const std::vector<vtkHapticMode*> sets[] = { { vortex, ridge, guide }, { shear, fibres } };
  for (const auto& modes : sets)
  {
    this->Filter->RemoveAllModes();
    for (vtkHapticMode* const mode : modes)
    {
      this->Filter->AddMode(mode);
    }
    this->Begin();
    this->Wander(10);
    this->StartRecording();
    this->Wander(30);
    this->ExpectSame();
    this->Device->Close();
  }
}

TEST_F(ModeRecording, AModeThatComesUnderTheHandComesSoftly)
{
  // The hand left the line 3 mm ago, so the spring to the line would pull with 1.5 N at once. The
  // force must rise slowly instead.
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
  const double held = Length(this->Device->GetState()->GetForce());
  EXPECT_GT(held, 0.3);
  vtkNew<vtkTable> ticks;
  // number of a second reader besides the fixture's
  constexpr int reader = 5;
  this->Device->GetState()->Drain(ticks, reader); // starts storing states for this reader
  // Without the line, the hand is free. When another mode becomes active, its force must rise from
  // 0.
  this->Follow->ActiveOff();
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->Wait([this] { return Length(this->Device->GetState()->GetForce()) < 1e-6; }));
  ASSERT_TRUE(this->Lead(10.0, 7.0, 5.0));
  this->Front->ActiveOn();
  this->Follow->ActiveOn();
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->Lead(10.0, 9.0, 5.0));
  ASSERT_TRUE(this->Wait([this] { return Length(this->Device->GetState()->GetForce()) > 0.3; }));
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::ACTIVE) << this->Device->GetStatusText();
  // The force must not grow by more than the slew limit in any tick.
  ASSERT_TRUE(this->WaitTicks(50));
  this->Device->GetState()->Drain(ticks, reader);
  ASSERT_GT(ticks->GetNumberOfRows(), 50);
  auto* const command = vtkDataArray::SafeDownCast(ticks->GetColumnByName("Command"));
  double jolt = 0.0;
  for (vtkIdType i = 1; i < ticks->GetNumberOfRows(); ++i)
  {
    const Point before = GetPoint(command, i - 1);
    const Point after = GetPoint(command, i);
    const double along = before[0] * after[0] + before[1] * after[1] + before[2] * after[2];
    const double size = Length(after.data());
    jolt = std::max(jolt, size > 0.0 ? size - std::max(0.0, along / size) : 0.0);
  }
  EXPECT_GT(jolt, 0.0);
  EXPECT_LE(jolt, 1e-3 * this->Device->GetMaximumForceRate() + 1e-9);
}
