// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Transfers the latest value from one thread to another without locks. Of three slots, the writer
// owns one, the reader owns one, and the third one is exchanged between them.
#ifndef VolumeHapticsVendorLatest_h
#define VolumeHapticsVendorLatest_h

#include <array>
#include <atomic>

template <typename T>
class Latest
{
public:
  // Called on the writer's thread.
  void Write(const T& value)
  {
    this->Places[this->Own] = value;
    this->Own = this->Between.exchange(this->Own | New, std::memory_order_acq_rel) & ~New;
  }
  // Called on the reader's thread. Returns whether a value was written since the last call.
  bool Update()
  {
    if ((this->Between.load(std::memory_order_relaxed) & New) == 0)
    {
      return false;
    }
    this->Read = this->Between.exchange(this->Read, std::memory_order_acq_rel) & ~New;
    return true;
  }
  const T& Get() const { return this->Places[this->Read]; }

private:
  static constexpr unsigned New = 4;
  std::array<T, 3> Places{};
  unsigned Own = 0;
  unsigned Read = 1;
  std::atomic<unsigned> Between{ 2 };
};

#endif
