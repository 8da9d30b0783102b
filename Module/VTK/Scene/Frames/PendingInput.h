// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Queries the window system for waiting input and for the visibility of a window. Also controls how
 * long a window's connection to the X server stays open.
 */
#ifndef PendingInput_h
#define PendingInput_h

class vtkRenderWindow;

namespace VolumeHaptics
{

/**
 * Returns whether key, button or mouse motion events, or a request to close, wait for a window.
 * vtkRenderWindow::GetEventPending() detects only mouse button presses. For an X11 window, searches
 * the event queue without removing anything.
 */
bool HasPendingInput(vtkRenderWindow* window);

/** Returns whether HasPendingInput() sees mouse motion on this window (X11 only). */
bool KnowsInput(vtkRenderWindow* window);

/**
 * Makes the event loop of an X11 window check its timers at once. If timers are late by a second or
 * more, the loop of VTK 9.1 waits for another second unless an event arrives. This function
 * therefore sends an event that no program handles and that HasPendingInput() ignores.
 */
void WakeEventLoop(vtkRenderWindow* window);

/**
 * Returns whether a window may be visible. Returns false for an X11 window if it or its parent is
 * not mapped, because it was minimised, hidden or destroyed, or is behind a tab. Waits for the X
 * server's answer. Returns true for other windows, whose visibility is unknown.
 */
bool MayBeSeen(vtkRenderWindow* window);

/**
 * Makes a window leave its connection to the X server open when it closes. Until VTK 9.2,
 * TerminateApp() closes the window in the middle of the interactor's loop, which goes on using the
 * connection. If the window was rendered before it had an interactor, it owns the connection and
 * closes it, so that the loop crashes. With this function, the connection is closed only when the
 * window is deleted.
 */
void KeepDisplay(vtkRenderWindow* window);

} // namespace VolumeHaptics

#endif
