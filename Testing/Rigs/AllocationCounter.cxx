// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "AllocationCounter.h"

#include <atomic>
#include <cstdlib>
#include <malloc.h>
#include <new>

namespace
{
#if defined(_WIN32)
/** Header before an aligned block. Stores the block's size, because Windows does not report it. */
struct Head
{
  std::size_t Size = 0;
  void* Begin = nullptr;
};

Head& HeadOf(void* memory)
{
  return static_cast<Head*>(memory)[-1];
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t bytes)
{
  const std::size_t space = alignment > sizeof(Head) ? alignment : sizeof(Head);
  void* const begin = _aligned_malloc(bytes + space, alignment);
  if (!begin)
  {
    return 1;
  }
  *memory = static_cast<char*>(begin) + space;
  HeadOf(*memory) = { bytes, begin };
  return 0;
}
std::size_t malloc_usable_size(void* memory)
{
  return HeadOf(memory).Size;
}
void ReleaseAligned(void* memory)
{
  _aligned_free(HeadOf(memory).Begin);
}
#else
void ReleaseAligned(void* memory)
{
  std::free(memory);
}
#endif

std::atomic<std::size_t> Calls{ 0 };
std::atomic<std::size_t> LiveBytes{ 0 };

void* Allocate(std::size_t bytes, std::size_t alignment = alignof(std::max_align_t))
{
  void* memory = nullptr;
  if (posix_memalign(&memory, alignment, bytes ? bytes : 1) != 0)
  {
    throw std::bad_alloc();
  }
  ++Calls;
  LiveBytes += malloc_usable_size(memory);
  return memory;
}

void Release(void* memory) noexcept
{
  if (memory)
  {
    LiveBytes -= malloc_usable_size(memory);
    ReleaseAligned(memory);
  }
}
} // namespace

namespace coretest
{
Allocations CountAllocations()
{
  return { Calls, LiveBytes };
}
} // namespace coretest

// By default, operator new[] and the non-throwing operators call these operators.
void* operator new(std::size_t bytes)
{
  return Allocate(bytes);
}
void* operator new(std::size_t bytes, std::align_val_t alignment)
{
  return Allocate(bytes, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept
{
  Release(memory);
}
void operator delete(void* memory, std::size_t) noexcept
{
  Release(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept
{
  Release(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept
{
  Release(memory);
}

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
extern "C"
{
  void* __libc_malloc(std::size_t);
  void* __libc_calloc(std::size_t, std::size_t);
  void* __libc_realloc(void*, std::size_t);

  void* malloc(std::size_t bytes)
  {
    ++Calls;
    return __libc_malloc(bytes);
  }
  void* calloc(std::size_t count, std::size_t bytes)
  {
    ++Calls;
    return __libc_calloc(count, bytes);
  }
  void* realloc(void* memory, std::size_t bytes)
  {
    ++Calls;
    return __libc_realloc(memory, bytes);
  }
}
bool coretest::CountsMalloc()
{
  return true;
}
#else
bool coretest::CountsMalloc()
{
  return false;
}
#endif
