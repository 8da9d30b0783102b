// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests vtkHapticLabelTable alone: its entries, its errors, and which changes update the
 * modification time. Its class comment defines the expectations.
 */

#include "Rigs/ApiRig.h"

#include <vtkHapticLabelTable.h>

#include <limits>
#include <random>
#include <set>
#include <sstream>

using namespace apitest;

namespace
{
struct Value
{
  const char* Name;
  void (vtkHapticLabelTable::*Set)(int, double);
  double (vtkHapticLabelTable::*Get)(int);
};

std::ostream& operator<<(std::ostream& os, const Value& value)
{
  return os << value.Name;
}

const Value Values[] = {
  { "stiffness", &vtkHapticLabelTable::SetStiffness, &vtkHapticLabelTable::GetStiffness },
  { "friction", &vtkHapticLabelTable::SetFriction, &vtkHapticLabelTable::GetFriction },
  { "viscosity", &vtkHapticLabelTable::SetViscosity, &vtkHapticLabelTable::GetViscosity },
  { "surface strength", &vtkHapticLabelTable::SetSurfaceStrength,
    &vtkHapticLabelTable::GetSurfaceStrength },
  { "shaft friction", &vtkHapticLabelTable::SetShaftFriction,
    &vtkHapticLabelTable::GetShaftFriction },
  { "specific energy", &vtkHapticLabelTable::SetSpecificEnergy,
    &vtkHapticLabelTable::GetSpecificEnergy },
};

class LabelTable : public testing::Test
{
protected:
  void ExpectError(const std::vector<std::string>& words)
  {
    ASSERT_EQ(this->Log.Errors.size(), 1u);
    for (const std::string& word : words)
    {
      EXPECT_NE(this->Log.Errors[0].find(word), std::string::npos) << this->Log.Errors[0];
    }
    this->Log.Errors.clear();
  }
  void ExpectChange(bool isChange)
  {
    EXPECT_EQ(this->Table->GetMTime() > this->Time, isChange);
    this->Time = this->Table->GetMTime();
    EXPECT_TRUE(this->Log.Errors.empty());
  }

  vtkNew<vtkHapticLabelTable> Table;
  MessageLog Log{ this->Table };
  vtkMTimeType Time = this->Table->GetMTime();
};

class LabelTableValue
  : public LabelTable
  , public testing::WithParamInterface<Value>
{
protected:
  void Set(int label, double value) { (this->Table->*this->GetParam().Set)(label, value); }
  double Get(int label) { return (this->Table->*this->GetParam().Get)(label); }
};
} // namespace

TEST_P(LabelTableValue, IsNotSetAtFirst)
{
  EXPECT_EQ(this->Get(5), -1.0);
  EXPECT_FALSE(this->Table->HasLabel(5));
  EXPECT_FALSE(this->Table->HasMaterial(5));
}

TEST_P(LabelTableValue, IsKeptByLabel)
{
  for (const int label :
    { 5, -7, 0, std::numeric_limits<int>::min(), std::numeric_limits<int>::max() })
  {
    this->Set(label, 300.0);
    this->ExpectChange(true);
    this->Set(label, 300.0);
    this->ExpectChange(false);
    EXPECT_EQ(this->Get(label), 300.0);
    EXPECT_TRUE(this->Table->HasMaterial(label));
  }
  this->Set(5, 0.0);
  this->ExpectChange(true);
  EXPECT_EQ(this->Get(5), 0.0);
  EXPECT_EQ(this->Get(-7), 300.0);
}

TEST_P(LabelTableValue, LeavesTheOthersUnset)
{
  this->Set(5, 300.0);
  int set = 0;
  for (const Value& value : Values)
  {
    set += (this->Table->*value.Get)(5) != -1.0 ? 1 : 0;
  }
  EXPECT_EQ(set, 1);
}

TEST_P(LabelTableValue, ThatCannotBeIsRefused)
{
  this->Set(5, 2.0);
  this->ExpectChange(true);
  for (const double bad : { -0.001, std::nan(""), std::numeric_limits<double>::infinity() })
  {
    this->Set(5, bad);
    this->ExpectError({ this->GetParam().Name, "label 5", "0 or more" });
    this->Set(6, bad);
    this->ExpectError({ this->GetParam().Name, "label 6", "0 or more" });
  }
  this->ExpectChange(false);
  EXPECT_EQ(this->Get(5), 2.0);
  EXPECT_FALSE(this->Table->HasLabel(6));
}

