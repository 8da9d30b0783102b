// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A signal that wakes one thread. It is a descriptor on Linux, which a thread may watch together
 * with others, and an event on Windows. macOS has none of them here: threads look each millisecond.
 */
#ifndef Wake_h
#define Wake_h

namespace VolumeHaptics
{
namespace Wake
{

/** Makes a signal. Returns its number, or a negative number. */
int Open() noexcept;
void Close(int wake) noexcept;
/** Wakes the thread that waits, or the next one. */
void Set(int wake) noexcept;
/** Clears the signal that Set() has set. */
void Clear(int wake) noexcept;
/** Waits until the signal is set, at most `time` ms, and clears it. */
void Wait(int wake, int time) noexcept;

} // namespace Wake
} // namespace VolumeHaptics

#endif
