// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The changes that the style passes to the servo: functions, and the workspace of a device other
 * than the mouse.
 */

#include "StyleRig.h"

#include <vtkPoints.h>
#include <vtkVolumeProperty.h>
#include <vtkXMLPolyDataWriter.h>

using namespace scenetest;

namespace
{
/// A device that holds still, and jumps by 6 along x after some ticks.
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
  ASSERT_GT(this->Device->GetNormalForce(), 0.5);
  look->GetScalarOpacity()->RemoveAllPoints();
  look->GetScalarOpacity()->AddPoint(-1000.0, 0.0);
  this->Style->UpdateHaptics();
  this->Run(3);
  EXPECT_EQ(this->Device->GetNormalForce(), 0.0);
  EXPECT_EQ(this->Device->GetContact(), 0);
}

TEST_F(StyleTest, TheWorkspaceFollowsTheCamera)
{
  const std::string id = WritePath(TemporaryPath("Still.vtp"), 100000);
  ASSERT_TRUE(this->Device->Open(id.c_str()));
  ASSERT_TRUE(this->Device->Start());
  this->Run(5);
  ExpectAt(this->Device->GetTipPosition(), 10, 4, 2); // right, up and towards the user
  this->Renderer->GetActiveCamera()->Azimuth(90.0);   // now looking along -x
  this->Style->UpdateHaptics();
  this->Run(5);
  ExpectAt(this->Device->GetTipPosition(), 2, 4, -10);
  this->Style->SetWorkspaceScale(2000.0);
  this->Style->UpdateHaptics();
  this->Run(5);
  ExpectAt(this->Device->GetTipPosition(), 4, 8, -20);
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
  ExpectAt(this->Device->GetTipPosition(), 10, 4, 2);
  ASSERT_TRUE(Eventually(
    [this]
    {
      this->Style->UpdateHaptics();
      return this->Device->GetTipPosition()[0] > 15.0;
    }));
  this->Press("k", vtkCommand::KeyReleaseEvent);
  EXPECT_FALSE(this->Style->GetClutch());
  this->Run(5);
  ExpectAt(this->Device->GetTipPosition(), 10, 4, 2);
  EXPECT_NE(this->Device->GetStatus(), vtkHapticDevice::READY) << "armed again";
  this->Press("c");
  this->Style->UpdateHaptics();
  this->Run(5);
  ExpectAt(this->Device->GetTipPosition(), 16, 4, 2);
}

TEST_F(StyleTest, AMouseHasNoWorkspaceAndNoClutch)
{
  ASSERT_TRUE(this->Device->Open("virtual"));
  this->Device->SetVirtualTip(1.0, 2.0, 40.0);
  ASSERT_TRUE(this->Device->Start());
  this->Renderer->GetActiveCamera()->Azimuth(90.0);
  this->Run(5);
  this->Press("k");
  EXPECT_FALSE(this->Style->GetClutch());
  ExpectAt(this->Device->GetTipPosition(), 1, 2, 40);
}
