// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_Display_h
#define Explore_Display_h

class vtkRenderWindow;

namespace Explore
{
/// Whether the environment names a display, if windows need one. Without it, VTK's X11 windows
/// abort the program, also off screen.
bool HasDisplay();

/// Sets the window's dots per inch to its screen's, which scales all texts and their surroundings:
/// 72 in VTK is 96 on a screen. A screen that reports up to 105, as most do regardless of their
/// size, leaves the window as it is; more than 300 counts as 300. The desktop's own scale (the X
/// resource Xft.dpi) has priority over the screen's report.
void ApplyScreen(vtkRenderWindow* window);
} // namespace Explore

#endif
