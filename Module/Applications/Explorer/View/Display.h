// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_Display_h
#define Explore_Display_h

class vtkRenderWindow;

namespace Explore
{
/// Whether the environment names a display, if windows need one. VTK's X11 windows abort the
/// program without it, also those that are drawn off screen.
bool HasDisplay();

/// Gives the window the dots per inch of its screen, with which all texts and what surrounds them
/// grow: what is 72 for VTK is 96 for a screen. A screen that reports up to 105, as most do
/// whatever they have, leaves the window as it is; one that reports more than 300 is taken to have
/// 300. The desktop's own scale (the X resource Xft.dpi) goes before what the screen reports.
void FollowScreen(vtkRenderWindow* window);
} // namespace Explore

#endif
