// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests attaching, editing and detaching the volume property that determines which voxels are felt.
 */

#include "Rigs/ApiRig.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>

using namespace apitest;

namespace
{
class VisibilityUse : public ApiTest
{
protected:
  VisibilityUse()
  {
    // Only values above 700 are opaque. The path of ApiTest goes from the value 500 to 1000, and
    // x_s is 2 mm ahead.
    this->Opacity->AddPoint(700.0, 0.0);
    this->Opacity->AddPoint(701.0, 1.0);
    this->Volume->SetScalarOpacity(this->Opacity);
    // PAPER reports the material at the beginning of a tick, which is easily predicted.
    this->Filter->SetSolverToPaper();
  }

  double StrengthAt(vtkIdType tick) { return Get(this->Run(51), "SurfaceStrength", tick); }

  vtkNew<vtkVolumeProperty> Volume;
  vtkNew<vtkPiecewiseFunction> Opacity;
};
} // namespace

TEST_F(VisibilityUse, AttachEditDetach)
{
  EXPECT_EQ(this->StrengthAt(1), 2.0);
  this->Property->SetVisibilityFrom(this->Volume);
  EXPECT_EQ(Get(this->Run(51), "SurfaceValue", 1), 700.0);
  EXPECT_EQ(this->StrengthAt(1), 0.0);
  // A hidden surface must not stop the proxy, which stays at the tip without a force.
  EXPECT_EQ(Get(this->Run(51), "Force", 1, 2), 0.0);

  this->Opacity->AddPoint(650.0, 0.25);
  this->Opacity->AddPoint(700.0, 0.5);
  EXPECT_EQ(this->StrengthAt(1), 2.0) << "a live edit is felt at the next update";
  this->Opacity->AddPoint(700.0, 0.0);
  EXPECT_EQ(this->StrengthAt(1), 0.0);

  this->Property->SetVisibilityFrom(nullptr);
  EXPECT_EQ(this->StrengthAt(1), 2.0);
}

TEST_F(VisibilityUse, NothingElseIsScaled)
{
  SetConstant(this->Property->GetFriction(), 0.3);
  this->Property->SetVisibilityFrom(this->Volume);
  vtkPolyData* const output = this->Run(51);
  for (const vtkIdType tick : { 1, 50 })
  {
    EXPECT_EQ(Get(output, "Stiffness", tick), 500.0);
    EXPECT_EQ(Get(output, "Friction", tick), 0.3);
  }
  // A voxel is either hidden or visible, so a nearly transparent voxel must have its full strength.
  SetConstant(this->Opacity, 0.01);
  EXPECT_EQ(this->StrengthAt(1), 2.0);
}

TEST_F(VisibilityUse, OpacityOfTheTouchedComponent)
{
  vtkDataArray* const one = this->Image->GetPointData()->GetScalars();
  vtkSmartPointer<vtkDataArray> two;
  two.TakeReference(one->NewInstance());
  two->SetName("Density");
  two->SetNumberOfComponents(2);
  two->SetNumberOfTuples(one->GetNumberOfTuples());
  for (int c = 0; c < 2; ++c)
  {
    two->CopyComponent(c, one, 0);
  }
  this->Image->GetPointData()->SetScalars(two);
  vtkNew<vtkPiecewiseFunction> opaque;
  opaque->AddPoint(0.0, 1.0);
  this->Volume->SetScalarOpacity(1, opaque);
  this->Property->SetVisibilityFrom(this->Volume);

  EXPECT_EQ(this->StrengthAt(1), 0.0) << "component 0 has the opacity that hides";
  this->Property->SetComponent(1);
  EXPECT_EQ(this->StrengthAt(1), 2.0) << "component 1 is opaque";
  this->Volume->SetIndependentComponents(0);
  EXPECT_EQ(this->StrengthAt(1), 0.0) << "dependent components share opacity 0";
}

TEST_F(VisibilityUse, ForceFieldIsNotConcerned)
{
  this->Filter->SetMethodToForceField();
  this->Filter->SetForceFieldGain(0.02);
  const double before = Get(this->Run(51), "Force", 10, 2);
  this->Property->SetVisibilityFrom(this->Volume);
  EXPECT_EQ(Get(this->Run(51), "Force", 10, 2), before);
  EXPECT_NEAR(before, -2.0, 1e-12);
}

TEST_F(VisibilityUse, AWideEdgeIsFeltWhereItIsSeen)
{
  // A step to 50, blurred by 2 mm, is visible for values of at least 47. This is 2 mm x 1.5548
  // behind the middle of the step, where 1.5548 is the 0.94 quantile of the normal distribution.
  this->Image = MakeImage(34, VTK_DOUBLE,
    [](const Point& p) { return 25.0 * std::erfc((14.0 - p[2]) / std::sqrt(8.0)); });
  this->Filter->SetInputDataObject(0, this->Image);
  this->Opacity->RemoveAllPoints();
  this->Opacity->AddPoint(47.0, 0.0);
  this->Opacity->AddPoint(47.5, 1.0);
  this->Property->SetVisibilityFrom(this->Volume);
  this->Filter->SetSolverToPrecise();
  this->Filter->SetPathData(MakePath(Line({ 16, 16, 6 }, { 16, 16, 20 }, 140)));
  vtkPolyData* const output = this->Run(141);
  // The rendered values are linear between the samples at 17 and 18, whose values are 46.66 and
  // 48.86.
  const double below = 25.0 * std::erfc(-3.0 / std::sqrt(8.0));
  const double above = 25.0 * std::erfc(-4.0 / std::sqrt(8.0));
  const double seen = 17.0 + (47.0 - below) / (above - below);
  vtkIdType tick = 0;
  while (tick < 140 && std::abs(Get(output, "Force", tick, 2)) < 0.1)
  {
    ++tick;
  }
  EXPECT_NEAR(output->GetPoint(tick)[2], seen, 0.01);
  EXPECT_GT(std::abs(Get(output, "Force", 140, 2)), 1.0) << "it holds";
}

