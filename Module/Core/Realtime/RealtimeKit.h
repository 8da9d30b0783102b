// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * RealtimeKit, a service of Linux desktops that grants a real-time class to threads of users who
 * are logged in at the computer.
 *
 * Requests are sent over D-Bus, either to the system bus or to the bus at $DBUS_SYSTEM_BUS_ADDRESS.
 * The library libdbus-1.so.3 is loaded when it is needed. Without the library, a bus or the
 * service, the thread's class does not change. If $VOLUMEHAPTICS_RTKIT is "off", no request is
 * sent.
 *
 * RealtimeKit requires a limit on how long a real-time thread may compute without a pause, as a
 * rule 200 ms; the kernel ends a process that exceeds it. So the process's limit RLIMIT_RTTIME is
 * lowered permanently to the time that the service reports. After half of this time, the process
 * receives SIGXCPU, so that it can still send zero force.
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
  Absent, ///< there is no library, bus or service, or requests are switched off
  Refused ///< the service refused, or did not answer
};

/** Settings for RealtimeKit from environment variables. */
struct Wish
{
  bool IsAsked = true;
  std::string Bus; ///< address of the bus
};

/**
 * Reads the settings. Must be called from a thread that may read the environment: on many systems
 * the process crashes if another thread changes a variable at the same time, as a script may do
 * once the servo runs.
 */
Wish ReadEnvironment();

/**
 * Requests a real-time class for a thread of this process. `thread` is the kernel's number of the
 * thread. Waits at most 10 s for each of the service's three answers, because the service may have
 * to be started. Returns within milliseconds when `stop` is set.
 */
Answer MakeRealTime(std::int64_t thread, const Wish& wish, const std::atomic<bool>& stop) noexcept;

} // namespace RealtimeKit
} // namespace VolumeHaptics

#endif
