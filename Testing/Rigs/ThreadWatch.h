// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Counts the allocations and locks of one thread. Linking ThreadWatch.cxx replaces operator new,
 * and also malloc and pthread_mutex_lock unless a sanitizer has replaced them.
 */
#ifndef ThreadWatch_h
#define ThreadWatch_h

#include <cstddef>
#include <mutex>

namespace servotest
{
struct Watched
{
  std::size_t Allocations = 0;
  std::size_t Locks = 0;
};

void WatchThisThread(bool on) noexcept;
Watched GetWatched() noexcept;
bool CanSeeLocks() noexcept;
} // namespace servotest

#endif