TEST_P(LabelTableValue, IsForgotten)
{
  this->Set(5, 2.0);
  this->Table->SetLabelName(5, "liver");
  this->ExpectChange(true);
  this->Table->RemoveMaterial(5);
  this->ExpectChange(true);
  EXPECT_EQ(this->Get(5), -1.0);
  EXPECT_EQ(this->Table->GetLabelName(5), "liver");
  this->Table->RemoveMaterial(5);
  this->Table->RemoveMaterial(6);
  this->ExpectChange(false);
  EXPECT_FALSE(this->Table->HasLabel(6));
}

INSTANTIATE_TEST_SUITE_P(All, LabelTableValue, testing::ValuesIn(Values));

TEST_F(LabelTable, NamesAreUtf8)
{
  EXPECT_EQ(this->Table->GetLabelName(5), "");
  for (const std::string name : { "liver", "Leber / \xE8\x82\x9D\xE8\x87\x93 / \xF0\x9F\xAB\x80" })
  {
    this->Table->SetLabelName(5, name);
    this->ExpectChange(true);
    EXPECT_EQ(this->Table->GetLabelName(5), name);
    this->Table->SetLabelName(5, name);
    this->ExpectChange(false);
  }
  // Bytes that are not UTF-8 are read as ISO 8859-1, the first 256 characters of Unicode.
  this->Table->SetLabelName(5, "H\xF6hle");
  EXPECT_EQ(this->Table->GetLabelName(5), "H\xC3\xB6hle");
  this->Table->SetLabelName(5, "a\nb\tc");
  EXPECT_EQ(this->Table->GetLabelName(5), "a b c");
}

TEST_F(LabelTable, ColorsAreKeptAndChecked)
{
  double color[3];
  this->Table->GetColor(5, color);
  EXPECT_EQ(std::vector<double>(color, color + 3), std::vector<double>(3, 0.5));
  EXPECT_FALSE(this->Table->HasColor(5));
  this->Table->SetColor(5, 1.0, 0.25, 0.0);
  this->ExpectChange(true);
  this->Table->SetColor(5, std::vector<double>{ 1.0, 0.25, 0.0 }.data());
  this->ExpectChange(false);
  this->Table->GetColor(5, color);
  EXPECT_EQ(std::vector<double>(color, color + 3), (std::vector<double>{ 1.0, 0.25, 0.0 }));
  EXPECT_EQ(this->Table->GetColor(5)[1], 0.25);
  EXPECT_TRUE(this->Table->HasColor(5));
  for (const double bad : { -0.1, 1.1, 255.0, std::nan("") })
  {
    this->Table->SetColor(5, 0.0, bad, 0.0);
    this->ExpectError({ "colour", "label 5", "0 to 1" });
  }
  this->ExpectChange(false);
  EXPECT_FALSE(this->Table->HasMaterial(5));
}

TEST_F(LabelTable, FlagsAndStandOff)
{
  EXPECT_TRUE(this->Table->GetFelt(5));
  EXPECT_FALSE(this->Table->GetForbidden(5));
  this->Table->SetFelt(5, false);
  this->ExpectChange(true);
  this->Table->SetForbidden(5, true);
  this->ExpectChange(true);
  EXPECT_FALSE(this->Table->GetFelt(5));
  EXPECT_TRUE(this->Table->GetForbidden(5));
  EXPECT_EQ(this->Table->GetStandOff(), 0.0);
  this->Table->SetStandOff(2.5);
  this->ExpectChange(true);
  this->Table->SetStandOff(2.5);
  this->ExpectChange(false);
  for (const double bad : { -1.0, std::nan(""), std::numeric_limits<double>::infinity() })
  {
    this->Table->SetStandOff(bad);
    this->ExpectError({ "stand-off", "0 or more" });
  }
  EXPECT_EQ(this->Table->GetStandOff(), 2.5);
}

