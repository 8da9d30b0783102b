// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Keeps the connection of a window to the X server open until the window is deleted.
 */
#ifndef HapticKeptDisplay_h
#define HapticKeptDisplay_h

class vtkRenderWindow;

namespace VolumeHaptics
{

/**
 * Makes a window leave its connection to the X server open when it closes. Until VTK 9.2,
 * TerminateApp() closes the window in the middle of the interactor's loop, and the loop goes on
 * using the connection. A window that was rendered before it had an interactor owns the connection
 * and has already closed it: a crash. Here the connection is closed when the window is deleted.
 */
void KeepDisplay(vtkRenderWindow* window);

} // namespace VolumeHaptics

#endif
