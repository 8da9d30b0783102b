// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Sends zero force when the process ends or stops.
 *
 * While a servo is guarded, every signal that would end or stop the process reaches a handler of
 * this library first (GuardedSignal.h). Handlers may not use a device: they wake a thread of its
 * own through a pipe, and this thread quenches every servo. It then sends SIGINT, SIGTERM, SIGHUP,
 * SIGQUIT and SIGTSTP (Ctrl+Z) again, for the earlier handlers. At a crash (SIGSEGV, SIGABRT and
 * the like) the crashed thread waits until the servos are quenched. This takes milliseconds (2 s at
 * most, if the device's driver hangs or the machine is very busy). Then the crash continues as it
 * would without this library, in another handler, a debugger or the end of the process, with the
 * stack unchanged. SIGPIPE, SIGALRM, SIGUSR1 and others that seldom end a process are left alone if
 * they are handled or ignored.
 *
 * std::terminate, exit() and quick_exit() quench, too. Nothing runs in the process after SIGKILL,
 * SIGSTOP, _exit(), exec() or a loss of power; and real-time signals are not handled, because
 * libraries choose theirs from the unhandled ones. In these cases only the device's own watchdog
 * ends the force.
 */
#ifndef HapticSignals_h
#define HapticSignals_h

namespace VolumeHaptics
{

class ServoThreads;

/**
 * Guards a servo. Call this from the owner's thread when a servo starts and each time it is armed,
 * because a signal that the process survives removes the guard. Release a servo before destroying
 * it. Throws std::system_error or std::bad_alloc if the process gets no more files, threads or
 * memory; do not arm a servo that was not guarded before.
 */
void GuardServo(ServoThreads* servo);
void ReleaseServo(ServoThreads* servo);

} // namespace VolumeHaptics

#endif
