// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_ViewFrame_h
#define Explore_ViewFrame_h

#include "vtkVersionMacros.h"
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
#include "vtkVector.h"
#else // older versions of vtkVector lack operators
#include "vtkVectorOperators.h"
#endif

#include <string>

namespace Explore
{
/// The user's view of the volume: the axes of the camera, relative to the volume's centre. The
/// picture and the tip path use the same view, so that the trail is on the visible side.
struct ViewFrame
{
  vtkVector3d Centre; // focal point of the camera (world)
  vtkVector3d Toward; // unit vector from the centre to the camera
  vtkVector3d Right;  // unit vector to the right of the picture
  vtkVector3d Up;     // unit vector to the top of the picture

  /// Returns the unit direction that is `right` and `up` degrees away from the direction to the
  /// camera.
  vtkVector3d Direction(double right, double up) const;
};

/// Makes the view of a camera in front of an object, slightly above and to the left. The object
/// faces along `front` ("-y"), and its top is along `up` ("+z"). Throws InputError unless both name
/// different axes.
ViewFrame MakeViewFrame(const double centre[3], const std::string& front, const std::string& up);
} // namespace Explore

#endif
