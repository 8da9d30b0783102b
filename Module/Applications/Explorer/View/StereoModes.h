// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_StereoModes_h
#define Explore_StereoModes_h

#include <string>

class vtkRenderWindow;

namespace Explore
{
/// Returns VTK's constant for a stereo mode, such as "anaglyph". For an unknown name, throws
/// InputError with a list of the names.
int FindStereoMode(const std::string& name);

/// Prepares a window for stereo before it is shown. An empty name means no stereo.
void SetStereo(vtkRenderWindow* window, const std::string& name);
} // namespace Explore

#endif
