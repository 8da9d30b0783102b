// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_Display_h
#define Explore_Display_h

class vtkRenderWindow;

namespace Explore
{
/// Returns whether the environment names a display, or windows do not need one. Without a display,
/// VTK's X11 windows abort the program, also off screen.
bool HasDisplay();

/// Sets the window's dots per inch to those of its screen, which scales all texts and the spaces
/// around them: 72 in VTK correspond to 96 on a screen. If a screen reports at most 105, as most do
/// regardless of their size, the window stays unchanged; more than 300 count as 300. The desktop's
/// own scale (the X resource Xft.dpi) has priority over the screen's report.
void ApplyScreen(vtkRenderWindow* window);
} // namespace Explore

#endif
