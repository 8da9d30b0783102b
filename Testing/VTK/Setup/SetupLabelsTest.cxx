// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that the label table in a setup is restored, and that an error in the file names the label.
 * Tables are compared through their getters and their CSV output.
 */

#include "SetupErrorsRig.h"

#include <vtkHapticLabelTable.h>

#include <limits>

using namespace setuptest;

namespace
{
constexpr int Least = std::numeric_limits<int>::min();
constexpr int Most = std::numeric_limits<int>::max();

/// Fills a table with positive and negative labels that have every combination of a label's values.
void FillTable(vtkHapticLabelTable* table, unsigned int seed)
{
  std::mt19937 random(seed);
  const auto draw = [&random](double most)
  { return std::uniform_real_distribution<double>(0.0, most)(random); };
  const std::vector<std::string> names = { "liver", "", "Kr\xC3\xB6pfchen", "\xE5\xBF\x83",
    "\xF0\x9F\xAB\x80 \"heart\"", "a,b\\c/\xE2\x82\xAC", std::string("tab\tin") };
  table->SetStandOff(draw(5.0));
  for (int i = 0; i < 256; ++i)
  {
    const int label = i == 0 ? Least
      : i == 1               ? Most
                             : std::uniform_int_distribution<int>(Least, Most)(random) >> (i % 31);
    table->SetLabelName(label, names[static_cast<std::size_t>(i) % names.size()]);
    const auto has = [i](int bit) { return (i >> bit & 1) != 0; };
    has(0) ? table->SetColor(label, draw(1.0), draw(1.0), draw(1.0)) : void();
    has(1) ? table->SetStiffness(label, draw(1000.0)) : void();
    has(2) ? table->SetFriction(label, draw(1.0)) : void();
    has(3) ? table->SetViscosity(label, draw(1.0)) : void();
    has(4) ? table->SetSurfaceStrength(label, draw(10.0)) : void();
    i % 3 == 0 ? table->SetShaftFriction(label, draw(60.0)) : void();
    i % 5 == 0 ? table->SetSpecificEnergy(label, draw(60.0)) : void();
    has(5) ? table->SetFelt(label, has(6)) : void();
    has(7) ? table->SetForbidden(label, has(6)) : void();
  }
}

std::string Csv(vtkHapticLabelTable* table)
{
  const std::string file = File("Table.csv");
  EXPECT_TRUE(table->WriteFile(file.c_str()));
  return Read(file);
}

void ExpectSame(vtkHapticLabelTable* a, vtkHapticLabelTable* b)
{
  ASSERT_TRUE(a && b);
  ASSERT_EQ(a->GetNumberOfLabels(), b->GetNumberOfLabels());
  EXPECT_EQ(a->GetStandOff(), b->GetStandOff());
  for (vtkIdType i = 0; i < a->GetNumberOfLabels(); ++i)
  {
    const int label = a->GetLabel(i);
    ASSERT_EQ(b->GetLabel(i), label);
    EXPECT_EQ(a->GetLabelName(label), b->GetLabelName(label));
    EXPECT_EQ(a->HasColor(label), b->HasColor(label));
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_EQ(a->GetColor(label)[c], b->GetColor(label)[c]) << "to the bit";
    }
    EXPECT_EQ(a->GetStiffness(label), b->GetStiffness(label));
    EXPECT_EQ(a->GetFriction(label), b->GetFriction(label));
    EXPECT_EQ(a->GetViscosity(label), b->GetViscosity(label));
    EXPECT_EQ(a->GetSurfaceStrength(label), b->GetSurfaceStrength(label));
    EXPECT_EQ(a->GetShaftFriction(label), b->GetShaftFriction(label));
    EXPECT_EQ(a->GetSpecificEnergy(label), b->GetSpecificEnergy(label));
    EXPECT_EQ(a->GetFelt(label), b->GetFelt(label));
    EXPECT_EQ(a->GetForbidden(label), b->GetForbidden(label));
  }
  EXPECT_EQ(Csv(a), Csv(b)) << "flags that are set";
}
} // namespace

