// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Modes in a setup: they come back as they were, guides keep their paths, and a file that is wrong
 * about a mode names it.
 */

#include "SetupErrorsRig.h"

#include <vtkHapticGuideMode.h>
#include <vtkHapticRidgeMode.h>
#include <vtkHapticShearMode.h>
#include <vtkHapticSurfaceMode.h>
#include <vtkHapticTensorFollowMode.h>
#include <vtkHapticVectorFollowMode.h>
#include <vtkHapticVectorFrontMode.h>
#include <vtkHapticVortexMode.h>

using namespace setuptest;

namespace
{
using SetupModes = SetupErrors;

template <typename Mode>
vtkSmartPointer<Mode> AddTo(vtkVolumeHapticsFilter* filter)
{
  const auto mode = vtkSmartPointer<Mode>::New();
  filter->AddMode(mode);
  return mode;
}
} // namespace

TEST_F(SetupModes, ComeBackAsTheyWere)
{
  Scene a;
  const auto follow = AddTo<vtkHapticVectorFollowMode>(a.Filter);
  follow->SetArrayName("velocity \"U\"");
  follow->GetStrength()->AddPoint(0.1, 0.3, 0.25, 0.5);
  follow->GetPush()->AddPoint(0.2, 1.0 / 3.0);
  follow->SetAxesToImage();
  follow->ActiveOff();
  AddTo<vtkHapticVectorFrontMode>(a.Filter)->TwoSidedOn();
  AddTo<vtkHapticVortexMode>(a.Filter)->GetAxisStrength()->AddPoint(1.0, 2.0);
  AddTo<vtkHapticShearMode>(a.Filter);
  AddTo<vtkHapticTensorFollowMode>(a.Filter)->GetSheetStrength()->AddPoint(0.5, 0.7);
  const auto ridge = AddTo<vtkHapticRidgeMode>(a.Filter);
  ridge->SetPolarityToDark();
  ridge->SetSnapDistance(1.25);
  const auto guide = AddTo<vtkHapticGuideMode>(a.Filter);
  guide->SetPath(MakePath({ { 0, 0, 0 }, { 1, 1, 1 } }));
  guide->SetSideToInside();
  guide->SetDistance(-0.3);
  AddTo<vtkHapticSurfaceMode>(a.Filter);
  a.Filter->SetMethodToPrimitives();
  const std::string file = File("Modes.json");
  ASSERT_TRUE(a.Setup->Save(file.c_str()));

  Scene b;
  const auto path = MakePath({ { 0, 0, 0 }, { 2, 2, 2 } });
  for (int i = 0; i < 7; ++i)
  {
    AddTo<vtkHapticGuideMode>(b.Filter)->SetPath(path);
  }
  ASSERT_TRUE(b.Setup->Load(file.c_str()));
  const std::string again = File("Again.json");
  ASSERT_TRUE(b.Setup->Save(again.c_str()));
  EXPECT_EQ(Read(again), Read(file));
  ASSERT_EQ(b.Filter->GetNumberOfModes(), 8);
  for (int i = 0; i < 8; ++i)
  {
    EXPECT_STREQ(b.Filter->GetMode(i)->GetClassName(), a.Filter->GetMode(i)->GetClassName());
  }
  auto* const read = vtkHapticVectorFollowMode::SafeDownCast(b.Filter->GetMode(0));
  EXPECT_EQ(read->GetArrayName(), "velocity \"U\"");
  EXPECT_EQ(read->GetPush()->GetValue(0.2), 1.0 / 3.0);
  EXPECT_FALSE(read->GetActive());
  auto* const back = vtkHapticGuideMode::SafeDownCast(b.Filter->GetMode(6));
  EXPECT_EQ(back->GetPath(), path.Get());
  EXPECT_EQ(back->GetSide(), vtkHapticGuideMode::INSIDE);
  EXPECT_EQ(back->GetDistance(), -0.3);
  // A setup without modes leaves those that are there.
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
