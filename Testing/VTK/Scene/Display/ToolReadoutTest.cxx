// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the display's text for a tool: a needle's depth and angle, how many layers it has passed,
 * how often it has touched forbidden tissue, and the torque on a shaped tool. Also writes the
 * needle's track to a file, and reads it back.
 */

#include "Rigs/DeviceRig.h"

#include <vtkCellData.h>
#include <vtkCubeSource.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkHapticHeadUpDisplay.h>
#include <vtkHapticLabelTable.h>
#include <vtkHapticNeedle.h>
#include <vtkHapticPointShell.h>
#include <vtkPointData.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <cmath>
#include <cstdio>
#include <string>

using namespace devicetest;

namespace
{
class ToolReadout : public DeviceTest
{
protected:
  ToolReadout() { this->Display->SetDevice(this->Device); }

  bool Says(const std::string& words)
  {
    return this->Wait([&] { return this->Display->GetText().find(words) != std::string::npos; });
  }

  vtkNew<vtkHapticHeadUpDisplay> Display;
};

/// Tests a needle in skin from z = 4.5 mm, fat from 9.5 mm, and a forbidden artery from 14.5 mm.
class NeedleReadout : public ToolReadout
{
protected:
  NeedleReadout()
  {
    this->Image = MakeRamp(24);
    this->Filter->SetInputData(0, this->Image);
    vtkNew<vtkImageData> labels;
    labels->CopyStructure(this->Image);
    labels->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    int n[3];
    labels->GetDimensions(n);
    for (vtkIdType i = 0; i < labels->GetNumberOfPoints(); ++i)
    {
      const auto k = i / (vtkIdType{ n[0] } * n[1]);
      labels->GetPointData()->GetScalars()->SetComponent(
        i, 0, k < 5 ? 0 : (k < 10 ? 1 : (k < 15 ? 2 : 3)));
    }
    const char* const names[] = { "skin", "fat", "artery" };
    for (int label = 1; label <= 3; ++label)
    {
      this->Table->SetLabelName(label, names[label - 1]);
      this->Table->SetStiffness(label, 500.0);
      this->Table->SetSurfaceStrength(label, 0.0);
      this->Table->SetShaftFriction(label, 20.0);
      this->Table->SetViscosity(label, 0.1);
    }
    this->Table->SetForbidden(3, true);
    this->Filter->SetLabelData(labels);
    this->Filter->SetLabelTable(this->Table);
    this->Filter->SetGeometryFromLabels();
    this->Filter->SetTool(this->Needle);
  }

  double Number(const char* name)
  {
    this->Device->GetState()->GetNeedleTrack(this->Track);
    return this->Track->GetFieldData()->GetArray(name)->GetComponent(0, 0);
  }

  vtkNew<vtkHapticNeedle> Needle;
  vtkNew<vtkHapticLabelTable> Table;
  vtkNew<vtkPolyData> Track;
};
} // namespace

