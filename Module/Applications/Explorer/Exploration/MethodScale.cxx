// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Exploration/MethodScale.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
constexpr double STRONGEST_PUSH = 1.0; // N: clearly felt, and a fraction of what any device holds
constexpr double SHARPEST = 0.95;   // part of the surface that is less sharp; the rest may be noise
constexpr int LOOKS_PER_AXIS = 100; // some thousand points of a surface are enough

/// Adds the points, between two voxels, at which a line of voxels along an axis crosses the
/// threshold.
void AddCrossings(vtkImageData* image, double threshold, int axis, vtkPoints* points)
{
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  const int* const extent = image->GetExtent();
  int step[3], index[3];
  for (int i = 0; i < 3; ++i)
  {
    step[i] = i == axis ? 1 : std::max(1, image->GetDimensions()[i] / LOOKS_PER_AXIS);
  }
  const auto value = [&]() { return scalars->GetComponent(image->ComputePointId(index), 0); };
  for (index[2] = extent[4]; index[2] <= extent[5]; index[2] += step[2])
  {
    for (index[1] = extent[2]; index[1] <= extent[3]; index[1] += step[1])
    {
      for (index[0] = extent[0]; index[0] <= extent[1]; index[0] += step[0])
      {
        const double here = value();
        if (index[axis] == extent[2 * axis + 1])
        {
          continue;
        }
        index[axis] += 1;
        const double there = value();
        double after[3], before[3];
        image->TransformIndexToPhysicalPoint(index, after);
        index[axis] -= 1;
        if ((here > threshold) != (there > threshold))
        {
          image->TransformIndexToPhysicalPoint(index, before);
          const double share = (threshold - here) / (there - here);
          points->InsertNextPoint(before[0] + share * (after[0] - before[0]),
            before[1] + share * (after[1] - before[1]), before[2] + share * (after[2] - before[2]));
        }
      }
    }
  }
}

/// The magnitudes of the gradient at these points (scalar per world unit), by the filter's own
/// estimator.
std::vector<double> Gradients(vtkVolumeHapticsFilter* filter, vtkPoints* points)
{
  vtkNew<vtkPolyData> path;
  path->SetPoints(points);
  vtkNew<vtkVolumeHapticsFilter> field;
  field->SetInputData(0, filter->GetInputDataObject(0, 0));
  field->SetPathData(path);
  field->SetGradientEstimator(filter->GetGradientEstimator());
  field->SetKernelRadius(filter->GetKernelRadius());
  field->SetMethodToForceField();
  field->Update();
  vtkDataArray* const found = field->GetOutput()->GetPointData()->GetArray("GradientMagnitude");
  std::vector<double> gradients;
  for (vtkIdType i = 0; found && i < found->GetNumberOfTuples(); ++i)
  {
    gradients.push_back(found->GetComponent(i, 0));
  }
  return gradients;
}
} // namespace

namespace Explore
{
void ScaleMethods(vtkVolumeHapticsFilter* filter, const Analysis& analysis, vtkImageData* body)
{
  filter->SetIsoValue(analysis.OuterThreshold);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int axis = 0; axis < 3; ++axis)
  {
    AddCrossings(body, analysis.OuterThreshold, axis, points);
  }
  std::vector<double> gradients = Gradients(filter, points);
  if (gradients.empty())
  {
    return;
  }
  const auto at =
    gradients.begin() + static_cast<std::ptrdiff_t>(SHARPEST * (gradients.size() - 1));
  std::nth_element(gradients.begin(), at, gradients.end());
  if (*at > 0.0)
  {
    filter->SetForceFieldGain(STRONGEST_PUSH / *at);
  }
}
} // namespace Explore
