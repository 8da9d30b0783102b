// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A device on a volume with labels: its state tells the label, and its recordings replay to the bit
 * with the same labels, and not without labels.
 */

#include "Rigs/RecordingRig.h"

#include <vtkExecutive.h>
#include <vtkHapticLabelTable.h>
#include <vtkStringArray.h>

using namespace devicetest;

namespace
{
class LabelRecording : public Recording
{
protected:
  LabelRecording()
  {
    this->Table->SetStiffness(-7, 300.0);
    this->Table->SetSurfaceStrength(-7, 3.0);
    this->Table->SetLabelName(-7, "liver");
    this->Table->SetStiffness(9, 700.0);
    this->Filter->SetLabelData(this->Labels);
    this->Filter->SetLabelTable(this->Table);
  }

  vtkSmartPointer<vtkImageData> Labels =
    MakeImage(16, VTK_SHORT, [](const Point& p) { return p[0] < 7.5 ? -7.0 : 9.0; });
  vtkNew<vtkHapticLabelTable> Table;
};
} // namespace

TEST_F(LabelRecording, ReplaysToTheBitWithItsLabels)
{
  this->Begin();
  this->Wander(30);
  this->StartRecording();
  this->Wander(60);
  this->ExpectSame();
  auto* const settings =
    vtkStringArray::SafeDownCast(this->Recorded->GetFieldData()->GetAbstractArray("Settings"));
  ASSERT_NE(settings, nullptr);
  const std::string text = settings->GetValue(0);
  EXPECT_NE(text.find("LabelHash: " + this->Filter->HashLabels()), std::string::npos) << text;
  EXPECT_NE(text.find("liver"), std::string::npos) << text;

  this->FilterLog.Errors.clear();
  MessageLog executive(this->Filter->GetExecutive());
  this->Filter->SetLabelData(nullptr);
  this->Filter->Update();
  ASSERT_EQ(this->FilterLog.Errors.size(), 1U);
  for (const char* const word : { "made with labels", "port 3", "SetLabelTable" })
  {
    EXPECT_NE(this->FilterLog.Errors[0].find(word), std::string::npos);
  }
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST_F(LabelRecording, ReplaysToTheBitWithWallsOfLabels)
{
  this->Filter->SetGeometryFromLabels();
  this->Begin();
  this->Wander(20);
  this->StartRecording();
  this->Wander(80);
  this->ExpectSame(0.1);
}

TEST_F(LabelRecording, TheStateTellsTheLabel)
{
  this->Begin();
  EXPECT_EQ(this->Device->GetLabel(), -7);
  ASSERT_TRUE(this->Lead(11.0, 7.0, 5.0));
  EXPECT_EQ(this->Device->GetLabel(), 9);
  ASSERT_TRUE(this->Lead(11.0, 7.0, 40.0));
  EXPECT_EQ(this->Device->GetLabel(), 0) << "beyond the label image";
  this->Filter->SetLabelData(nullptr);
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->Lead(7.0, 7.0, 5.0));
  ASSERT_TRUE(this->WaitTicks(3));
  EXPECT_EQ(this->Device->GetLabel(), 0) << "there is no label image";
}

TEST_F(LabelRecording, AForbiddenLabelIsToldOnce)
{
  // The label begins at z = 11.5; the wall stands 1.5 in front of it, and nothing else holds.
  this->Filter->SetLabelData(
    MakeImage(16, VTK_SHORT, [](const Point& p) { return p[2] < 11.5 ? 0.0 : 9.0; }));
  this->Table->SetForbidden(9, true);
  this->Table->SetStandOff(1.5);
  SetConstant(this->Filter->GetProperty()->GetSurfaceStrength(), 0.0);
  SetConstant(this->Filter->GetProperty()->GetViscosity(), 0.0);
  int events = 0;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&events);
  command->SetCallback(
    [](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
  this->Device->AddObserver(vtkCommand::UserEvent, command);
  this->Begin();
  ASSERT_TRUE(this->ArmFully());
  ASSERT_TRUE(this->LeadInto(9.5));
  EXPECT_FALSE(this->Device->IsAtForbiddenLabel());
  EXPECT_EQ(Length(this->Device->GetComputedForce()), 0.0);
  ASSERT_TRUE(this->LeadInto(12.0));
  ASSERT_TRUE(this->Wait([this] { return this->Device->IsAtForbiddenLabel(); }));
  EXPECT_NEAR(this->Device->GetProxyPosition()[2], 10.0, 0.1);
  // x_s is 2 mm behind the wall, in the label of 700 N/m.
  EXPECT_NEAR(this->Device->GetComputedForce()[2], -700.0 * 0.002, 0.1);
  EXPECT_EQ(events, 1);
  ASSERT_TRUE(this->Lead(7.0, 7.0, 6.0));
  EXPECT_FALSE(this->Device->IsAtForbiddenLabel());
  EXPECT_EQ(events, 1);
}
