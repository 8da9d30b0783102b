// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Requests a real-time class from RealtimeKit, a service of Linux desktops that grants it to
 * threads of users who are logged in at the computer.
 *
 * Requests are sent over D-Bus, either to the system bus or to the bus at $DBUS_SYSTEM_BUS_ADDRESS.
 * The library libdbus-1.so.3 is loaded when needed. If the library, the bus or the service is
 * missing, the thread's class does not change. If $VOLUMEHAPTICS_RTKIT is "off", no request is
 * sent.
 *
 * RealtimeKit requires a limit on how long a real-time thread may compute without a pause, usually
 * 200 ms; the kernel ends a process that exceeds it. The process's limit RLIMIT_RTTIME is therefore
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
  Absent, ///< the library, the bus or the service is missing, or requests are switched off
  Refused ///< the service refused, or did not answer
};

/** Settings for RealtimeKit from environment variables. */
struct Wish
{
  bool IsAsked = true;
  std::string Bus; ///< address of the bus
};

/**
 * Reads the settings. The calling thread must be allowed to read the environment: on many systems
 * the process crashes if another thread changes a variable at the same time, as a script may do
 * while the servo runs.
 */
Wish ReadEnvironment();

/**
 * Requests a real-time class for a thread of this process. `thread` is the kernel's number of the
 * thread. Waits at most 10 s for each of the service's three answers, because the service may have
 * to start first. Returns within milliseconds when `stop` is set.
 */
Answer MakeRealTime(std::int64_t thread, const Wish& wish, const std::atomic<bool>& stop) noexcept;

} // namespace RealtimeKit
} // namespace VolumeHaptics

#endif
