// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the window system knows about a window, whether input waits for the end of a frame and
 * whether the window can be seen; and how long a window's connection to the X server stays open.
 */
#ifndef PendingInput_h
#define PendingInput_h

class vtkRenderWindow;

namespace VolumeHaptics
{

/**
 * Whether a window has keys, buttons or motions of the mouse, or its closing, to process.
 * vtkRenderWindow::GetEventPending() knows of presses of mouse buttons only; for a window of X11,
 * this looks through its queue, and takes nothing out of it.
 */
bool HasPendingInput(vtkRenderWindow* window);

/** Whether HasPendingInput() sees mouse motion on this window (X11 only). */
bool KnowsInput(vtkRenderWindow* window);

/**
 * Makes the event loop of an X11 window check its timers at once. If timers are late by a second or
 * more, the loop of VTK 9.1 waits for another second, unless there is an event. So this sends an
 * event that no program handles and that does not count as input.
 */
void WakeEventLoop(vtkRenderWindow* window);

/**
 * Whether a window may be seen. False for an X11 window that is not mapped, or whose parent is not:
 * it was minimised, hidden, destroyed, or is behind a tab. Waits for the X server's answer. True
 * for other windows, about which nothing is known.
 */
bool MayBeSeen(vtkRenderWindow* window);

/**
 * Makes a window leave its connection to the X server open when it closes. Until VTK 9.2,
 * TerminateApp() closes the window in the middle of the interactor's loop, and the loop goes on
 * using the connection. A window that was rendered before it had an interactor owns the connection
 * and has already closed it: a crash. Here the connection is closed when the window is deleted.
 */
void KeepDisplay(vtkRenderWindow* window);

} // namespace VolumeHaptics

#endif
