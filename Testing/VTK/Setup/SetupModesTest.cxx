// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that a setup's modes are restored, that guides keep their paths, and that an error in the
 * file names the mode.
 */

#include "SetupErrorsRig.h"

#include <vtkHapticGuideMode.h>
#include <vtkHapticMode.h>

using namespace setuptest;

namespace
{
using SetupModes = SetupErrors;

vtkSmartPointer<vtkHapticMode> AddTo(vtkVolumeHapticsFilter* filter, int kind)
{
  const auto mode = vtkSmartPointer<vtkHapticMode>::New();
  mode->SetKind(kind);
  filter->AddMode(mode);
  return mode;
}

vtkSmartPointer<vtkHapticGuideMode> AddGuideTo(vtkVolumeHapticsFilter* filter)
{
  const auto mode = vtkSmartPointer<vtkHapticGuideMode>::New();
  filter->AddMode(mode);
  return mode;
}
} // namespace

TEST_F(SetupModes, ComeBackAsTheyWere)
{
  Scene a;
  const auto follow = AddTo(a.Filter, vtkHapticMode::VECTOR_FOLLOW);
  follow->SetArrayName("velocity \"U\"");
  follow->GetStrength()->AddPoint(0.1, 0.3, 0.25, 0.5);
  follow->GetSecondStrength()->AddPoint(0.2, 1.0 / 3.0);
  follow->SetAxesToImage();
  follow->ActiveOff();
  AddTo(a.Filter, vtkHapticMode::VECTOR_FRONT)->TwoSidedOn();
  AddTo(a.Filter, vtkHapticMode::VORTEX)->GetSecondStrength()->AddPoint(1.0, 2.0);
  AddTo(a.Filter, vtkHapticMode::SHEAR);
  AddTo(a.Filter, vtkHapticMode::TENSOR_FOLLOW)->GetSecondStrength()->AddPoint(0.5, 0.7);
  const auto ridge = AddTo(a.Filter, vtkHapticMode::RIDGE);
  ridge->SetPolarityToDark();
  ridge->SetSnapDistance(1.25);
  const auto guide = AddGuideTo(a.Filter);
  guide->SetPath(MakePath({ { 0, 0, 0 }, { 1, 1, 1 } }));
  guide->SetSideToInside();
  guide->SetDistance(-0.3);
  AddTo(a.Filter, vtkHapticMode::SURFACE);
  a.Filter->SetMethodToPrimitives();
  const std::string file = File("Modes.json");
  ASSERT_TRUE(a.Setup->Save(file.c_str()));

  Scene b;
  const auto path = MakePath({ { 0, 0, 0 }, { 2, 2, 2 } });
  for (int i = 0; i < 7; ++i)
  {
    AddGuideTo(b.Filter)->SetPath(path);
  }
  ASSERT_TRUE(b.Setup->Load(file.c_str()));
  const std::string again = File("Again.json");
  ASSERT_TRUE(b.Setup->Save(again.c_str()));
  EXPECT_EQ(Read(again), Read(file));
  ASSERT_EQ(b.Filter->GetNumberOfModes(), 8);
  for (int i = 0; i < 8; ++i)
  {
    EXPECT_STREQ(b.Filter->GetMode(i)->GetClassName(), a.Filter->GetMode(i)->GetClassName());
    EXPECT_EQ(b.Filter->GetMode(i)->GetKind(), a.Filter->GetMode(i)->GetKind());
  }
  vtkHapticMode* const read = b.Filter->GetMode(0);
  EXPECT_EQ(read->GetArrayName(), "velocity \"U\"");
  EXPECT_EQ(read->GetSecondStrength()->GetValue(0.2), 1.0 / 3.0);
  EXPECT_FALSE(read->GetActive());
  auto* const back = vtkHapticGuideMode::SafeDownCast(b.Filter->GetMode(6));
  EXPECT_EQ(back->GetPath(), path.Get());
  EXPECT_EQ(back->GetSide(), vtkHapticGuideMode::INSIDE);
  EXPECT_EQ(back->GetDistance(), -0.3);
  // Loading a setup without modes must leave the filter's modes unchanged.
  const std::string none = File("None.json");
  ASSERT_TRUE(Scene().Setup->Save(none.c_str()));
  ASSERT_TRUE(b.Setup->Load(none.c_str()));
  EXPECT_EQ(b.Filter->GetNumberOfModes(), 8);
}

TEST_F(SetupModes, BadOnesAreNamed)
{
  const auto modes = [this](const std::string& text) { return this->Haptics("\"Modes\":" + text); };
  this->Refuse(modes("7"), { "Haptics.Modes is 7", "an object" });
  this->Refuse(modes(R"({"1":{"Kind":"Ridge"}})"), { "Haptics.Modes.1", "from 0 on" });
  this->Refuse(modes(R"({"0":{}})"), { "Haptics.Modes.0", "the Kind of a mode" });
  this->Refuse(modes(R"({"0":{"Kind":"Waltz"}})"), { "Haptics.Modes.0.Kind", "\"VectorFollow\"" });
  this->Refuse(modes(R"({"0":{"Kind":"Ridge","SnapDistance":99}})"),
    { "Haptics.Modes.0.SnapDistance is 99", "from 0.1 to 16" });
  this->Refuse(modes(R"({"0":{"Kind":"Shear","Strength":{"Nodes":[[0,-1,0.5,0]]}}})"),
    { "Haptics.Modes.0.Strength.Nodes", "0 or more" });
}
