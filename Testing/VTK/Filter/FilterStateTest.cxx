// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests settings of the filter: defaults, limits, printed text, and which changes update the
 * modification time.
 */

#include "Rigs/ApiRig.h"

#include <sstream>

using namespace apitest;

TEST(FilterState, DefaultsAreThoseOfTheDocumentation)
{
  vtkNew<vtkVolumeHapticsFilter> filter;
  EXPECT_EQ(filter->GetMethod(), vtkVolumeHapticsFilter::PROXY);
  EXPECT_EQ(filter->GetSolver(), vtkVolumeHapticsFilter::PRECISE);
  EXPECT_EQ(filter->GetGradientEstimator(), vtkVolumeHapticsFilter::GAUSSIAN);
  EXPECT_EQ(filter->GetKernelRadius(), 2);
  EXPECT_EQ(filter->GetServoRate(), 1000.0);
  EXPECT_EQ(filter->GetMetersPerWorldUnit(), 0.001);
  EXPECT_EQ(filter->GetForceFieldDamping(), 0.0);
  EXPECT_EQ(filter->GetTimeUnitsPerSecond(), 1.0);
  EXPECT_EQ(filter->GetDisplacementArrayName(), "");
  EXPECT_EQ(filter->GetFrames(), vtkVolumeHapticsFilter::TIME_STEPS);
  EXPECT_EQ(filter->GetFrameSpacing(), 1.0);
  EXPECT_FALSE(filter->GetSameShape());
  EXPECT_EQ(filter->GetCouplingStiffness(), 500.0);
  EXPECT_EQ(filter->GetMaximumForce(), 0.0);
  EXPECT_EQ(filter->GetMaximumStiffness(), 0.0);
  EXPECT_EQ(filter->GetIsoValue(), 0.0);
  EXPECT_EQ(filter->GetProxyRadius(), 0.0);
  EXPECT_TRUE(filter->GetForceShading());
  EXPECT_EQ(filter->GetLocalSurfaceShape(), vtkVolumeHapticsFilter::PLANE);
  EXPECT_EQ(filter->GetLocalSurfaceRate(), 60.0);
  EXPECT_EQ(filter->GetRecoveryTime(), 0.015);
  EXPECT_EQ(filter->GetReleaseTime(), 0.005);
  EXPECT_EQ(filter->GetNumberOfInputPorts(), 4);
  EXPECT_EQ(filter->GetNumberOfOutputPorts(), 1);
  ASSERT_NE(filter->GetProperty(), nullptr);
  EXPECT_EQ(filter->GetProperty(), filter->GetProperty());
}

TEST(FilterState, EverySetterModifiesOnChangeOnly)
{
  vtkNew<vtkVolumeHapticsFilter> filter;
  vtkNew<vtkHapticProperty> property;
  const std::pair<const char*, std::function<void()>> changes[] = {
    { "Method", [&] { filter->SetMethodToForceField(); } },
    { "Method back", [&] { filter->SetMethodToProxy(); } },
    { "Estimator 0", [&] { filter->SetGradientEstimatorToCentralDifference(); } },
    { "Estimator 2", [&] { filter->SetGradientEstimatorToCubicBSpline(); } },
    { "Estimator 1", [&] { filter->SetGradientEstimatorToGaussian(); } },
    { "KernelRadius", [&] { filter->SetKernelRadius(3); } },
    { "ServoRate", [&] { filter->SetServoRate(500.0); } },
    { "MetersPerWorldUnit", [&] { filter->SetMetersPerWorldUnit(0.002); } },
    { "ForceFieldGain", [&] { filter->SetForceFieldGain(0.5); } },
    { "ForceFieldDamping", [&] { filter->SetForceFieldDamping(0.5); } },
    { "IsoValue", [&] { filter->SetIsoValue(7.0); } },
    { "ProxyRadius", [&] { filter->SetProxyRadius(0.3); } },
    { "ForceShading", [&] { filter->ForceShadingOff(); } },
    { "LocalSurfaceShape", [&] { filter->SetLocalSurfaceShapeToQuadric(); } },
    { "LocalSurfaceRate", [&] { filter->SetLocalSurfaceRate(30.0); } },
    { "RecoveryTime", [&] { filter->SetRecoveryTime(0.05); } },
    { "ReleaseTime", [&] { filter->SetReleaseTime(0.0); } },
    { "TimeUnitsPerSecond", [&] { filter->SetTimeUnitsPerSecond(2.0); } },
    { "DisplacementArrayName", [&] { filter->SetDisplacementArrayName("motion"); } },
    { "no DisplacementArrayName", [&] { filter->SetDisplacementArrayName(nullptr); } },
    { "Frames", [&] { filter->SetFramesToComponents(); } },
    { "Frames back", [&] { filter->SetFramesToTimeSteps(); } },
    { "FrameSpacing", [&] { filter->SetFrameSpacing(0.1); } },
    { "SameShape", [&] { filter->SameShapeOn(); } },
    { "CouplingStiffness", [&] { filter->SetCouplingStiffness(300.0); } },
    { "MaximumForce", [&] { filter->SetMaximumForce(3.0); } },
    { "MaximumStiffness", [&] { filter->SetMaximumStiffness(800.0); } },
    { "Property", [&] { filter->SetProperty(property); } },
    { "no Property", [&] { filter->SetProperty(nullptr); } },
  };
  for (const auto& [name, change] : changes)
  {
    vtkMTimeType before = filter->GetMTime();
    change();
    EXPECT_GT(filter->GetMTime(), before) << name;
    before = filter->GetMTime();
    change();
    EXPECT_EQ(filter->GetMTime(), before) << name << " again";
  }
  EXPECT_NE(filter->GetProperty(), property.Get());
}