TEST_F(LabelTable, ListsItsLabels)
{
  std::mt19937 random(7);
  std::set<int> expected;
  for (int i = 0; i < 3000; ++i)
  {
    const int label = static_cast<int>(random() % 200) - 100;
    if (random() % 3 != 0)
    {
      this->Table->SetFelt(label, true);
      expected.insert(label);
    }
    else
    {
      this->Table->RemoveLabel(label);
      expected.erase(label);
    }
    if (i % 100 == 0)
    {
      ASSERT_EQ(this->Table->GetNumberOfLabels(), static_cast<vtkIdType>(expected.size()));
      vtkIdType index = 0;
      for (const int one : expected)
      {
        ASSERT_EQ(this->Table->GetLabel(index++), one);
        ASSERT_TRUE(this->Table->HasLabel(one));
      }
    }
  }
  const vtkIdType count = this->Table->GetNumberOfLabels();
  for (const vtkIdType bad : { vtkIdType{ -1 }, count })
  {
    EXPECT_EQ(this->Table->GetLabel(bad), 0);
    this->ExpectError({ "index " + std::to_string(bad), std::to_string(count) + " labels" });
  }
  this->Table->RemoveAllLabels();
  EXPECT_EQ(this->Table->GetNumberOfLabels(), 0);
  this->Time = this->Table->GetMTime();
  this->Table->RemoveAllLabels();
  this->Table->RemoveLabel(3);
  this->ExpectChange(false);
}

TEST_F(LabelTable, AMillionLabels)
{
  constexpr int count = 1000000;
  for (int i = 0; i < count; ++i)
  {
    // 7919 and the count have no common divisor, so the order of the labels neither increases nor
    // decreases.
    const int label = static_cast<int>(i * 7919LL % count) - count / 2;
    this->Table->SetStiffness(label, 1e6 + label);
  }
  ASSERT_EQ(this->Table->GetNumberOfLabels(), count);
  EXPECT_EQ(this->Table->GetLabel(0), -count / 2);
  EXPECT_EQ(this->Table->GetLabel(count - 1), count / 2 - 1);
  EXPECT_EQ(this->Table->GetStiffness(123456), 1123456.0);
}

TEST_F(LabelTable, CopiesEverything)
{
  this->Table->SetLabelName(5, "liver");
  this->Table->SetColor(5, 0.1, 0.2, 0.3);
  this->Table->SetStiffness(5, 300.0);
  this->Table->SetFriction(5, 0.3);
  this->Table->SetViscosity(5, 0.4);
  this->Table->SetSurfaceStrength(5, 1.5);
  this->Table->SetSpecificEnergy(5, 12.5);
  this->Table->SetFelt(-6, false);
  this->Table->SetForbidden(-6, true);
  this->Table->SetStandOff(2.0);

  vtkNew<vtkHapticLabelTable> copy;
  copy->SetStiffness(9, 1.0);
  copy->DeepCopy(this->Table);
  std::ostringstream mine;
  std::ostringstream theirs;
  this->Table->PrintSelf(mine, vtkIndent());
  copy->PrintSelf(theirs, vtkIndent());
  const auto tail = [](const std::string& text) { return text.substr(text.find("StandOff")); };
  EXPECT_EQ(tail(mine.str()), tail(theirs.str()));
  for (const char* const word : { "StandOff: 2", "5: liver, colour 0.1 0.2 0.3",
         "stiffness 300 N/m", "friction 0.3", "viscosity 0.4 N", "surface strength 1.5 N",
         "specific energy 12.5 J/mm^3", "-6: (no name)", "not felt", "forbidden" })
  {
    EXPECT_NE(theirs.str().find(word), std::string::npos) << theirs.str();
  }
  EXPECT_EQ(copy->GetNumberOfLabels(), 2);
  EXPECT_EQ(copy->GetStiffness(9), -1.0);

  const vtkMTimeType before = copy->GetMTime();
  copy->DeepCopy(this->Table);
  copy->DeepCopy(copy);
  copy->DeepCopy(nullptr);
  EXPECT_EQ(copy->GetMTime(), before);
  copy->SetStiffness(5, 1.0);
  EXPECT_EQ(this->Table->GetStiffness(5), 300.0);
}
