// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Passes the latest value from one thread to another. Neither thread waits.
 *
 * There are three slots: one that the writer fills, one that the reader reads, and a spare one with
 * the latest complete value. Each thread exchanges its own slot with the spare one in one atomic
 * operation, so that it never touches the other thread's slot.
 */
#ifndef TripleBuffer_h
#define TripleBuffer_h

#include <atomic>
#include <cstdint>
#include <type_traits>

namespace VolumeHaptics
{

template <typename T>
class TripleBuffer
{
  static_assert(std::is_trivially_copyable_v<T>, "values are copied while the other side runs");

public:
  TripleBuffer() = default;
  TripleBuffer(const TripleBuffer&) = delete;
  TripleBuffer& operator=(const TripleBuffer&) = delete;

  /** Stores a value for the reader. Only the writer may call this. */
  void Write(const T& value) noexcept
  {
    this->Slot[this->Writing].Value = value;
    const std::uint8_t spare = this->Spare.exchange(
      static_cast<std::uint8_t>(this->Writing | Fresh), std::memory_order_acq_rel);
    this->Writing = spare & Index;
  }

  /**
   * Fetches a new value, if there is one, and returns whether there was. Read() returns it until
   * the next new value. Only the reader may call this.
   */
  bool Update() noexcept
  {
    if (!(this->Spare.load(std::memory_order_relaxed) & Fresh))
    {
      return false;
    }
    const std::uint8_t spare = this->Spare.exchange(this->Reading, std::memory_order_acq_rel);
    this->Reading = spare & Index;
    return true;
  }

  /** Returns the value that Update() fetched last. Only the reader may call this. */
  const T& Read() const noexcept { return this->Slot[this->Reading].Value; }

private:
  static constexpr std::uint8_t Index = 3;
  static constexpr std::uint8_t Fresh = 4;

  // A slot with its own cache lines, so that the two threads do not slow each other down.
  struct alignas(64) Padded
  {
    T Value{};
  };

  Padded Slot[3];
  alignas(64) std::uint8_t Writing = 0;
  alignas(64) std::atomic<std::uint8_t> Spare{ 1 };
  alignas(64) std::uint8_t Reading = 2;
};

} // namespace VolumeHaptics

#endif
