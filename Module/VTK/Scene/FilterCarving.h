// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the tools of a filter have removed from the array that it touches.
 */
#ifndef FilterCarving_h
#define FilterCarving_h

#include "VTK/Scene/CarvedArray.h"

class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{

/** Nothing is updated. False while nothing was removed from the volume that the filter has now. */
bool FindCarved(vtkVolumeHapticsFilter* filter, CarvedArray& carved);

} // namespace VolumeHaptics

#endif
