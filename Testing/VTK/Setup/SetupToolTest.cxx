// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests that a setup's tools are restored, and that an error in the file names the tool. */

#include "SetupErrorsRig.h"

#include <vtkHapticBurr.h>
#include <vtkHapticNeedle.h>
#include <vtkHapticPointShell.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPolyData.h>

using namespace setuptest;

namespace
{
using SetupTool = SetupErrors;
}

TEST_F(SetupTool, ComesBackAsItWas)
{
  Scene a;
  vtkNew<vtkHapticNeedle> needle;
  needle->SetLateralStrength(1.0 / 3.0);
  needle->GetShaftFriction()->AddPoint(0.1, 20.0, 0.25, 0.5);
  needle->GetCuttingForce()->AddPoint(-50.0, 0.3);
  a.Filter->SetTool(needle);
  const std::string file = File("Tool.json");
  ASSERT_TRUE(a.Setup->Save(file.c_str()));

  Scene b;
  ASSERT_TRUE(b.Setup->Load(file.c_str()));
  const std::string again = File("Again.json");
  ASSERT_TRUE(b.Setup->Save(again.c_str()));
  EXPECT_EQ(Read(again), Read(file));
  auto* const read = vtkHapticNeedle::SafeDownCast(b.Filter->GetTool());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->GetLateralStrength(), 1.0 / 3.0);
  EXPECT_EQ(read->GetShaftFriction()->GetValue(0.1), 20.0);
  EXPECT_EQ(read->GetCuttingForce()->GetSize(), 1);
  // Loading a setup without a tool must leave the filter's tool unchanged.
  const std::string none = File("None.json");
  ASSERT_TRUE(Scene().Setup->Save(none.c_str()));
  ASSERT_TRUE(b.Setup->Load(none.c_str()));
  EXPECT_EQ(b.Filter->GetTool(), read);
}

TEST_F(SetupTool, ABurrComesBackAsItWas)
{
  Scene a;
  vtkNew<vtkHapticBurr> burr;
  burr->SetRadius(1.25);
  burr->SetSpeed(30000.0);
  burr->SetFriction(0.2);
  burr->SetVibration(0.125);
  burr->SetSpinButton(-1);
  burr->SetContactArea(0.25);
  burr->SetCouplingStiffness(700.0);
  burr->SetSolidToAbove();
  burr->SetContactValue(300.0);
  burr->GetSpecificEnergy()->AddPoint(300.0, 2.0);
  a.Filter->SetTool(burr);
  const std::string file = File("Burr.json");
  ASSERT_TRUE(a.Setup->Save(file.c_str()));

  Scene b;
  ASSERT_TRUE(b.Setup->Load(file.c_str()));
  const std::string again = File("BurrAgain.json");
  ASSERT_TRUE(b.Setup->Save(again.c_str()));
  EXPECT_EQ(Read(again), Read(file));
  auto* const read = vtkHapticBurr::SafeDownCast(b.Filter->GetTool());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->GetRadius(), 1.25);
  EXPECT_EQ(read->GetSpeed(), 30000.0);
  EXPECT_EQ(read->GetFriction(), 0.2);
  EXPECT_EQ(read->GetVibration(), 0.125);
  EXPECT_EQ(read->GetSpinButton(), -1);
  EXPECT_EQ(read->GetContactArea(), 0.25);
  EXPECT_EQ(read->GetCouplingStiffness(), 700.0);
  EXPECT_EQ(read->GetSolid(), vtkHapticBurr::ABOVE);
  EXPECT_EQ(read->GetContactValue(), 300.0);
  EXPECT_EQ(read->GetSpecificEnergy()->GetValue(300.0), 2.0);
}

/// Neither a tool's mesh nor the shapes of guides are saved, so the scene must keep its own mesh.
TEST_F(SetupTool, AShapeKeepsItsMesh)
{
  Scene a;
  vtkNew<vtkHapticPointShell> shell;
  shell->SetNumberOfPoints(321);
  shell->SetContactArea(12.5);
  shell->SetCouplingStiffness(700.0);
  shell->SetTurningStiffness(1.0 / 3.0);
  shell->SetSolidToBelow();
  shell->SetContactValue(-150.0);
  vtkNew<vtkPolyData> mesh;
  shell->SetMesh(mesh);
  a.Filter->SetTool(shell);
  const std::string file = File("Shape.json");
  ASSERT_TRUE(a.Setup->Save(file.c_str()));
  EXPECT_EQ(shell->GetMesh(), mesh);

  Scene b;
  vtkNew<vtkHapticPointShell> before;
  vtkNew<vtkPolyData> kept;
  before->SetMesh(kept);
  b.Filter->SetTool(before);
  ASSERT_TRUE(b.Setup->Load(file.c_str()));
  const std::string again = File("ShapeAgain.json");
  ASSERT_TRUE(b.Setup->Save(again.c_str()));
  EXPECT_EQ(Read(again), Read(file));
  auto* const read = vtkHapticPointShell::SafeDownCast(b.Filter->GetTool());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->GetNumberOfPoints(), 321);
  EXPECT_EQ(read->GetContactArea(), 12.5);
  EXPECT_EQ(read->GetCouplingStiffness(), 700.0);
  EXPECT_EQ(read->GetTurningStiffness(), 1.0 / 3.0);
  EXPECT_EQ(read->GetSolid(), vtkHapticPointShell::BELOW);
  EXPECT_EQ(read->GetContactValue(), -150.0);
  EXPECT_EQ(read->GetMesh(), kept);
}

TEST_F(SetupTool, BadOnesAreNamed)
{
  const auto tool = [this](const std::string& text) { return this->Haptics("\"Tool\":" + text); };
  this->Refuse(tool("7"), { "Haptics.Tool is 7", "an object" });
  this->Refuse(tool("{}"), { "Haptics.Tool", "the Kind of a tool" });
  this->Refuse(tool(R"({"Kind":"Spoon"})"), { "Haptics.Tool.Kind", "\"Needle\"" });
  this->Refuse(tool(R"({"Kind":"PointShell","NumberOfPoints":-1})"),
    { "Haptics.Tool.NumberOfPoints is -1", "0 to 1000000" });
  this->Refuse(
    tool(R"({"Kind":"Burr","Vibration":1.5})"), { "Haptics.Tool.Vibration is 1.5", "0 to 1" });
  this->Refuse(tool(R"({"Kind":"Needle","LateralStrength":-1})"),
    { "Haptics.Tool.LateralStrength is -1", "0 or more" });
  this->Refuse(tool(R"({"Kind":"Needle","ShaftFriction":{"Nodes":[[0,-1,0.5,0]]}})"),
    { "Haptics.Tool.ShaftFriction.Nodes", "0 or more" });
}
