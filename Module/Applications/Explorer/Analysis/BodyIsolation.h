// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_BodyIsolation_h
#define Explore_BodyIsolation_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

namespace Explore
{
/// Returns the image with everything outside its largest connected region above `threshold`, and
/// everything that is not finite, set to `fill`. Otherwise head rests, tables and cables would hide
/// a patient from the eye and from the planner's rays. The soft edge of the region stays. The hand
/// feels the image itself, not this copy.
vtkSmartPointer<vtkImageData> IsolateBody(vtkImageData* image, double threshold, double fill);

/// Returns the number of voxels above the threshold that the body lacks, as a fraction of the
/// body's voxels.
double MeasureHidden(vtkImageData* image, vtkImageData* body, double threshold);
} // namespace Explore

#endif