TEST(SetupLabels, ComeBackAsTheyWere)
{
  const std::string file = File("Labels.json");
  for (unsigned int seed = 1; seed <= 5; ++seed)
  {
    vtkNew<vtkHapticLabelTable> table;
    FillTable(table, seed);
    Scene saved;
    saved.Filter->SetLabelTable(table);
    saved.Filter->SetGeometryFromLabels();
    ASSERT_TRUE(saved.Setup->Save(file.c_str()));

    Scene loaded; // has no table
    ASSERT_TRUE(loaded.Setup->Load(file.c_str()));
    ASSERT_NO_FATAL_FAILURE(ExpectSame(loaded.Filter->GetLabelTable(), table));
    EXPECT_EQ(loaded.Filter->GetGeometry(), vtkVolumeHapticsFilter::FROM_LABELS);

    // Loading must fill an existing table instead of replacing it.
    vtkNew<vtkHapticLabelTable> other;
    FillTable(other, seed + 100);
    loaded.Filter->SetLabelTable(other);
    ASSERT_TRUE(loaded.Setup->Load(file.c_str()));
    EXPECT_EQ(loaded.Filter->GetLabelTable(), other.Get());
    ASSERT_NO_FATAL_FAILURE(ExpectSame(other, table));
    const vtkMTimeType time = other->GetMTime();
    const std::string text = Read(file);
    ASSERT_TRUE(loaded.Setup->Load(file.c_str()));
    EXPECT_EQ(other->GetMTime(), time) << "nothing to publish";
    ASSERT_TRUE(loaded.Setup->Save(file.c_str()));
    EXPECT_EQ(Read(file), text);
    EXPECT_TRUE(saved.Log.Errors.empty() && loaded.Log.Errors.empty());
  }
}

TEST(SetupLabels, StayAsTheyAreWithAFileThatHasNone)
{
  const std::string file = File("NoLabels.json");
  Scene saved;
  ASSERT_TRUE(saved.Setup->Save(file.c_str()));
  EXPECT_EQ(Read(file).find("\"Labels\""), std::string::npos);
  Scene loaded;
  ASSERT_TRUE(loaded.Setup->Load(file.c_str()));
  EXPECT_EQ(loaded.Filter->GetLabelTable(), nullptr);
  vtkNew<vtkHapticLabelTable> table;
  vtkNew<vtkHapticLabelTable> before;
  FillTable(table, 7);
  before->DeepCopy(table);
  loaded.Filter->SetLabelTable(table);
  ASSERT_TRUE(loaded.Setup->Load(file.c_str()));
  ASSERT_NO_FATAL_FAILURE(ExpectSame(table, before));

  // An empty table must also be restored.
  vtkNew<vtkHapticLabelTable> empty;
  saved.Filter->SetLabelTable(empty);
  ASSERT_TRUE(saved.Setup->Save(file.c_str()));
  ASSERT_TRUE(loaded.Setup->Load(file.c_str()));
  EXPECT_EQ(table->GetNumberOfLabels(), 0);
  EXPECT_EQ(table->GetStandOff(), 0.0);
}

TEST(SetupLabels, OfWhichAFileHasAPart)
{
  const std::string file = File("Part.json");
  std::ofstream(file) << R"({"Format":"VTK Volume Haptics setup","Version":1,"Haptics":)"
                         R"({"Labels":{"StandOff":2.5}}})";
  Scene loaded;
  vtkNew<vtkHapticLabelTable> table;
  table->SetStiffness(5, 300.0);
  loaded.Filter->SetLabelTable(table);
  ASSERT_TRUE(loaded.Setup->Load(file.c_str()));
  EXPECT_EQ(table->GetStandOff(), 2.5);
  EXPECT_EQ(table->GetStiffness(5), 300.0);
  std::ofstream(file) << R"({"Format":"VTK Volume Haptics setup","Version":1,"Haptics":)"
                         R"({"Labels":{"Table":{"-3":{},"7":{"Friction":0.5}}}}})";
  ASSERT_TRUE(loaded.Setup->Load(file.c_str()));
  EXPECT_EQ(table->GetStandOff(), 2.5);
  EXPECT_EQ(table->GetNumberOfLabels(), 2);
  EXPECT_TRUE(table->HasLabel(-3) && !table->HasMaterial(-3));
  EXPECT_EQ(table->GetFriction(7), 0.5);
  EXPECT_EQ(table->GetStiffness(7), -1.0);
}

