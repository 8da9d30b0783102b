// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Passes every value from one thread to another, in order and without waiting, through a ring for
 * one producer and one consumer. If the ring is full, a value is dropped and counted as lost.
 */
#ifndef TraceRing_h
#define TraceRing_h

#include "Core/Realtime/LargePages.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace VolumeHaptics
{

template <typename T>
class TraceRing
{
  static_assert(std::is_trivially_copyable_v<T>);

public:
  /**
   * Makes a ring. The capacity is rounded up to a power of two. Only this function allocates.
   */
  explicit TraceRing(std::size_t capacity)
    : Slot(RoundUp(capacity))
    , Mask(this->Slot.size() - 1)
  {
  }

  /**
   * Adds a value. If the ring is full, returns false and counts a lost value. Only the producer may
   * call this.
   */
  bool Push(const T& value) noexcept
  {
    const std::uint64_t head = this->Head.load(std::memory_order_relaxed);
    if (head - this->TailSeen == this->Slot.size())
    {
      this->TailSeen = this->Tail.load(std::memory_order_acquire);
      if (head - this->TailSeen == this->Slot.size())
      {
        this->Lost.fetch_add(1, std::memory_order_relaxed);
        return false;
      }
    }
    this->Slot[head & this->Mask] = value;
    this->Head.store(head + 1, std::memory_order_release);
    return true;
  }

  /**
   * Removes the oldest value. Returns false if the ring is empty. Only the consumer may call this.
   */
  bool Pop(T& value) noexcept
  {
    const std::uint64_t tail = this->Tail.load(std::memory_order_relaxed);
    if (tail == this->Head.load(std::memory_order_acquire))
    {
      return false;
    }
    value = this->Slot[tail & this->Mask];
    this->Tail.store(tail + 1, std::memory_order_release);
    return true;
  }

  std::uint64_t GetLost() const noexcept { return this->Lost.load(std::memory_order_relaxed); }
  std::size_t GetCapacity() const noexcept { return this->Slot.size(); }
  const void* GetMemory() const noexcept { return this->Slot.data(); }
  std::size_t GetMemorySize() const noexcept { return this->Slot.size() * sizeof(T); }

private:
  static std::size_t RoundUp(std::size_t capacity)
  {
    std::size_t size = 1;
    while (size < capacity)
    {
      size *= 2;
    }
    return size;
  }

  std::vector<T, LargePages<T>> Slot;
  const std::size_t Mask;
  alignas(64) std::atomic<std::uint64_t> Head{ 0 };
  std::uint64_t TailSeen = 0; // the producer's copy of Tail
  alignas(64) std::atomic<std::uint64_t> Tail{ 0 };
  alignas(64) std::atomic<std::uint64_t> Lost{ 0 };
};

} // namespace VolumeHaptics

#endif
