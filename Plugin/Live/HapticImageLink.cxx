// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticImageLink.h"

#include "VTK/Base/ArrayMemory.h"

#include "HapticFrameLink.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkSISourceProxy.h"
#include "vtkSMSession.h"
#include "vtkSMSourceProxy.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>

namespace VolumeHapticsLive
{
namespace
{

vtkDataObject* DataOf(vtkAlgorithmOutput* output)
{
  return output ? output->GetProducer()->GetOutputDataObject(output->GetIndex()) : nullptr;
}

/** The time of the last change in the pipeline up to an output; executing is no change. */
vtkMTimeType PipelineTimeOf(vtkAlgorithmOutput* output)
{
  auto* const pipeline =
    vtkDemandDrivenPipeline::SafeDownCast(output->GetProducer()->GetExecutive());
  return pipeline ? pipeline->GetPipelineMTime() : 0;
}

bool HasGeometryOf(vtkImageData* a, vtkImageData* b)
{
  return std::equal(a->GetExtent(), a->GetExtent() + 6, b->GetExtent()) &&
    std::equal(a->GetSpacing(), a->GetSpacing() + 3, b->GetSpacing()) &&
    std::equal(a->GetOrigin(), a->GetOrigin() + 3, b->GetOrigin());
}

bool SharesArrays(vtkImageData* a, vtkImageData* b)
{
  vtkPointData* const arrays = a->GetPointData();
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    const char* const name = arrays->GetArrayName(i);
    vtkAbstractArray* const other = name ? b->GetPointData()->GetAbstractArray(name) : nullptr;
    if (other && other == arrays->GetAbstractArray(i))
    {
      return true;
    }
  }
  return false;
}

/** Whether a time step of an output is next to another one, in either direction. */
bool AreNeighbours(vtkAlgorithmOutput* output, double a, double b)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* const info = output->GetProducer()->GetOutputInformation(output->GetIndex());
  if (!info->Has(Pipeline::TIME_STEPS()))
  {
    return false;
  }
  const double* const begin = info->Get(Pipeline::TIME_STEPS());
  const double* const end = begin + info->Length(Pipeline::TIME_STEPS());
  const double* const step = std::find(begin, end, std::min(a, b));
  return step != end && step + 1 != end && step[1] == std::max(a, b);
}

} // namespace

vtkAlgorithmOutput* HapticImageLink::FindOutput(vtkSMSourceProxy* source, unsigned int port)
{
  if (!source || !source->GetSession())
  {
    return nullptr;
  }
  source->UpdatePipeline();
  auto* const implementation =
    vtkSISourceProxy::SafeDownCast(source->GetSession()->GetSIObject(source->GetGlobalID()));
  return implementation ? implementation->GetOutputPort(static_cast<int>(port)) : nullptr;
}

bool HapticImageLink::IsSeen(vtkDataObject* data, vtkAlgorithm* filter) const
{
  return data == this->Seen && (data ? data->GetMTime() : 0) == this->SeenTime &&
    filter == this->SeenFilter;
}

void HapticImageLink::See(vtkDataObject* data, vtkAlgorithm* filter)
{
  this->Seen = data;
  this->SeenTime = data ? data->GetMTime() : 0;
  this->SeenFilter = filter;
}

void HapticImageLink::Forget()
{
  this->SeenFilter = nullptr;
}

void HapticImageLink::Follow(
  vtkSMSourceProxy* source, unsigned int port, vtkAlgorithm* filter, int filterPort)
{
  vtkDataObject* const data = DataOf(FindOutput(source, port));
  if (this->IsSeen(data, filter))
  {
    return;
  }
  this->See(data, filter);
  vtkSmartPointer<vtkDataObject> copy;
  if (data)
  {
    copy.TakeReference(data->NewInstance());
    copy->ShallowCopy(data);
  }
  filter->SetInputDataObject(filterPort, copy);
}

void HapticImageLink::FollowFrames(vtkSMSourceProxy* source, unsigned int port, double time,
  vtkVolumeHapticsFilter* filter, vtkHapticDevice* device, HapticFrameLink& frames)
{
  vtkAlgorithmOutput* const output = FindOutput(source, port);
  auto* const image = vtkImageData::SafeDownCast(DataOf(output));
  if (!image)
  {
    frames.Clear();
    this->Follow(source, port, filter, 0);
    return;
  }
  const vtkMTimeType pipelineTime = PipelineTimeOf(output);
  const bool isBegun = frames.HasBegun(filter) && pipelineTime == this->PipelineTime &&
    HasGeometryOf(image, frames.GetImage());
  if (isBegun && (this->IsSeen(image, filter) || !frames.IsThere(device)))
  {
    return; // the new image comes when the servo is ready for it
  }
  const bool isInPlace = isBegun && (this->IsInPlace || SharesArrays(image, frames.GetImage()));
  vtkNew<vtkImageData> copy;
  isInPlace ? VolumeHaptics::CopyData(image, copy) : copy->ShallowCopy(image);
  this->See(image, filter);
  this->PipelineTime = pipelineTime;
  this->IsInPlace = isInPlace;
  // Displacements lead only to the next step.
  const bool isStep =
    filter->GetDisplacementArrayName().empty() || AreNeighbours(output, frames.GetTime(), time);
  if (isBegun && time != frames.GetTime() && isStep)
  {
    frames.Go(frames.GetImage(), copy, time, device);
  }
  else
  {
    frames.Begin(copy, time, filter, device);
  }
}

} // namespace VolumeHapticsLive
