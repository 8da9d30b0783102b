// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_ViewFrame_h
#define Explore_ViewFrame_h

#include "vtkVersionMacros.h"
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
#include "vtkVector.h"
#else // before vtkVector had operators
#include "vtkVectorOperators.h"
#endif

#include <string>

namespace Explore
{
/// The user's view of the volume: the camera's axes, seen from its centre. The picture and the tip
/// path share it, so that the trail is on the visible side.
struct ViewFrame
{
  vtkVector3d Centre; // the point that the camera looks at, world units
  vtkVector3d Toward; // unit, from the centre to the camera
  vtkVector3d Right;  // unit, to the right of the picture
  vtkVector3d Up;     // unit, to the top of the picture

  /// Returns the unit direction `right` and `up` degrees away from the camera.
  vtkVector3d Direction(double right, double up) const;
};

/// Makes the view of a camera in front, a little above and to the left of an object that looks
/// along `front` ("-y") with its top at `up` ("+z"). Throws InputError unless both name different
/// axes.
ViewFrame MakeViewFrame(const double centre[3], const std::string& front, const std::string& up);
} // namespace Explore

#endif
