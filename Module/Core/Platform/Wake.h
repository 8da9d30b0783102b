// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A signal that wakes one thread. On Linux it is a descriptor, which a thread may poll together
 * with others, and on Windows an event. On macOS there is none here, and threads poll every
 * millisecond.
 */
#ifndef Wake_h
#define Wake_h

namespace VolumeHaptics
{
namespace Wake
{

/** Makes a signal. Returns its handle, or a negative number on failure. */
int Open() noexcept;
void Close(int wake) noexcept;
/** Wakes the waiting thread. If no thread waits, the next call of Wait() returns at once. */
void Set(int wake) noexcept;
void Clear(int wake) noexcept;
/** Waits at most `time` ms until the signal is set, and clears it. */
void Wait(int wake, int time) noexcept;

} // namespace Wake
} // namespace VolumeHaptics

#endif
