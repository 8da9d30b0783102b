// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_SceneCamera_h
#define Explore_SceneCamera_h

#include "Applications/Explorer/View/ViewFrame.h"

class vtkRenderer;

namespace Explore
{
/// Points the camera at the centre of the view frame, from `distance` along its direction, with its
/// up vector.
void AimCamera(vtkRenderer* renderer, const ViewFrame& view, double distance);

/// Points the camera like AimCamera, from the distance at which the whole box just fits in a
/// picture of this aspect ratio (width / height). If the box itself is not drawn, the distance is a
/// little smaller, because the content is smaller than the box.
void FitCamera(vtkRenderer* renderer, const ViewFrame& view, const double bounds[6], double aspect,
  bool isBoxSeen);
} // namespace Explore

#endif
