// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that a setup restores everything that it saved, bitwise and in place, and changes nothing
 * else.
 */

#include "RandomSetup.h"
#include "SetupNumbers.h"

#include <locale>

using namespace setuptest;

TEST(Setup, EverythingComesBackToTheBit)
{
  const std::string file = File("Everything.json");
  for (unsigned int seed = 1; seed <= 50; ++seed)
  {
    RandomScene saved(seed);
    ASSERT_TRUE(saved.Setup->Save(file.c_str()));
    Scene loaded;
    vtkPiecewiseFunction* const stiffness = loaded.Filter->GetProperty()->GetStiffness();
    ASSERT_TRUE(loaded.Setup->Load(file.c_str()));
    ASSERT_EQ(Everything(loaded), Everything(saved)) << "seed " << seed;
    EXPECT_EQ(loaded.Filter->GetProperty()->GetStiffness(), stiffness) << "not in place";
    // Saving the loaded setup must reproduce the file.
    const std::string text = Read(file);
    ASSERT_TRUE(loaded.Setup->Save(file.c_str()));
    ASSERT_EQ(Read(file), text);
    EXPECT_TRUE(saved.Log.Errors.empty() && loaded.Log.Errors.empty());
  }
}

TEST(Setup, EmptyFunctionsAndTwoNodesInOnePlaceStaySo)
{
  const std::string file = File("Nodes.json");
  Scene saved;
  vtkPiecewiseFunction* const friction = saved.Filter->GetProperty()->GetFriction();
  friction->SetAllowDuplicateScalars(1);
  friction->AddPoint(1.0, 0.25);
  friction->AddPoint(1.0, 0.5);
  friction->SetAllowDuplicateScalars(0);
  ASSERT_TRUE(saved.Setup->Save(file.c_str()));
  RandomScene loaded(7);
  ASSERT_TRUE(loaded.Setup->Load(file.c_str()));
  EXPECT_EQ(loaded.Filter->GetProperty()->GetStiffness()->GetSize(), 0);
  EXPECT_EQ(Nodes(loaded.Filter->GetProperty()->GetFriction()), Nodes(friction));
  EXPECT_EQ(loaded.Filter->GetProperty()->GetVisibilityFrom(), nullptr);
}

TEST(Setup, WhatIsNotSetIsLeftOutAndWhatIsMissingStays)
{
  const std::string file = File("Part.json");
  RandomScene saved(3);
  saved.Setup->SetCamera(nullptr);
  saved.Setup->SetVolumeHaptics(nullptr);
  ASSERT_TRUE(saved.Setup->Save(file.c_str()));
  EXPECT_EQ(Read(file).find("Stiffness"), std::string::npos);
  RandomScene loaded(4);
  const Numbers position(loaded.Camera->GetPosition(), loaded.Camera->GetPosition() + 3);
  const double rate = loaded.Filter->GetServoRate();
  ASSERT_TRUE(loaded.Setup->Load(file.c_str()));
  EXPECT_EQ(Numbers(loaded.Camera->GetPosition(), loaded.Camera->GetPosition() + 3), position);
  EXPECT_EQ(loaded.Filter->GetServoRate(), rate);
  EXPECT_EQ(loaded.Matrix->GetElement(0, 0), saved.Matrix->GetElement(0, 0));
}

TEST(Setup, AnApplicationsLocaleDoesNotMatter)
{
  struct Commas : std::numpunct<char>
  {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  const std::string file = File("Locale.json");
  RandomScene saved(5);
  Scene loaded;
  const std::locale before = std::locale::global(std::locale(std::locale(), new Commas));
  const bool saves = saved.Setup->Save(file.c_str());
  const bool loads = loaded.Setup->Load(file.c_str());
  const bool kept = std::use_facet<std::numpunct<char>>(std::locale()).decimal_point() == ',';
  std::locale::global(before);
  EXPECT_TRUE(saves && loads && kept);
  EXPECT_EQ(Everything(loaded), Everything(saved));
}
