// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The lock that gives a HID device to one holder alone.
 *
 * Linux lets any number of programs open a hidraw node, and each of them send forces. This lock
 * (flock) on the node keeps out every other holder that uses it, in this process and in others.
 * Software that does not use the lock, such as a joystick driver of the kernel, is not kept out.
 */
#ifndef HidClaim_h
#define HidClaim_h

#include <cstdint>
#include <mutex>
#include <string>

namespace VolumeHaptics
{

/**
 * Returns the mutex for hidapi's functions that take no device, because they share one error
 * message, and for every HidClaim::Own, because testing whether a device is free claims it for a
 * moment.
 */
std::mutex& GetHidMutex();

/** Holds the lock on a node. */
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

private:
  int Descriptor = -1;
};

} // namespace VolumeHaptics

#endif
