// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ThreadWatch.h"

#include <atomic>
#include <cstdlib>
#include <new>

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define THREAD_WATCH_INTERPOSES
#include <dlfcn.h>
#include <pthread.h>
#endif
#if defined(_WIN32)
#include <malloc.h>
#define RELEASE _aligned_free
#else
#define RELEASE std::free
#endif

namespace
{
thread_local bool IsWatched = false;
thread_local bool IsCounted = false; // set while operator new calls malloc, so that only one call
                                     // counts
std::atomic<std::size_t> Allocations{ 0 };
std::atomic<std::size_t> Locks{ 0 };

void CountAllocation() noexcept
{
  Allocations += IsWatched && !IsCounted ? 1 : 0;
}

void* Allocate(std::size_t bytes, std::size_t alignment)
{
  CountAllocation();
  void* memory = nullptr;
  IsCounted = true;
#if defined(_WIN32)
  memory = _aligned_malloc(bytes ? bytes : 1, alignment);
  const bool failed = !memory;
#else
  const int failed = posix_memalign(&memory, alignment, bytes ? bytes : 1);
#endif
  IsCounted = false;
  if (failed)
  {
    throw std::bad_alloc();
  }
  return memory;
}
} // namespace

namespace servotest
{
void WatchThisThread(bool on) noexcept
{
  IsWatched = on;
}

Watched GetWatched() noexcept
{
  return { Allocations, Locks };
}

bool CanSeeLocks() noexcept
{
#ifdef THREAD_WATCH_INTERPOSES
  return true;
#else
  return false;
#endif
}
} // namespace servotest

void* operator new(std::size_t bytes)
{
  return Allocate(bytes, alignof(std::max_align_t));
}
void* operator new(std::size_t bytes, std::align_val_t alignment)
{
  return Allocate(bytes, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept
{
  RELEASE(memory);
}
void operator delete(void* memory, std::size_t) noexcept
{
  RELEASE(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept
{
  RELEASE(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept
{
  RELEASE(memory);
}

#ifdef THREAD_WATCH_INTERPOSES
extern "C"
{
  void* __libc_malloc(std::size_t);
  void* __libc_calloc(std::size_t, std::size_t);
  void* __libc_realloc(void*, std::size_t);

  void* malloc(std::size_t bytes)
  {
    CountAllocation();
    return __libc_malloc(bytes);
  }
  void* calloc(std::size_t count, std::size_t bytes)
  {
    CountAllocation();
    return __libc_calloc(count, bytes);
  }
  void* realloc(void* memory, std::size_t bytes)
  {
    CountAllocation();
    return __libc_realloc(memory, bytes);
  }
  int pthread_mutex_lock(pthread_mutex_t* mutex)
  {
    using Function = int (*)(pthread_mutex_t*);
    static std::atomic<Function> next{ nullptr };
    Function lock = next.load();
    if (!lock)
    {
      lock = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "pthread_mutex_lock"));
      next.store(lock);
    }
    Locks += IsWatched ? 1 : 0;
    return lock(mutex);
  }
}
#endif
