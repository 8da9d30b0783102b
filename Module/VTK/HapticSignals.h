// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Zero force when the process is told to end.
 *
 * While a session is guarded, SIGINT, SIGTERM, SIGHUP, SIGQUIT and SIGTSTP (Ctrl+Z) first quench every
 * session, on a thread of its own that a pipe wakes (a signal handler may not touch a device), and are
 * then delivered to whatever handled them before. exit() quenches, too. For a crash there are only the
 * device's own watchdogs.
 */
#ifndef HapticSignals_h
#define HapticSignals_h

namespace VolumeHaptics
{

class HapticSession;

/**
 * From the owner's thread, when a session starts and each time it is armed, since a signal that the
 * process outlives takes the guard away. A session must be released before it is destroyed.
 */
void GuardSession(HapticSession* session);
void ReleaseSession(HapticSession* session);

} // namespace VolumeHaptics

#endif
