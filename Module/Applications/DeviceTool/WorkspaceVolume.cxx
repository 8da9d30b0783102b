// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/DeviceTool/WorkspaceVolume.h"

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkVolumeHapticsFilter.h>

void SetEverywhere(vtkPiecewiseFunction* function, double value)
{
  function->RemoveAllPoints();
  function->AddPoint(0.0, value);
}

void TouchField(vtkVolumeHapticsFilter* filter, double spacing, int steps,
  const std::function<double(const double* position)>& field)
{
  const int samples = 2 * steps + 1;
  const double first = -spacing * steps;
  vtkNew<vtkImageData> image;
  image->SetDimensions(samples, samples, samples);
  image->SetSpacing(spacing, spacing, spacing);
  image->SetOrigin(first, first, first);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* const values = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    values->SetValue(i, static_cast<float>(field(image->GetPoint(i))));
  }
  filter->SetInputData(0, image);
  filter->SetMethodToProxy();
  filter->SetSolverToPrecise();
  filter->SetMetersPerWorldUnit(0.001);
}
