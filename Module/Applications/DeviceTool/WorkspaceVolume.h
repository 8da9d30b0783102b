// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A volume that reaches beyond every device's workspace. One world unit is a millimetre of the
 * device.
 */
#ifndef WorkspaceVolume_h
#define WorkspaceVolume_h

#include <functional>

class vtkPiecewiseFunction;
class vtkVolumeHapticsFilter;

/// Makes a function constant.
void SetEverywhere(vtkPiecewiseFunction* function, double value);

/**
 * Makes the filter touch a field with the proxy and solver PRECISE. The field takes a position
 * (mm). It is sampled at this spacing (mm), `steps` times to each side of the middle of the device.
 */
void TouchField(vtkVolumeHapticsFilter* filter, double spacing, int steps,
  const std::function<double(const double* position)>& field);

#endif
