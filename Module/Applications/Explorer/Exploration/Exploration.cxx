// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Exploration/Exploration.h"

#include "Applications/Explorer/Analysis/BodyIsolation.h"
#include "Applications/Explorer/Analysis/VolumeAnalysis.h"
#include "Applications/Explorer/Exploration/ModeChoice.h"
#include "Applications/Explorer/Exploration/TissueTable.h"
#include "Applications/Explorer/Path/SurfaceMap.h"
#include "VTK/Reading/InputError.h"
#include "VTK/Reading/MessageCapture.h"
#include "VTK/Reading/VolumeChecks.h"

#include "vtkDataArray.h"
#include "vtkHapticProperty.h"
#include "vtkHapticRemoval.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkInformationStringKey.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTimerLog.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace
{
// N: a force that is clearly felt, and a fraction of what any device can exert
constexpr double STRONGEST_PUSH = 1.0;
// quantile of the gradients on the surface; sharper points may be noise
constexpr double SHARPEST = 0.95;
// samples along an axis: some thousand points of a surface suffice
constexpr int LOOKS_PER_AXIS = 100;

/// Adds the points at which lines of voxels along an axis cross the threshold, interpolated between
/// two voxels.
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
          const double fraction = (threshold - here) / (there - here);
          points->InsertNextPoint(before[0] + fraction * (after[0] - before[0]),
            before[1] + fraction * (after[1] - before[1]),
            before[2] + fraction * (after[2] - before[2]));
        }
      }
    }
  }
}

/// Returns the magnitudes of the gradient at these points (scalar per world unit), as the filter's
/// estimator computes them.
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
namespace
{
/// Sets IsoValue (SURFACE_PROXY then touches the outer surface) and ForceFieldGain (FORCE_FIELD
/// then pushes with 1 N where this surface is sharpest), because the user may change the method.
/// The filter's estimator, scale, and volume on port 0 must be set before.

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
} // namespace
} // namespace Explore

namespace
{
using Explore::Estimator;

/// Sets the estimator and returns its name for users.
std::string SetEstimator(vtkVolumeHapticsFilter* filter, Estimator estimator)
{
  switch (estimator)
  {
    case Estimator::CentralDifference:
      filter->SetGradientEstimatorToCentralDifference();
      return "central differences";
    case Estimator::CubicBSpline:
      filter->SetGradientEstimatorToCubicBSpline();
      return "cubic B-spline";
    default:
      filter->SetGradientEstimatorToGaussian();
      return "derivative of a Gaussian";
  }
}
} // namespace

namespace Explore
{
Exploration ExploreVolume(const Volume& volume, const Settings& settings, const Progress& progress)
{
  const auto tell = [&](const char* step, double fraction)
  {
    if (progress)
    {
      progress(step, fraction);
    }
  };
  Exploration result;
  tell("Finding the body", 0.4);
  result.Input = volume;
  result.Values =
    AnalyseVolume(volume.Image, volume.IsField, volume.AreLabels, MayBeHounsfield(volume.Modality));
  vtkDataArray* const scalars = volume.Image->GetPointData()->GetScalars();
  if (result.Values.Kind == VolumeKind::CT && scalars)
  {
    scalars->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), "HU");
  }
  vtkNew<vtkVolumeHapticsFilter> filter;
  result.Materials = ApplyMaterials(settings.Preset, result.Values, volume.Image, filter);
  FitThresholds(filter->GetProperty(), result.Values);
  result.Body = volume.AreLabels
    ? volume.Image
    : IsolateBody(volume.Image, result.Values.OuterThreshold, result.Values.Range[0]);
  if (scalars && result.Body != volume.Image)
  {
    // Makes the displayed body show the tissue that a burr removes from the felt image.
    result.Body->GetPointData()->GetScalars()->GetInformation()->Set(
      vtkHapticRemoval::TOUCHED_ARRAY(), scalars);
  }
  if (!volume.Large && !volume.TimeSteps)
  {
    const double fraction = MeasureHidden(volume.Image, result.Body, result.Values.OuterThreshold);
    if (fraction > 0.01)
    {
      std::ostringstream text;
      text << "Felt but not shown: parts that are not joined to the body, such as a head rest ("
           << std::lround(100.0 * fraction) << " % of its size)";
      result.Hidden = text.str();
      // inserted first, so that it is never cut off
      result.Input.Notes.insert(result.Input.Notes.begin(), result.Hidden);
    }
  }
  MeasureBody(result.Values, result.Body);
  result.View = MakeViewFrame(result.Values.Centre, settings.Front, settings.Up);

  result.Estimator = SetEstimator(filter, settings.Gradient);
  result.KernelRadius = filter->GetKernelRadius();
  result.ServoRate = filter->GetServoRate();
  filter->SetMetersPerWorldUnit(result.Values.MetersPerWorldUnit);

  tell("Planning a path over its surface", 0.6);
  const SurfaceMap map(result.Body, result.Values, result.View);
  if (map.IsEmpty())
  {
    throw InputError(volume.Name, "has no surface that faces the camera",
      "turn it with --front and --up, or crop it closely to what you want to feel");
  }
  result.Tip = PlanTipPath(map, result.View, result.Values.MetersPerWorldUnit, result.ServoRate);

  filter->SetInputData(0, volume.Image);
  if (volume.Labels)
  {
    filter->SetLabelData(volume.Labels);
    filter->SetLabelTable(volume.LabelTable);
  }
  if (volume.AreLabels)
  {
    filter->SetGeometryFromLabels();
  }
  ScaleMethods(filter, result.Values, result.Body);
  const bool isFlow = settings.Method == "auto" && !volume.Flow.empty();
  const std::string method = isFlow ? "primitives"
    : settings.Method == "auto"     ? "proxy"
                                    : settings.Method;
  if (method == "primitives")
  {
    AddModes(settings.Modes, volume.Flow, settings.Guide, volume.Image, filter);
  }
  filter->SetMethodByName(method.c_str());
  result.Method = filter->GetMethodText();
  if (volume.Large)
  {
    filter->SetInputConnection(0, volume.Large->GetOutputPort());
  }
  filter->SetInputData(1, result.Tip.Path);
  tell("Feeling along the path", 0.8);
  const double start = vtkTimerLog::GetUniversalTime();
  {
    const MessageCapture capture;
    filter->Update();
    if (capture.HasErrors() || filter->GetOutput()->GetNumberOfPoints() == 0)
    {
      throw std::runtime_error("the haptic computation failed: " + capture.FirstError());
    }
  }
  result.FilterSeconds = vtkTimerLog::GetUniversalTime() - start;
  result.Filter = filter;
  result.Trace = vtkSmartPointer<vtkPolyData>::New();
  result.Trace->ShallowCopy(filter->GetOutput());
  return result;
}

} // namespace Explore
