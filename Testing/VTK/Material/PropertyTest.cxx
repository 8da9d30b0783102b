// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests vtkHapticProperty alone: the objects that it owns, which changes update the modification
 * time, and what it prints and copies.
 */

#include "Rigs/ApiRig.h"

#include <vtkVolumeProperty.h>

#include <sstream>

using namespace apitest;

namespace
{
struct OwnedFunction
{
  const char* Name;
  vtkPiecewiseFunction* (vtkHapticProperty::*Get)();
  void (vtkHapticProperty::*Set)(vtkPiecewiseFunction*);
};

std::ostream& operator<<(std::ostream& os, const OwnedFunction& function)
{
  return os << function.Name;
}

const OwnedFunction OwnedFunctions[] = {
  { "Stiffness", &vtkHapticProperty::GetStiffness, &vtkHapticProperty::SetStiffness },
  { "Friction", &vtkHapticProperty::GetFriction, &vtkHapticProperty::SetFriction },
  { "Viscosity", &vtkHapticProperty::GetViscosity, &vtkHapticProperty::SetViscosity },
  { "SurfaceStrength", &vtkHapticProperty::GetSurfaceStrength,
    &vtkHapticProperty::SetSurfaceStrength },
  { "Distinctness", &vtkHapticProperty::GetDistinctness, &vtkHapticProperty::SetDistinctness },
};

class OwnedFunctionTest : public testing::TestWithParam<OwnedFunction>
{
protected:
  vtkPiecewiseFunction* Get() { return (this->Property->*this->GetParam().Get)(); }
  void Set(vtkPiecewiseFunction* function) { (this->Property->*this->GetParam().Set)(function); }

  vtkNew<vtkHapticProperty> Property;
};

std::string Print(vtkHapticProperty* property)
{
  std::ostringstream text;
  property->Print(text);
  return text.str();
}
} // namespace

TEST_P(OwnedFunctionTest, IsCreatedOnFirstGetWithoutPointsAndClamped)
{
  vtkPiecewiseFunction* const function = this->Get();
  ASSERT_NE(function, nullptr);
  EXPECT_EQ(this->Get(), function);
  EXPECT_EQ(function->GetSize(), 0);
  EXPECT_TRUE(function->GetClamping());
}

TEST_P(OwnedFunctionTest, CanBeReplacedAndDropped)
{
  vtkNew<vtkPiecewiseFunction> mine;
  mine->AddPoint(1.0, 2.0);
  const vtkMTimeType before = this->Property->GetMTime();
  this->Set(mine);
  EXPECT_EQ(this->Get(), mine.Get());
  EXPECT_EQ(mine->GetReferenceCount(), 2);
  const vtkMTimeType after = this->Property->GetMTime();
  EXPECT_GT(after, before);
  this->Set(mine);
  EXPECT_EQ(this->Property->GetMTime(), after) << "setting the same function again is no change";
  this->Set(nullptr);
  EXPECT_GT(this->Property->GetMTime(), after);
  EXPECT_EQ(mine->GetReferenceCount(), 1);
  EXPECT_NE(this->Get(), mine.Get());
  EXPECT_EQ(this->Get()->GetSize(), 0);
}

TEST_P(OwnedFunctionTest, EditsCountAsModifications)
{
  const vtkMTimeType before = (this->Get(), this->Property->GetMTime());
  this->Get()->AddPoint(1.0, 0.5);
  EXPECT_GT(this->Property->GetMTime(), before);
  EXPECT_EQ(this->Property->GetMTime(), this->Get()->GetMTime());
}

TEST_P(OwnedFunctionTest, IsPrintedAndCopiedPointByPoint)
{
  this->Get()->AddPoint(12.0, 0.75, 0.25, 0.625);
  const std::string name = this->GetParam().Name;
  EXPECT_NE(Print(this->Property).find(name + ":"), std::string::npos);

  vtkNew<vtkHapticProperty> copy;
  vtkPiecewiseFunction* const kept = (copy->*this->GetParam().Get)();
  copy->DeepCopy(this->Property);
  vtkPiecewiseFunction* const copied = (copy->*this->GetParam().Get)();
  EXPECT_EQ(copied, kept) << "the copy's own function is filled";
  EXPECT_NE(copied, this->Get());
  double node[4] = {};
  ASSERT_EQ(copied->GetNodeValue(0, node), 1);
  EXPECT_EQ(
    (std::vector<double>(node, node + 4)), (std::vector<double>{ 12.0, 0.75, 0.25, 0.625 }));
  this->Get()->AddPoint(13.0, 0.5);
  EXPECT_EQ(copied->GetSize(), 1);
}

INSTANTIATE_TEST_SUITE_P(All, OwnedFunctionTest, testing::ValuesIn(OwnedFunctions));
