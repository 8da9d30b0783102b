// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_Display_h
#define Explore_Display_h

class vtkRenderWindow;

namespace Explore
{
/// Returns whether the environment names a display, or the system's windows need no such name.
/// Without a display, VTK's X11 windows abort the program, even off screen.
bool HasDisplay();

/// Sets the window's dots per inch to those of its screen, which scales all texts and the spaces
/// around them: VTK's 72 correspond to 96 on a screen. If a screen reports at most 105, as most
/// screens do regardless of their size, the window stays unchanged; values above 300 count as 300.
/// The desktop's own scale (the X resource Xft.dpi) has priority over the screen's report.
void ApplyScreen(vtkRenderWindow* window);
} // namespace Explore

#endif