TEST(FilterState, MTimeFollowsTheProperty)
{
  vtkNew<vtkVolumeHapticsFilter> filter;
  filter->GetProperty()->GetFriction();
  const vtkMTimeType before = filter->GetMTime();
  filter->GetProperty()->GetFriction()->AddPoint(1.0, 0.5);
  EXPECT_GT(filter->GetMTime(), before);
}

TEST(FilterState, SettingsAreKeptInTheirRange)
{
  vtkNew<vtkVolumeHapticsFilter> filter;
  filter->SetKernelRadius(0);
  EXPECT_EQ(filter->GetKernelRadius(), 1);
  filter->SetKernelRadius(1000);
  EXPECT_EQ(filter->GetKernelRadius(), 16);
  filter->SetMethod(99);
  EXPECT_EQ(filter->GetMethod(), vtkVolumeHapticsFilter::PRIMITIVES);
  filter->SetRecoveryTime(-1.0);
  EXPECT_EQ(filter->GetRecoveryTime(), 0.0);
  filter->SetReleaseTime(-1.0);
  EXPECT_EQ(filter->GetReleaseTime(), 0.0);
  filter->SetReleaseTime(2.0);
  EXPECT_EQ(filter->GetReleaseTime(), 1.0);
  filter->SetLocalSurfaceRate(0.0);
  EXPECT_EQ(filter->GetLocalSurfaceRate(), 1.0);
  filter->SetProxyRadius(-1.0);
  EXPECT_EQ(filter->GetProxyRadius(), 0.0);
  filter->SetGradientEstimator(-1);
  EXPECT_EQ(filter->GetGradientEstimator(), vtkVolumeHapticsFilter::CENTRAL_DIFFERENCE);
  filter->SetSolver(99);
  EXPECT_EQ(filter->GetSolver(), vtkVolumeHapticsFilter::PRECISE);
  filter->SetSolverToPaper();
  EXPECT_EQ(filter->GetSolver(), vtkVolumeHapticsFilter::PAPER);
  filter->SetGeometry(99);
  EXPECT_EQ(filter->GetGeometry(), vtkVolumeHapticsFilter::FROM_BOTH);
  filter->SetContactAlignment(99);
  EXPECT_EQ(filter->GetContactAlignment(), vtkVolumeHapticsFilter::EDGE);
  filter->SetMaterialPlacement(-1);
  EXPECT_EQ(filter->GetMaterialPlacement(), vtkVolumeHapticsFilter::KERNEL);
  filter->SetMaterialPlacementToFarSide();
  EXPECT_EQ(filter->GetMaterialPlacement(), vtkVolumeHapticsFilter::FAR_SIDE);
  filter->SetServoRate(0.0);
  EXPECT_EQ(filter->GetServoRate(), 1.0);
  filter->SetMetersPerWorldUnit(-1.0);
  EXPECT_GT(filter->GetMetersPerWorldUnit(), 0.0);
  filter->SetMaximumForce(-1.0);
  EXPECT_EQ(filter->GetMaximumForce(), 0.0);
  filter->SetMaximumStiffness(-1.0);
  EXPECT_EQ(filter->GetMaximumStiffness(), 0.0);
}

TEST(FilterState, PrintsEveryMember)
{
  vtkNew<vtkVolumeHapticsFilter> filter;
  for (const bool withProperty : { false, true })
  {
    if (withProperty)
    {
      filter->GetProperty();
    }
    std::ostringstream text;
    filter->Print(text);
    for (const char* const member :
      { "Property:", "Method:", "Solver:", "GradientEstimator:", "KernelRadius:", "ServoRate:",
        "MetersPerWorldUnit:", "ForceFieldGain:", "ForceFieldDamping:", "TimeUnitsPerSecond:",
        "SameShape:", "CouplingStiffness:", "MaximumForce:", "MaximumStiffness:" })
    {
      EXPECT_NE(text.str().find(member), std::string::npos) << member;
    }
  }
}
