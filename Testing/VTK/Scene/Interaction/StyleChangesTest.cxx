// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests which changes the style passes to the servo: functions, materials of labels, and the
 * workspace of a device other than the mouse.
 */

#include "StyleRig.h"
#include "VTK/Scene/Editor/EditorProbe.h"

#include <vtkHapticFunctionEditor.h>
#include <vtkHapticLabelTable.h>
#include <vtkPoints.h>
#include <vtkVolumeProperty.h>
#include <vtkXMLPolyDataWriter.h>

#include <cmath>

using namespace scenetest;

namespace
{
/// Writes a path whose tip rests for `still` ticks, and then jumps by 6 mm along x.
std::string WritePath(const std::string& file, int still)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < 100000; ++i)
  {
    points->InsertNextPoint(i < still ? 10.0 : 16.0, 4.0, 2.0);
  }
  vtkNew<vtkPolyData> path;
  path->SetPoints(points);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(path);
  writer->Write();
  return "replay:" + file;
}

void ExpectAt(const double* found, double x, double y, double z)
{
  EXPECT_NEAR(found[0], x, 1e-9);
  EXPECT_NEAR(found[1], y, 1e-9);
  EXPECT_NEAR(found[2], z, 1e-9);
}
} // namespace

TEST_F(StyleTest, WhatIsHiddenStopsBeingFeltWithTheNextUpdate)
{
  vtkNew<vtkVolumeProperty> look;
  look->GetScalarOpacity()->AddPoint(-1000.0, 1.0);
  this->Filter->GetProperty()->SetVisibilityFrom(look);
  ASSERT_NO_FATAL_FAILURE(this->PushIn());
  ASSERT_GT(this->Device->GetState()->GetNormalForce(), 0.5);
  look->GetScalarOpacity()->RemoveAllPoints();
  look->GetScalarOpacity()->AddPoint(-1000.0, 0.0);
  this->Style->UpdateHaptics();
  this->Run(3);
  EXPECT_EQ(this->Device->GetState()->GetNormalForce(), 0.0);
  EXPECT_EQ(this->Device->GetState()->GetContact(), 0);
}

TEST_F(StyleTest, MaterialsOfLabelsAreEditedWhileTheyAreFelt)
{
  // The ball has label 5, with a margin for the voxels at its surface. Everything else has label 0.
  vtkNew<vtkImageData> labels;
  labels->SetDimensions(97, 97, 97);
  labels->SetOrigin(-48.0, -48.0, -48.0);
  labels->AllocateScalars(VTK_SHORT, 1);
  for (vtkIdType i = 0; i < labels->GetNumberOfPoints(); ++i)
  {
    labels->GetPointData()->GetScalars()->SetTuple1(
      i, Length(labels->GetPoint(i)) < 32.0 ? 5.0 : 0.0);
  }
  vtkNew<vtkHapticLabelTable> table;
  this->Filter->SetLabelData(labels);
  this->Filter->SetLabelTable(table);
  vtkNew<vtkHapticFunctionEditor> editor;
  editor->SetLabelTable(table);
  editor->SetLabelData(labels);
  editor->SetRectangle(0, 0, 100, 280); // places the editor beside the touched position
  editor->VisibilityOff();
  this->Style->SetFunctionEditor(editor);
  ASSERT_NO_FATAL_FAILURE(this->PushIn());
  ASSERT_GT(this->Device->GetState()->GetNormalForce(), 1.0);

  this->Press("l");
  EXPECT_TRUE(editor->GetVisibility());
  EXPECT_EQ(editor->GetFunction(), vtkHapticFunctionEditor::LABELS);
  EXPECT_EQ(VolumeHaptics::EditorProbe::GetSelectedLabel(editor), 5) << "the label that is touched";
  this->Pointer(50, 140);
  double at[2];
  ASSERT_TRUE(VolumeHaptics::EditorProbe::GetSliderPosition(
    editor, vtkHapticFunctionEditor::SURFACE_STRENGTH, 0.5, at));
  const int x = static_cast<int>(std::lround(at[0]));
  const int y = static_cast<int>(std::lround(at[1]));
  this->Pointer(x, y, vtkCommand::LeftButtonPressEvent);
  this->Pointer(x, y, vtkCommand::LeftButtonReleaseEvent);
  const double clicked = table->GetSurfaceStrength(5);
  EXPECT_NEAR(clicked, 0.5, 0.2);
  // A surface that is pressed beyond its strength yields until the force equals the strength,
  // within PRECISE's tolerance of 0.1 %.
  this->Run(20);
  EXPECT_NEAR(this->Device->GetState()->GetNormalForce(), clicked, 1e-3 * clicked)
    << "the hand feels it at once";
  this->Pointer(x, y, vtkCommand::MouseWheelBackwardEvent);
  EXPECT_NEAR(table->GetSurfaceStrength(5), clicked - 5.0 / 200.0, 1e-12) << "a step of the slider";
  this->Run(20);
  EXPECT_NEAR(this->Device->GetState()->GetNormalForce(), clicked - 5.0 / 200.0, 1e-3 * clicked);
  this->Press("l");
  EXPECT_FALSE(editor->GetVisibility());
  this->Style->SetFunctionEditor(nullptr);
}

