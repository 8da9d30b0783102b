// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_MethodScale_h
#define Explore_MethodScale_h

#include "Applications/Explorer/Analysis/VolumeAnalysis.h"

class vtkVolumeHapticsFilter;

namespace Explore
{
/// Prepares every method for this volume, whichever is chosen: SURFACE_PROXY touches the outer
/// surface (IsoValue), and FORCE_FIELD pushes with 1 N at its sharpest position (ForceFieldGain,
/// from the gradients along the body's outer surface). The filter needs its estimator, its scale,
/// and the volume on port 0.
void ScaleMethods(vtkVolumeHapticsFilter* filter, const Analysis& analysis, vtkImageData* body);
} // namespace Explore

#endif
