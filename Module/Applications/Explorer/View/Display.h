// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_Display_h
#define Explore_Display_h

namespace Explore
{
/// Whether the environment names a display, if windows need one. VTK's X11 windows abort the
/// program without it, also those that are drawn off screen.
bool HasDisplay();
} // namespace Explore

#endif
