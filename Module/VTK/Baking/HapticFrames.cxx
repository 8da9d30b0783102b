// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Baking/HapticFrames.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace VolumeHaptics
{
namespace
{

HapticFrame CopyFrame(vtkImageData* image, vtkDataArray* array, double time)
{
  HapticFrame frame{ time, vtkSmartPointer<vtkImageData>::New(), nullptr };
  frame.Image->CopyStructure(image);
  frame.Image->SetFieldData(image->GetFieldData());
  if (array)
  {
    frame.Array.TakeReference(array->NewInstance());
    frame.Array->DeepCopy(array);
    frame.Array->SetName(array->GetName());
  }
  return frame;
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

std::vector<HapticFrame> CollectFrames(vtkAlgorithm* filter, const std::vector<double>& steps,
  double last, const TouchedArrayOf& getArray)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const auto after = std::lower_bound(steps.begin() + 1, steps.end(), last);
  const auto end = after == steps.end() ? after : after + 1;
  // Not CONTINUE_EXECUTING: if a source fails, VTK's executive then repeats the request for ever.
  const int port = filter->GetInputConnection(0, 0)->GetIndex();
  auto* const source = Pipeline::SafeDownCast(filter->GetInputExecutive(0, 0));
  std::vector<HapticFrame> frames;
  for (auto step = std::make_reverse_iterator(end); step != steps.rend(); ++step)
  {
    source->GetOutputInformation(port)->Set(Pipeline::UPDATE_TIME_STEP(), *step);
    if (!source->Update(port))
    {
      return {};
    }
    vtkImageData* const image = vtkImageData::SafeDownCast(filter->GetInputDataObject(0, 0));
    frames.push_back(CopyFrame(image, getArray(image), *step));
  }
  std::reverse(frames.begin(), frames.end());
  return frames;
}

} // namespace VolumeHaptics
