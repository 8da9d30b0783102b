// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_BodyIsolation_h
#define Explore_BodyIsolation_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

namespace Explore
{
/// Returns a copy of the image in which everything outside the largest connected region above
/// `threshold`, and every value that is not finite, is replaced by `fill`. The copy shows a patient
/// without the head rest, tables and cables that would block the view and the planner's rays. The
/// soft edge of the region is kept. The hand feels the original image, not this copy.
vtkSmartPointer<vtkImageData> IsolateBody(vtkImageData* image, double threshold, double fill);

/// Returns the number of voxels above the threshold that are missing from `body`, divided by the
/// number of the body's voxels.
double MeasureHidden(vtkImageData* image, vtkImageData* body, double threshold);
} // namespace Explore

#endif
