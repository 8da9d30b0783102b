// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_StereoModes_h
#define Explore_StereoModes_h

#include <string>

class vtkRenderWindow;

namespace Explore
{
/// Returns VTK's number of a stereo mode ("anaglyph"). Throws InputError, with the names, for any
/// other name.
int FindStereoMode(const std::string& name);

/// Prepares a window that has not been shown yet; an empty name means no stereo.
void SetStereo(vtkRenderWindow* window, const std::string& name);
} // namespace Explore

#endif
