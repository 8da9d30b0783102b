// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Exploration/Exploration.h"

#include "Applications/Explorer/Analysis/BodyIsolation.h"
#include "Applications/Explorer/Errors/InputError.h"
#include "Applications/Explorer/Errors/MessageCapture.h"
#include "Applications/Explorer/Exploration/MethodScale.h"
#include "Applications/Explorer/Exploration/ModeChoice.h"
#include "Applications/Explorer/Exploration/TissueTable.h"
#include "Applications/Explorer/Path/SurfaceMap.h"

#include "vtkDataArray.h"
#include "vtkHapticProperty.h"
#include "vtkHapticRemoval.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkInformationStringKey.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTimerLog.h"
#include "vtkVolumeHapticsFilter.h"

#include <cmath>
#include <sstream>

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
  const auto tell = [&](const char* step, double share)
  {
    if (progress)
    {
      progress(step, share);
    }
  };
  Exploration result;
  tell("Finding the body", 0.4);
  result.Input = volume;
  result.Values = AnalyseVolume(volume.Image, volume.IsField, volume.AreLabels);
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
    // The picture loses what a burr removes from the felt image.
    result.Body->GetPointData()->GetScalars()->GetInformation()->Set(
      vtkHapticRemoval::TOUCHED_ARRAY(), scalars);
  }
  if (!volume.Large && !volume.Frames)
  {
    const double share = MeasureHidden(volume.Image, result.Body, result.Values.OuterThreshold);
    if (share > 0.01)
    {
      std::ostringstream text;
      text << "Felt but not shown: parts that are not joined to the body, such as a head rest ("
           << std::lround(100.0 * share) << " % of its size)";
      result.Hidden = text.str();
      result.Input.Notes.push_back(result.Hidden);
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
      "turn it with --front and --up, or crop it to little more than what is to be felt");
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
