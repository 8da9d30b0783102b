// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tools in a setup: they come back as they were, and a file that is wrong about one names it.
 */

#include "SetupErrorsRig.h"

#include <vtkHapticNeedle.h>
#include <vtkPiecewiseFunction.h>

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
  // A setup without a tool leaves the one that is there.
  const std::string none = File("None.json");
  ASSERT_TRUE(Scene().Setup->Save(none.c_str()));
  ASSERT_TRUE(b.Setup->Load(none.c_str()));
  EXPECT_EQ(b.Filter->GetTool(), read);
}

TEST_F(SetupTool, BadOnesAreNamed)
{
  const auto tool = [this](const std::string& text) { return this->Haptics("\"Tool\":" + text); };
  this->Refuse(tool("7"), { "Haptics.Tool is 7", "an object" });
  this->Refuse(tool("{}"), { "Haptics.Tool", "the Kind of a tool" });
  this->Refuse(tool(R"({"Kind":"Spoon"})"), { "Haptics.Tool.Kind", "\"Needle\"" });
  this->Refuse(tool(R"({"Kind":"Needle","LateralStrength":-1})"),
    { "Haptics.Tool.LateralStrength is -1", "0 or more" });
  this->Refuse(tool(R"({"Kind":"Needle","ShaftFriction":{"Nodes":[[0,-1,0.5,0]]}})"),
    { "Haptics.Tool.ShaftFriction.Nodes", "0 or more" });
}
