// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Computes the modification times of the objects that a servo feels.
 */
#ifndef HapticChangeTime_h
#define HapticChangeTime_h

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkHapticRegionSource.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>

namespace VolumeHaptics
{

/**
 * Returns the latest modification time of an algorithm and everything upstream of it; 0 without an
 * algorithm.
 */
inline vtkMTimeType ComputePipelineTime(vtkAlgorithm* source)
{
  auto* const pipeline =
    vtkDemandDrivenPipeline::SafeDownCast(source ? source->GetExecutive() : nullptr);
  if (!pipeline)
  {
    return source ? source->GetMTime() : 0;
  }
  pipeline->UpdatePipelineMTime();
  return pipeline->GetPipelineMTime();
}

/**
 * Returns the latest modification time of a filter, its surface and its label image; 0 without a
 * filter.
 */
inline vtkMTimeType ComputeChangeTimeBesideImage(vtkVolumeHapticsFilter* filter)
{
  vtkMTimeType time = filter ? filter->GetMTime() : 0;
  for (const int port : { 2, 3 }) // ports of the surface and the labels
  {
    vtkAlgorithm* const source = filter ? filter->GetInputAlgorithm(port, 0) : nullptr;
    vtkDataObject* const data = filter ? filter->GetInputDataObject(port, 0) : nullptr;
    time = std::max({ time, source ? source->GetMTime() : 0, data ? data->GetMTime() : 0 });
  }
  return time;
}

/**
 * Returns the latest modification time of a filter, its image, surface and label image; 0 without a
 * filter. For a moving image (`isMoving`), uses the pipeline that produces the image instead of the
 * image itself, because each request of a time step changes the image.
 */
inline vtkMTimeType ComputeChangeTime(vtkVolumeHapticsFilter* filter, bool isMoving = false)
{
  if (!filter)
  {
    return 0;
  }
  vtkAlgorithm* const source = filter->GetInputAlgorithm(0, 0);
  vtkDataObject* const image = filter->GetInputDataObject(0, 0);
  vtkAlgorithm* const regions = filter->GetRegionSource();
  const bool isStep = isMoving && filter->GetFrames() == vtkVolumeHapticsFilter::TIME_STEPS;
  const vtkMTimeType sourceTime =
    isStep ? ComputePipelineTime(source) : (source ? source->GetMTime() : 0);
  return std::max({ ComputeChangeTimeBesideImage(filter), sourceTime,
    regions ? regions->GetMTime() : 0, image && !isStep ? image->GetMTime() : 0 });
}

} // namespace VolumeHaptics

#endif