TEST(SetupLabels, AreLessThanAMillion)
{
  // A table that could not be loaded again must not be saved.
  const std::string file = File("Million.json");
  std::ofstream(file) << "as before";
  for (const int labels : { 80000, 1000000 })
  {
    Scene saved;
    vtkNew<vtkHapticLabelTable> table;
    for (int label = 0; label < labels; ++label)
    {
      table->SetStiffness(label, 100.0 + label / 3.0);
      table->SetFriction(label, 1.0 / (3.0 + label));
      table->SetViscosity(label, 1.0 / (3.0 + label));
      table->SetSurfaceStrength(label, 1.0 / (3.0 + label));
      table->SetColor(label, 1.0 / 3.0, 1.0 / 7.0, 1.0 / (3.0 + label));
    }
    saved.Filter->SetLabelTable(table);
    EXPECT_FALSE(saved.Setup->Save(file.c_str()));
    ASSERT_EQ(saved.Log.Errors.size(), 1U);
    EXPECT_NE(saved.Log.Errors[0].find("vtkHapticLabelTable::WriteFile"), std::string::npos);
    EXPECT_NE(saved.Log.Errors[0].find(file), std::string::npos);
    EXPECT_EQ(Read(file), "as before");
  }
}

TEST_F(SetupErrors, LabelsThatCannotBe)
{
  vtkNew<vtkHapticLabelTable> table;
  FillTable(table, 3);
  this->Target.Filter->SetLabelTable(table);
  this->Good = this->Save("Good.json");
  const auto refuse = [this](const std::string& rows, const std::vector<std::string>& words)
  {
    this->Refuse(
      this->Haptics(R"("Labels":{"StandOff":1,"Table":{"4":{"Friction":0.1},)" + rows + "}}"),
      words);
  };
  refuse(R"("5":{"Stiffness":-3})", { "Haptics.Labels.Table.5.Stiffness", "-3", "0 or more" });
  refuse(R"("5":{"Friction":"none"})", { "Haptics.Labels.Table.5.Friction", "none", "number" });
  refuse(R"("5":{"Viscosity":NaN})", { "Haptics.Labels.Table.5.Viscosity", "number" });
  refuse(R"("5":{"SurfaceStrength":Infinity})", { "Table.5.SurfaceStrength", "number" });
  refuse(R"("-5":{"Name":17})", { "Haptics.Labels.Table.-5.Name", "17", "text" });
  refuse(R"("5":{"Color":[1,2]})", { "Haptics.Labels.Table.5.Color", "3 numbers" });
  refuse(R"("5":{"Color":[0,0.5,1.5]})", { "Haptics.Labels.Table.5.Color", "0 to 1" });
  refuse(R"("5":{"Felt":1})", { "Haptics.Labels.Table.5.Felt", "true or false" });
  refuse(R"("5":{"Forbidden":"yes"})", { "Haptics.Labels.Table.5.Forbidden", "true or false" });
  refuse(R"("5":300)", { "Haptics.Labels.Table.5", "object" });
  for (const char* key : { "liver", "5.0", "05", "+5", " 5", "", "2147483648", "-0" })
  {
    refuse('"' + std::string(key) + R"(":{"Stiffness":300})",
      { "Haptics.Labels.Table." + std::string(key) + " is", "whole number", "2147483647" });
  }
  refuse(R"("4":{"Friction":0.2})", { "not JSON", "4" }); // the key occurs twice
  this->Refuse(this->Haptics(R"("Labels":[1,2])"), { "Haptics.Labels", "object" });
  this->Refuse(this->Haptics(R"("Labels":{"Table":[1,2]})"), { "Haptics.Labels.Table", "object" });
  this->Refuse(this->Haptics(R"("Labels":{"StandOff":-1})"), { "Labels.StandOff", "0 or more" });
}