TEST_F(NeedleReadout, TellsDepthAngleLayersAndForbiddenTouches)
{
  this->Begin();
  // The stylus is tilted by 0.2 rad from the vertical.
  ASSERT_TRUE(this->Lead(7.0, 7.0, 3.0));
  this->Device->GetVirtualHand()->SetOrientation(std::sin(0.1), std::cos(0.1), 0.0, 0.0);
  ASSERT_TRUE(this->ArmFully());
  ASSERT_TRUE(this->LeadInto(6.0));
  ASSERT_TRUE(this->Says(" mm deep in skin, ")) << this->Display->GetText();
  EXPECT_TRUE(this->Says("\n11 degrees from upright, 1 layer")) << this->Display->GetText();
  ASSERT_TRUE(this->LeadInto(12.0));
  ASSERT_TRUE(this->Says(" mm deep in fat, ")) << this->Display->GetText();
  EXPECT_TRUE(this->Says(", 2 layers")) << this->Display->GetText();
  EXPECT_EQ(this->Display->GetText().find("forbidden"), std::string::npos);
  EXPECT_EQ(this->Number("ForbiddenTouches"), 0.0);
  ASSERT_TRUE(this->LeadInto(17.0));
  ASSERT_TRUE(this->Says("forbidden tissue touched 1 time")) << this->Display->GetText();
  EXPECT_EQ(this->Number("ForbiddenTouches"), 1.0);
  ASSERT_TRUE(this->Lead(7.0, 7.0, 12.0));
  ASSERT_TRUE(this->LeadInto(17.0));
  ASSERT_TRUE(this->Says("forbidden tissue touched 2 times")) << this->Display->GetText();
  EXPECT_NEAR(this->Number("Angle"), 0.2 * 57.29577951, 0.2);
  // The tilted needle must end at the artery, 10 mm below the skin.
  EXPECT_NEAR(this->Number("Depth"), 10.0 / std::cos(0.2), 0.3);
  EXPECT_NEAR(this->Number("ShaftForce"), 0.02 * this->Number("Depth"), 1e-3);
  char deep[32];
  std::snprintf(
    deep, sizeof(deep), "Needle %.1f mm deep", this->Device->GetState()->GetNeedleDepth());
  EXPECT_TRUE(this->Says(deep)) << this->Display->GetText();

  // Writing and reading a VTP file must preserve the track of the needle.
  const std::string file = this->File("track.vtp");
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(this->Track);
  writer->SetFileName(file.c_str());
  ASSERT_EQ(writer->Write(), 1);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkPolyData* const read = reader->GetOutput();
  ASSERT_EQ(read->GetNumberOfLines(), 2);
  for (int line = 0; line < 2; ++line)
  {
    EXPECT_EQ(read->GetCellData()->GetArray("Label")->GetComponent(line, 0), line + 1);
  }
  EXPECT_NEAR(
    read->GetCellData()->GetArray("Length")->GetComponent(0, 0), 5.0 / std::cos(0.2), 0.2);
  for (const char* const name : { "Depth", "Deepest", "Angle", "ShaftForce", "ForbiddenTouches" })
  {
    ASSERT_TRUE(read->GetFieldData()->GetArray(name)) << name;
    EXPECT_EQ(read->GetFieldData()->GetArray(name)->GetComponent(0, 0),
      this->Track->GetFieldData()->GetArray(name)->GetComponent(0, 0))
      << name;
  }
  EXPECT_EQ(read->GetFieldData()->GetArray("ForbiddenTouches")->GetComponent(0, 0), 2.0);
}

/// Presses the far end of a bar, which exerts a torque on the hand. Without contact, the text must
/// not mention a torque.
TEST_F(ToolReadout, TellsTheTorqueOnAShape)
{
  vtkNew<vtkCubeSource> bar;
  bar->SetXLength(6.0);
  bar->SetYLength(2.0);
  bar->SetZLength(2.0);
  bar->SetCenter(3.0, 0.0, 0.0);
  bar->Update();
  vtkNew<vtkHapticPointShell> tool;
  tool->SetSolidToAbove();
  tool->SetContactValue(600.0);
  tool->SetMesh(bar->GetOutput());
  this->Filter->SetTool(tool);
  this->Begin();
  // A tool that appears inside solid tissue must start without a force.
  ASSERT_TRUE(this->Wait([this] { return this->Device->IsPublished(); }));
  ASSERT_TRUE(this->ArmFully());
  EXPECT_EQ(this->Display->GetText().find("N mm"), std::string::npos);
  ASSERT_TRUE(this->LeadInto(7.0));
  const auto torque = [this]
  {
    const double* const t = this->Device->GetState()->GetComputedTorque();
    return 1e3 * std::sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
  };
  ASSERT_TRUE(this->Wait([&] { return torque() > 0.2; })) << this->Display->GetText();
  EXPECT_TRUE(this->Wait(
    [&]
    {
      char words[48];
      std::snprintf(words, sizeof(words), "turned by %.1f N mm", torque());
      return this->Display->GetText().find(words) != std::string::npos;
    }))
    << this->Display->GetText();
  this->Filter->SetTool(nullptr);
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->WaitTicks(20));
  EXPECT_EQ(this->Display->GetText().find("N mm"), std::string::npos);
}
