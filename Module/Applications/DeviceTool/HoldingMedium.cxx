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

constexpr double Strength = 1000.0; // N, much more than any device has
constexpr double Spacing = 40.0;    // mm
constexpr int Samples = 13;         // beyond every device's workspace

void SetConstant(vtkPiecewiseFunction* function, double value)
{
  function->RemoveAllPoints();
  function->AddPoint(0.0, value);
}

} // namespace

void MakeHoldingMedium(vtkVolumeHapticsFilter* filter, double stiffness)
{
  vtkNew<vtkImageData> medium;
  medium->SetDimensions(Samples, Samples, Samples);
  medium->SetSpacing(Spacing, Spacing, Spacing);
  const double first = -0.5 * Spacing * (Samples - 1);
  medium->SetOrigin(first, first, first);
  medium->AllocateScalars(VTK_FLOAT, 1);
  medium->GetPointData()->GetScalars()->Fill(0.0);

  filter->SetInputData(0, medium);
  filter->SetMethodToProxy();
  filter->SetSolverToPrecise();
  filter->SetMetersPerWorldUnit(0.001);
  vtkHapticProperty* const property = filter->GetProperty();
  SetConstant(property->GetStiffness(), stiffness);
  SetConstant(property->GetFriction(), 0.0);
  SetConstant(property->GetViscosity(), Strength);
  SetConstant(property->GetSurfaceStrength(), 0.0);
}
