// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Detects parts of a host program, such as widgets, that lie over its scene and use the mouse.
 */
#ifndef HostParts_h
#define HostParts_h

class vtkRenderWindow;

namespace VolumeHaptics
{

/**
 * Whether a 2D actor, or the representation of one of VTK's widgets, is at a position in a window
 * (pixels). Representations are checked by the actors that they list.
 */
bool IsOverPartOfHost(vtkRenderWindow* window, int x, int y);

} // namespace VolumeHaptics

#endif
