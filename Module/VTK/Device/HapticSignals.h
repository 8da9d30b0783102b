// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Zero force when the process ends or stops.
 *
 * While a servo is guarded, every signal that would end or stop the process reaches a handler of
 * this library first (GuardedSignal.h). Handlers may not touch a device: a thread of its own, which
 * a pipe wakes, quenches every servo. That thread sends SIGINT, SIGTERM, SIGHUP, SIGQUIT and
 * SIGTSTP (Ctrl+Z) again, for the handlers from before. At a crash (SIGSEGV, SIGABRT and the like)
 * the thread that crashed waits for the quenching. This takes milliseconds (2 s at most, if the
 * device's driver hangs or the machine is very busy). Then it meets what was there before: another
 * handler, a debugger or the end, with the stack as it was. SIGPIPE, SIGALRM, SIGUSR1 and others
 * that seldom end a process are left alone if they are handled or ignored.
 *
 * std::terminate, exit() and quick_exit() quench, too. Nothing runs in the process after SIGKILL,
 * SIGSTOP, _exit(), exec() or a loss of power; and real-time signals are not touched, because
 * libraries choose theirs from those that are not handled. In these cases only the device's own
 * watchdog ends the force.
 */
#ifndef HapticSignals_h
#define HapticSignals_h

namespace VolumeHaptics
{

class ServoThreads;

/**
 * Call it from the owner's thread, when a servo starts and each time it is armed, because a signal
 * that the process survives removes the guard. A servo must be released before it is destroyed.
 * Throws std::system_error or std::bad_alloc if the process may have no more files, threads or
 * memory: a servo that was not guarded yet must then not be armed.
 */
void GuardServo(ServoThreads* servo);
void ReleaseServo(ServoThreads* servo);

} // namespace VolumeHaptics

#endif
