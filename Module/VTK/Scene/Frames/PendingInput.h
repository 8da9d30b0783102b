// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the window system knows of a window: whether somebody waits for the end of a frame, and
 * whether anybody sees it.
 */
#ifndef PendingInput_h
#define PendingInput_h

class vtkRenderWindow;

namespace VolumeHaptics
{

/**
 * Whether a window has keys, buttons or motions of the mouse, or its closing, to process.
 * vtkRenderWindow::GetEventPending() knows of presses of mouse buttons only; where a window is one
 * of X11, its queue is looked through. Nothing is taken out of it.
 */
bool HasPendingInput(vtkRenderWindow* window);

/** Whether that is known of motions of the mouse, too. */
bool KnowsInput(vtkRenderWindow* window);

/**
 * Has the event loop of a window of X11 look at its timers at once. If timers are late by a second
 * or more, the loop of VTK 9.1 waits for another second, unless there is an event. So this sends
 * one that no program handles and that does not count as input.
 */
void WakeEventLoop(vtkRenderWindow* window);

/**
 * Whether a window may be seen. False for one of X11 that is not mapped, or that lies in another
 * window that is not: it was minimised, hidden, destroyed, or is behind a tab. This waits for the
 * X server's answer. Nothing is known of other windows: true.
 */
bool MayBeSeen(vtkRenderWindow* window);

} // namespace VolumeHaptics

#endif