TEST_F(VisibilityUse, WhatIsBesideSomethingSeenIsNotFelt)
{
  // The hand comes from the side, and passes 0.5 mm in front of the visible part of a step to 50,
  // blurred by 2 mm.
  this->Image = MakeImage(34, VTK_DOUBLE,
    [](const Point& p) { return 25.0 * std::erfc((14.0 - p[2]) / std::sqrt(8.0)); });
  this->Filter->SetInputDataObject(0, this->Image);
  SetConstant(this->Property->GetViscosity(), 0.2);
  this->Filter->SetSolverToPrecise();
  const auto strongest = [&](double z)
  {
    this->Filter->SetPathData(MakePath(Line({ 6, 16, z }, { 26, 16, z + 0.4 }, 200)));
    vtkPolyData* const output = this->Run(201);
    double most = 0.0;
    for (vtkIdType tick = 0; tick < 201; ++tick)
    {
      most = std::max(most, std::abs(Get(output, "Force", tick, 0)));
    }
    return most;
  };
  constexpr double seen = 14.0 + 2.0 * 1.5548;
  EXPECT_GT(strongest(seen - 0.9), 0.1) << "without a look, all of the edge is felt";
  this->Opacity->RemoveAllPoints();
  this->Opacity->AddPoint(47.0, 0.0);
  this->Opacity->AddPoint(47.5, 1.0);
  this->Property->SetVisibilityFrom(this->Volume);
  EXPECT_EQ(strongest(seen - 0.9), 0.0);
}

TEST_F(VisibilityUse, NothingIsFeltBesideTheVolume)
{
  this->Image = MakeImage(20, VTK_DOUBLE, [](const Point&) { return 1000.0; });
  this->Filter->SetInputDataObject(0, this->Image);
  SetConstant(this->Property->GetViscosity(), 0.2);
  this->Filter->SetSolverToPrecise();
  this->Filter->SetPathData(MakePath(Line({ 2, 10, -3 }, { 18, 10, -3 }, 160)));
  EXPECT_NEAR(Get(this->Run(161), "Force", 100, 0), -0.2, 1e-6) << "values go on beyond the border";
  this->Property->SetVisibilityFrom(this->Volume);
  EXPECT_EQ(Get(this->Run(161), "Force", 100, 0), 0.0) << "the picture does not";
  this->Filter->SetPathData(MakePath(Line({ 2, 10, 3 }, { 18, 10, 3 }, 160)));
  EXPECT_NEAR(Get(this->Run(161), "Force", 100, 0), -0.2, 1e-6);
}

TEST_F(VisibilityUse, LabelsThatAreShownByNearestSamplesAreFeltByThem)
{
  // Values step from 0 to 90 between z = 14 and z = 15, and are visible from 1 upwards. At z =
  // 14.1, the interpolated value is visible, but the nearest sample is not.
  this->Image = MakeImage(30, VTK_DOUBLE, [](const Point& p) { return p[2] < 14.5 ? 0.0 : 90.0; });
  this->Filter->SetInputDataObject(0, this->Image);
  SetConstant(this->Property->GetViscosity(), 0.2);
  SetConstant(this->Property->GetSurfaceStrength(), 0.0);
  this->Property->ScalarsAreLabelsOn();
  this->Opacity->RemoveAllPoints();
  this->Opacity->AddPoint(0.5, 0.0);
  this->Opacity->AddPoint(1.0, 1.0);
  this->Property->SetVisibilityFrom(this->Volume);
  this->Filter->SetSolverToPrecise();
  const auto drag = [&](double z)
  {
    this->Filter->SetPathData(MakePath(Line({ 6, 16, z }, { 26, 16, z }, 200)));
    return Get(this->Run(201), "Viscosity", 150);
  };
  // The drag R is that of the value behind the proxy, which is on the hidden side here.
  this->Property->SetSurfaceSideToLower();
  this->Volume->SetInterpolationTypeToLinear();
  EXPECT_GT(drag(14.1), 0.1);
  this->Volume->SetInterpolationTypeToNearest();
  EXPECT_EQ(drag(14.1), 0.0);
  EXPECT_GT(drag(14.6), 0.1);
}

TEST_F(VisibilityUse, AThinSheetThatIsSeenHolds)
{
  // The sheet has a largest value of 60, and is visible for values of at least 50.
  this->Image = MakeImage(34, VTK_DOUBLE,
    [](const Point& p) { return 60.0 * std::exp(-0.5 * std::pow((p[2] - 16.0) / 0.8, 2.0)); });
  this->Filter->SetInputDataObject(0, this->Image);
  this->Opacity->RemoveAllPoints();
  this->Opacity->AddPoint(50.0, 0.0);
  this->Opacity->AddPoint(51.0, 1.0);
  this->Filter->SetSolverToPrecise();
  this->Filter->SetPathData(MakePath(Line({ 16, 16, 6 }, { 16, 16, 18 }, 120)));
  EXPECT_LT(Get(this->Run(121), "Force", 115, 2), -0.5);
  this->Property->SetVisibilityFrom(this->Volume);
  // The rendered values are linear between the samples at z = 15 and z = 16.
  const double below = 60.0 * std::exp(-0.5 / (0.8 * 0.8));
  const double seen = 15.0 + (50.0 - below) / (60.0 - below);
  EXPECT_NEAR(Get(this->Run(121), "Force", 115, 2), -500.0 * 1e-3 * (17.5 - seen), 1e-3);
}
