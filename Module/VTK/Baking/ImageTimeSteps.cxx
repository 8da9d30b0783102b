// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Baking/ImageTimeSteps.h"

#include "Core/Field/Estimates/EdgeMotion.h"
#include "Core/Model/BakedVolume.h"
#include "VTK/Base/ArrayMemory.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkDataArray.h"
#include "vtkHapticTimeStepSource.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

namespace VolumeHaptics
{
namespace
{

/** Returns the width (samples) by which an estimator blurs edges. */
double ComputeBlur(const GradientKernel& kernel)
{
  switch (kernel.Estimator)
  {
    case GradientEstimator::CentralDifference:
      return kernel.Radius / std::sqrt(3.0); // standard deviation of a uniform distribution two
                                             // radii wide
    case GradientEstimator::Gaussian:
      return GradientKernel::ScalePerRadius * kernel.Radius;
    case GradientEstimator::CubicBSpline:
      break;
  }
  return 1.0 / std::sqrt(3.0);
}

/** Copies displacements to the layout that Core reads: one tuple after another. */
vtkSmartPointer<vtkDataArray> CopyDisplacements(vtkDataArray* array)
{
  const auto copy = CopyArray(array, array->GetDataType() == VTK_FLOAT ? VTK_FLOAT : VTK_DOUBLE);
  copy->SetName(array->GetName());
  return copy;
}

/** Returns the index of the first number that is not finite; -1 if all are. */
template <typename T>
vtkIdType FindNotFiniteOf(const T* numbers, vtkIdType count)
{
  const T* const found =
    std::find_if(numbers, numbers + count, [](T number) { return !std::isfinite(number); });
  return found == numbers + count ? -1 : found - numbers;
}
vtkIdType FindNotFinite(vtkDataArray* array)
{
  const void* const numbers = array->GetVoidPointer(0);
  return array->GetDataType() == VTK_FLOAT
    ? FindNotFiniteOf(static_cast<const float*>(numbers), array->GetNumberOfValues())
    : FindNotFiniteOf(static_cast<const double*>(numbers), array->GetNumberOfValues());
}

/**
 * Makes a time step from an image, copying the touched array unless `isKept`.
 * @param isKept whether the source leaves the array's memory unchanged when it makes other time
 * steps
 */
ImageTimeStep CopyTimeStep(vtkImageData* image, vtkDataArray* array, double time,
  const std::string& displacements, bool isKept)
{
  ImageTimeStep timeStep{ time, vtkSmartPointer<vtkImageData>::New(), nullptr, nullptr };
  vtkDataArray* const motion =
    displacements.empty() ? nullptr : image->GetPointData()->GetArray(displacements.c_str());
  if (motion)
  {
    timeStep.Displacements = CopyDisplacements(motion);
  }
  timeStep.Image->CopyStructure(image);
  timeStep.Image->SetFieldData(image->GetFieldData());
  if (isKept)
  {
    timeStep.Array = array;
  }
  else if (array)
  {
    timeStep.Array = CopyArray(array);
    timeStep.Array->SetName(array->GetName());
  }
  return timeStep;
}

} // namespace

std::vector<double> ReadTimeSteps(vtkInformation* input)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (!input || !input->Has(Pipeline::TIME_STEPS()))
  {
    return {};
  }
  const double* const given = input->Get(Pipeline::TIME_STEPS());
  std::vector<double> steps;
  std::copy_if(given, given + input->Length(Pipeline::TIME_STEPS()), std::back_inserter(steps),
    [](double time) { return std::isfinite(time); });
  std::sort(steps.begin(), steps.end());
  steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
  return steps.size() > 1 ? steps : std::vector<double>();
}

TimeStepSeries MakeSeries(const std::vector<double>& steps)
{
  const double first = steps.front();
  const double last = steps.back();
  return { first, last, (last - first) / static_cast<double>(steps.size() - 1) };
}

bool ReadTimeStep(
  vtkAlgorithm* filter, double step, const TimeStepReading& reading, ImageTimeStep& timeStep)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  // Don't use CONTINUE_EXECUTING: with it, VTK's executive repeats the request for ever if a source
  // fails.
  const int port = filter->GetInputConnection(0, 0)->GetIndex();
  auto* const source = Pipeline::SafeDownCast(filter->GetInputExecutive(0, 0));
  source->GetOutputInformation(port)->Set(Pipeline::UPDATE_TIME_STEP(), step);
  vtkImageData* const image =
    source->Update(port) ? vtkImageData::SafeDownCast(filter->GetInputDataObject(0, 0)) : nullptr;
  if (!image)
  {
    return false;
  }
  const bool isKept =
    vtkHapticTimeStepSource::SafeDownCast(filter->GetInputAlgorithm(0, 0)) != nullptr;
  timeStep = CopyTimeStep(image, reading.GetArray(image), step, reading.Displacements, isKept);
  timeStep.Component = reading.Component;
  return true;
}