TEST_F(StyleTest, TheWorkspaceFollowsTheCamera)
{
  const std::string id = WritePath(TemporaryPath("Still.vtp"), 100000);
  ASSERT_TRUE(this->Device->Open(id.c_str()));
  ASSERT_TRUE(this->Device->Start());
  this->Run(5);
  // The jump is to the right, upwards and towards the user.
  ExpectAt(this->Device->GetState()->GetTipPosition(), 10, 4, 2);
  this->Renderer->GetActiveCamera()->Azimuth(90.0); // rotates the camera to look along -x
  this->Style->UpdateHaptics();
  this->Run(5);
  ExpectAt(this->Device->GetState()->GetTipPosition(), 2, 4, -10);
  this->Style->SetWorkspaceScale(2000.0);
  this->Style->UpdateHaptics();
  this->Run(5);
  ExpectAt(this->Device->GetState()->GetTipPosition(), 4, 8, -20);
}

TEST_F(StyleTest, TheHandMovesWithoutTheTipWhileItIsClutched)
{
  const std::string id = WritePath(TemporaryPath("Jump.vtp"), 3000);
  ASSERT_TRUE(this->Device->Open(id.c_str()));
  ASSERT_TRUE(this->Device->Start());
  this->Device->Arm();
  this->Run(5);
  this->Press("k");
  ASSERT_TRUE(this->Style->GetClutch());
  this->Run(5);
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::READY) << "no force meanwhile";
  ExpectAt(this->Device->GetState()->GetTipPosition(), 10, 4, 2);
  ASSERT_TRUE(Eventually(
    [this]
    {
      this->Style->UpdateHaptics();
      return this->Device->GetState()->GetTipPosition()[0] > 15.0;
    }));
  this->Press("k", vtkCommand::KeyReleaseEvent);
  EXPECT_FALSE(this->Style->GetClutch());
  this->Run(5);
  ExpectAt(this->Device->GetState()->GetTipPosition(), 10, 4, 2);
  EXPECT_NE(this->Device->GetStatus(), vtkHapticDevice::READY) << "armed again";
  this->Press("c");
  this->Style->UpdateHaptics();
  this->Run(5);
  ExpectAt(this->Device->GetState()->GetTipPosition(), 16, 4, 2);
}

TEST_F(StyleTest, AMouseHasNoWorkspaceAndNoClutch)
{
  ASSERT_TRUE(this->Device->Open("virtual"));
  this->Device->GetVirtualHand()->SetPosition(1.0, 2.0, 40.0);
  ASSERT_TRUE(this->Device->Start());
  this->Renderer->GetActiveCamera()->Azimuth(90.0);
  this->Run(5);
  this->Press("k");
  EXPECT_FALSE(this->Style->GetClutch());
  ExpectAt(this->Device->GetState()->GetTipPosition(), 1, 2, 40);
}
