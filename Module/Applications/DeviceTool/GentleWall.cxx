// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/DeviceTool/GentleWall.h"

#include <vtkFloatArray.h>
#include <vtkHapticProperty.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkVolumeHapticsFilter.h>

namespace
{

constexpr double Stiffness = 200.0;       // N/m: the whole force after 5 mm
constexpr double SurfaceStrength = 100.0; // N, much more than the hand gets: it never falls through
constexpr double Spacing = 4.0;           // mm
constexpr int Samples = 101;              // beyond every device's workspace

void SetConstant(vtkPiecewiseFunction* function, double value)
{
  function->RemoveAllPoints();
  function->AddPoint(0.0, value);
}

} // namespace

void MakeGentleWall(vtkVolumeHapticsFilter* filter, int axis)
{
  vtkNew<vtkImageData> depth; // mm into the wall
  depth->SetDimensions(Samples, Samples, Samples);
  depth->SetSpacing(Spacing, Spacing, Spacing);
  const double first = -0.5 * Spacing * (Samples - 1);
  depth->SetOrigin(first, first, first);
  depth->AllocateScalars(VTK_FLOAT, 1);
  auto* const values = vtkFloatArray::SafeDownCast(depth->GetPointData()->GetScalars());
  for (vtkIdType i = 0; i < depth->GetNumberOfPoints(); ++i)
  {
    values->SetValue(i, static_cast<float>(-depth->GetPoint(i)[axis]));
  }

  filter->SetInputData(0, depth);
  filter->SetMethodToProxy();
  filter->SetSolverToPrecise();
  filter->SetMetersPerWorldUnit(0.001);
  vtkHapticProperty* const property = filter->GetProperty();
  SetConstant(property->GetStiffness(), Stiffness);
  SetConstant(property->GetFriction(), 0.0);
  SetConstant(property->GetViscosity(), 0.0);
  SetConstant(property->GetDistinctness(), 1.0);
  property->GetSurfaceStrength()->RemoveAllPoints();
  property->GetSurfaceStrength()->AddPoint(0.0, 0.0);
  property->GetSurfaceStrength()->AddPoint(0.1, SurfaceStrength);
  property->SetSurfaceSideToHigher();
}