std::vector<ImageTimeStep> CollectTimeSteps(vtkAlgorithm* filter, const std::vector<double>& steps,
  double last, const TimeStepReading& reading)
{
  const auto after = std::lower_bound(steps.begin() + 1, steps.end(), last);
  const auto end = after == steps.end() ? after : after + 1;
  std::vector<ImageTimeStep> timeSteps;
  for (auto step = std::make_reverse_iterator(end); step != steps.rend(); ++step)
  {
    timeSteps.emplace_back();
    if (!ReadTimeStep(filter, *step, reading, timeSteps.back()))
    {
      return {};
    }
  }
  std::reverse(timeSteps.begin(), timeSteps.end());
  return timeSteps;
}

std::vector<ImageTimeStep> MakeComponentTimeSteps(
  vtkImageData* image, vtkDataArray* array, double spacing)
{
  std::vector<ImageTimeStep> timeSteps;
  for (int component = 0; component < array->GetNumberOfComponents(); ++component)
  {
    timeSteps.push_back({ spacing * component, image, array, nullptr, component });
  }
  return timeSteps;
}

bool ReadDisplacements(
  const ImageTimeStep& step, const std::string& name, VolumeTimeStep& timeStep, std::string& error)
{
  vtkDataArray* const array = step.Displacements;
  const std::int64_t* const n = timeStep.View.Dimensions;
  const std::string cure = " Correct it, or blend the time steps in place with "
                           "SetDisplacementArrayName(\"\").";
  std::ostringstream message;
  message << "The input image at time " << step.Time << " on input port 0 ";
  if (!array)
  {
    message << "has no numeric point array \"" << name
            << "\" with the displacements to the next time step: all time steps but the last one "
               "need it.";
  }
  else if (array->GetNumberOfComponents() != 3)
  {
    message << "has an array \"" << name << "\" of " << array->GetNumberOfComponents()
            << " components: displacements have three, along the world's axes.";
  }
  else if (array->GetNumberOfTuples() != n[0] * n[1] * n[2])
  {
    message << "has an array \"" << name << "\" of " << array->GetNumberOfTuples()
            << " displacements for " << n[0] * n[1] * n[2]
            << " points: it needs one for each point.";
  }
  else if (const vtkIdType wrong = FindNotFinite(array); wrong >= 0)
  {
    message << "has a displacement in the array \"" << name << "\", that of point " << wrong / 3
            << ", which is not finite: give points whose motion is not known the displacement 0, "
               "or that of points nearby.";
  }
  else
  {
    array->Register(nullptr);
    timeStep.DisplacementSamples = { static_cast<const void*>(array),
      [array](const void*) { array->UnRegister(nullptr); } };
    timeStep.Displacements = { array->GetVoidPointer(0),
      array->GetDataType() == VTK_FLOAT ? ScalarType::Float32 : ScalarType::Float64 };
    return true;
  }
  error = message.str() + cure;
  return false;
}

std::string DescribeFastMotion(
  const BakedVolume& volume, const std::vector<std::size_t>& pairs, double noise)
{
  const std::vector<FieldTimeStep>& timeSteps = volume.TimeSteps;
  EdgeMotion worst;
  std::size_t at = 0;
  for (const std::size_t i : pairs)
  {
    const EdgeMotion found =
      MeasureEdgeMotion(timeSteps[i].Field.GetView(), timeSteps[i + 1].Field.GetView(),
        volume.IndexToWorld.Linear, ComputeBlur(volume.Kernel), noise);
    if (found.IsFast() &&
      (worst.Fast == 0 || found.Motion * worst.Width > worst.Motion * found.Width))
    {
      worst = found;
      at = i;
    }
  }
  if (worst.Fast == 0)
  {
    return {};
  }
  std::ostringstream message;
  message << "Edges of the image on input port 0 move by about " << worst.Motion
          << " world units from time " << timeSteps[at].Time << " to time "
          << timeSteps[at + 1].Time << ", and are only " << worst.Width
          << " wide, as the kernel smooths them. A blend of frames is a motion up to twice that "
             "width; beyond, surfaces fade out here and in there. Smooth the image to a width of "
          << 0.5 * worst.Motion
          << " or more, for example with vtkImageGaussianSmooth, or give the time steps "
             "displacements (SetDisplacementArrayName).";
  return message.str();
}

} // namespace VolumeHaptics
