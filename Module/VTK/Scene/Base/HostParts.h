// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Parts of a host program, over its scene, that use the mouse.
 */
#ifndef HostParts_h
#define HostParts_h

class vtkRenderWindow;

namespace VolumeHaptics
{

/**
 * Whether a 2D actor, or the representation of one of VTK's widgets, is at a position in a window
 * (pixels). Checks the bodies and handles of representations as far as they list their actors.
 */
bool IsOverPartOfHost(vtkRenderWindow* window, int x, int y);

} // namespace VolumeHaptics

#endif
