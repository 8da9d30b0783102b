// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The time of the last change that concerns a servo.
 */
#ifndef HapticChangeTime_h
#define HapticChangeTime_h

#include "vtkDataObject.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>

namespace VolumeHaptics
{

/**
 * When a filter, or its image, surface or label image, last changed; 0 without a filter. If the
 * time steps of a moving image are requested one after the other, the image's own changes don't
 * count.
 */
inline vtkMTimeType FindChangeTime(vtkVolumeHapticsFilter* filter, bool isMoving = false)
{
  if (!filter)
  {
    return 0;
  }
  vtkMTimeType time = filter->GetMTime();
  for (const int port : { 0, 2, 3 }) // the image, the surface, the labels
  {
    vtkAlgorithm* const source = filter->GetInputAlgorithm(port, 0);
    vtkDataObject* const data = filter->GetInputDataObject(port, 0);
    const bool isStep =
      isMoving && port == 0 && filter->GetFrames() == vtkVolumeHapticsFilter::TIME_STEPS;
    time =
      std::max({ time, source ? source->GetMTime() : 0, data && !isStep ? data->GetMTime() : 0 });
  }
  return time;
}

} // namespace VolumeHaptics

#endif
