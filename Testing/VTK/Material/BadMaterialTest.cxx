// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests material functions with values that are impossible for a material. */

#include "Rigs/ApiRig.h"

#include <limits>

using namespace apitest;

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Inf = std::numeric_limits<double>::infinity();

struct BadValue
{
  const char* Function;
  vtkPiecewiseFunction* (vtkHapticProperty::*Get)();
  double X;
  double Y;
};

const BadValue BadValues[] = {
  { "Stiffness", &vtkHapticProperty::GetStiffness, 300.0, -1e-9 },
  { "Stiffness", &vtkHapticProperty::GetStiffness, 300.0, NaN },
  { "Stiffness", &vtkHapticProperty::GetStiffness, 300.0, Inf },
  { "Friction", &vtkHapticProperty::GetFriction, 300.0, -0.1 },
  { "Friction", &vtkHapticProperty::GetFriction, 300.0, Inf },
  { "Viscosity", &vtkHapticProperty::GetViscosity, 300.0, -1.0 },
  { "SurfaceStrength", &vtkHapticProperty::GetSurfaceStrength, 300.0, -1e6 },
  { "SurfaceStrength", &vtkHapticProperty::GetSurfaceStrength, Inf, 2.0 },
  { "Distinctness", &vtkHapticProperty::GetDistinctness, 300.0, 1.001 },
  { "Distinctness", &vtkHapticProperty::GetDistinctness, 300.0, -0.001 },
  { "Distinctness", &vtkHapticProperty::GetDistinctness, 300.0, NaN },
};

class BadValueTest
  : public ApiTest
  , public testing::WithParamInterface<BadValue>
{
};
} // namespace

TEST_P(BadValueTest, GivesOneErrorAndRecovers)
{
  const BadValue& bad = this->GetParam();
  vtkHapticProperty* const property = this->Property;
  vtkPiecewiseFunction* const function = (property->*bad.Get)();
  function->AddPoint(200.0, 0.5);
  this->Run(51);
  function->AddPoint(bad.X, bad.Y);
  this->ExpectError({ "haptic property", bad.Function, std::string("Get") + bad.Function + "()" });
  SetConstant(function, 0.5);
  this->Run(51);
}

INSTANTIATE_TEST_SUITE_P(All, BadValueTest, testing::ValuesIn(BadValues));

TEST_F(ApiTest, LogarithmicScaleNeedsPositiveNodes)
{
  // On a logarithmic scale, vtkPiecewiseFunction has no finite value between such nodes.
  vtkPiecewiseFunction* const function = this->Property->GetStiffness();
  function->UseLogScaleOn();
  function->AddPoint(-100.0, 100.0);
  function->AddPoint(2000.0, 500.0);
  this->ExpectError({ "haptic property", "Stiffness", "GetStiffness()" });
  function->AddPoint(1.0, 100.0);
  function->RemovePoint(-100.0);
  this->Run(51);
}
