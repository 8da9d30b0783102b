// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The clock of the servo loop, the blocking of signals in its thread, and the process's number.
 */
#ifndef ServoClock_h
#define ServoClock_h

#include <cstdint>

namespace VolumeHaptics
{
namespace ServoClock
{

constexpr double SecondsPerNanosecond = 1e-9;
constexpr double NanosecondsPerSecond = 1e9;
constexpr std::int64_t Millisecond = 1000000; ///< ns

/** Returns the monotonic time (ns). */
std::int64_t Now() noexcept;
/** Returns the time (s) that has passed since `time`, a result of Now(). */
inline double SecondsSince(std::int64_t time) noexcept
{
  return static_cast<double>(Now() - time) * SecondsPerNanosecond;
}
/** Sleeps until `time`, as Now() counts it. Returns at once if it has passed. */
void SleepUntil(std::int64_t time) noexcept;
/**
 * Returns how long (ns) the computer has been suspended since its start, or 0 if the system does
 * not report it.
 */
std::int64_t GetTimeAsleep() noexcept;
/**
 * Blocks the process's signals in the calling thread, so that other threads handle them. Does not
 * block the signals of a crash in this thread.
 */
void BlockSignals() noexcept;
/**
 * Returns the number of this process. A forked child compares it with a stored number to recognize
 * itself. It has copies of all objects, but no other threads, so it must not wait for threads, and
 * the devices belong to the parent.
 */
std::int64_t GetProcess() noexcept;

} // namespace ServoClock
} // namespace VolumeHaptics

#endif
