// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * RealtimeKit, a service of Linux desktops that gives a real-time class to threads of users who are
 * logged in at the computer.
 *
 * Requests go over D-Bus: the system bus, or the bus at $DBUS_SYSTEM_BUS_ADDRESS. The library
 * libdbus-1.so.3 is loaded when it is needed; without the library, a bus or the service, the thread
 * stays as it is. $VOLUMEHAPTICS_RTKIT=off sends no request.
 *
 * RealtimeKit only serves a process that the kernel ends if one of its real-time threads computes
 * for too long without a pause, as a rule for 200 ms. So the limit RLIMIT_RTTIME of the process is
 * lowered, for good, to the time that the service reports. After half of it the process gets
 * SIGXCPU, so that it can still send zero force.
 */
#ifndef RealtimeKit_h
#define RealtimeKit_h

#include <atomic>
#include <cstdint>
#include <string>

namespace VolumeHaptics
{
namespace RealtimeKit
{

enum class Answer : std::uint8_t
{
  Granted,
  Absent, ///< there is no library, bus or service, or requests are off
  Refused ///< the service refused or did not answer
};

/** The user's settings for RealtimeKit, from environment variables. */
struct Wish
{
  bool IsAsked = true;
  std::string Bus; ///< the bus's address
};

/**
 * Reads the settings. Call it from a thread that may read the environment: on many systems the
 * process crashes if another thread changes a variable meanwhile, as a script may do once the servo
 * runs.
 */
Wish ReadEnvironment();

/**
 * Requests a real-time class for a thread of this process, given by the kernel's thread number.
 * Waits at most 10 s for each of three answers of the service, which may have to be started.
 * Returns within milliseconds once `stop` is set.
 */
Answer MakeRealTime(std::int64_t thread, const Wish& wish, const std::atomic<bool>& stop) noexcept;

} // namespace RealtimeKit
} // namespace VolumeHaptics

#endif
