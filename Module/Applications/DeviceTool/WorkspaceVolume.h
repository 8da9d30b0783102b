// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Makes a volume that is larger than every device's workspace. One world unit is a millimetre of
 * the device.
 */
#ifndef WorkspaceVolume_h
#define WorkspaceVolume_h

#include <functional>

class vtkPiecewiseFunction;
class vtkVolumeHapticsFilter;

/// Makes a function return `value` everywhere.
void SetEverywhere(vtkPiecewiseFunction* function, double value);

/**
 * Makes the filter touch a field with the method PROXY and the solver PRECISE. `field` returns the
 * value at a position (mm). It is sampled at this spacing (mm), `steps` times to each side of the
 * workspace's centre.
 */
void TouchField(vtkVolumeHapticsFilter* filter, double spacing, int steps,
  const std::function<double(const double* position)>& field);

#endif
