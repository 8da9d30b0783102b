// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Asks the window system whether input waits for the end of a frame, and whether a window can be
 * seen. Also decides how long a window's connection to the X server stays open.
 */
#ifndef PendingInput_h
#define PendingInput_h

class vtkRenderWindow;

namespace VolumeHaptics
{

/**
 * Returns whether a window has key, button or mouse motion events, or its closing, to process.
 * vtkRenderWindow::GetEventPending() detects only presses of mouse buttons. For a window of X11,
 * this searches the queue of events, and takes nothing out of it.
 */
bool HasPendingInput(vtkRenderWindow* window);

/** Returns whether HasPendingInput() sees mouse motion on this window (X11 only). */
bool KnowsInput(vtkRenderWindow* window);

/**
 * Makes the event loop of an X11 window check its timers at once. If timers are late by a second or
 * more, the loop of VTK 9.1 waits for another second, unless there is an event. So this sends an
 * event that no program handles and that HasPendingInput() ignores.
 */
void WakeEventLoop(vtkRenderWindow* window);

/**
 * Returns whether a window may be visible. Returns false for an X11 window if it or its parent is
 * not mapped: it was minimised, hidden, destroyed, or is behind a tab. Waits for the X server's
 * answer. Returns true for other windows, because nothing is known about them.
 */
bool MayBeSeen(vtkRenderWindow* window);

/**
 * Makes a window leave its connection to the X server open when it closes. Until VTK 9.2,
 * TerminateApp() closes the window in the middle of the interactor's loop, and the loop goes on
 * using the connection. If the window was rendered before it had an interactor, it owns the
 * connection and has closed it, so that the loop crashes. With this function, the connection is
 * closed when the window is deleted.
 */
void KeepDisplay(vtkRenderWindow* window);

} // namespace VolumeHaptics

#endif
