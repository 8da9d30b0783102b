// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/DeviceTool/HoldingMedium.h"

#include <vtkHapticProperty.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkVolumeHapticsFilter.h>

namespace
{

constexpr double Strength = 1000.0;    // N, much more than any device has
constexpr double MediumSpacing = 40.0; // mm
constexpr int MediumSamples = 13;      // beyond every device's workspace

void SetEverywhere(vtkPiecewiseFunction* function, double value)
{
  function->RemoveAllPoints();
  function->AddPoint(0.0, value);
}

} // namespace

void MakeHoldingMedium(vtkVolumeHapticsFilter* filter, double stiffness)
{
  vtkNew<vtkImageData> medium;
  medium->SetDimensions(MediumSamples, MediumSamples, MediumSamples);
  medium->SetSpacing(MediumSpacing, MediumSpacing, MediumSpacing);
  const double first = -0.5 * MediumSpacing * (MediumSamples - 1);
  medium->SetOrigin(first, first, first);
  medium->AllocateScalars(VTK_FLOAT, 1);
  medium->GetPointData()->GetScalars()->Fill(0.0);

  filter->SetInputData(0, medium);
  filter->SetMethodToProxy();
  filter->SetSolverToPrecise();
  filter->SetMetersPerWorldUnit(0.001);
  vtkHapticProperty* const property = filter->GetProperty();
  SetEverywhere(property->GetStiffness(), stiffness);
  SetEverywhere(property->GetFriction(), 0.0);
  SetEverywhere(property->GetViscosity(), Strength);
  SetEverywhere(property->GetSurfaceStrength(), 0.0);
}
