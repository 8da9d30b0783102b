// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A lock that reserves a HID device for one owner.
 *
 * Linux lets any number of programs open a hidraw node and send forces to it. This lock (flock) on
 * the node excludes all other users of the lock, in this process and in others. It can't exclude
 * software without the lock, such as a joystick driver of the kernel.
 */
#ifndef HidClaim_h
#define HidClaim_h

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>

namespace VolumeHaptics
{

/**
 * Returns the mutex for those of hidapi's functions that have no device argument, because they
 * share one error message. It also guards every HidClaim::Own, because a test of whether a device
 * is free claims the device for a moment.
 */
std::mutex& GetHidMutex();

/** The lock on a node. */
class HidClaim
{
public:
  enum class Answer : std::uint8_t
  {
    Held,
    InUse,
    Forbidden,
    Missing
  };

  HidClaim() = default;
  ~HidClaim() { this->Release(); }
  HidClaim(const HidClaim&) = delete;
  HidClaim& operator=(const HidClaim&) = delete;

  Answer Own(const std::string& path) noexcept;
  void Release() noexcept;
  /** Writes a report by a single system call. Returns false if the device refuses it. */
  bool Write(const std::uint8_t* report, std::size_t size) const noexcept;

private:
  int Descriptor = -1;
};

} // namespace VolumeHaptics

#endif
