// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * An object that exists once in each process, for data that threads share under a mutex.
 *
 * A forked child has copies of its parent's objects. A mutex in such a copy may be locked by a
 * thread that the child does not have. The child therefore makes a new object and never touches the
 * copy.
 */
#ifndef PerProcess_h
#define PerProcess_h

#include "Core/Realtime/ServoClock.h"

#include <atomic>
#include <memory>

namespace VolumeHaptics
{

template <typename T>
class PerProcess
{
public:
  constexpr PerProcess() = default;
  PerProcess(const PerProcess&) = delete;
  PerProcess& operator=(const PerProcess&) = delete;

  /**
   * Returns the object. Any thread may call this. The first call makes the object, and may throw
   * std::bad_alloc. The object is never destroyed, because threads and signal handlers may still
   * use it while the process ends.
   */
  T& Get()
  {
    const std::int64_t process = ServoClock::GetProcess();
    Item* item = this->Current.load();
    while (!item || item->Process != process)
    {
      auto fresh = std::make_unique<Item>();
      fresh->Process = process;
      if (this->Current.compare_exchange_strong(item, fresh.get()))
      {
        item = fresh.release();
      }
    }
    return item->Value;
  }

private:
  struct Item
  {
    std::int64_t Process = 0;
    T Value;
  };

  std::atomic<Item*> Current{ nullptr };
};

} // namespace VolumeHaptics

#endif
