// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * An open HID device, through hidapi.
 */
#ifndef HidPort_h
#define HidPort_h

#include "Devices/Transport/Hid/HidClaim.h"
#include "Devices/Transport/Hid/HidDeviceInfo.h"

#include <hidapi.h>

#include <string>

namespace VolumeHaptics
{

/** Number of packets that the kernel buffers for a reader. */
constexpr int LongestQueue = 64;

/**
 * A claimed and open device. A call waits at most for its own time limit, or for the kernel's USB
 * time-out of 5 s.
 */
class HidPort
{
public:
  HidPort() = default;
  ~HidPort() { this->Close(); }
  HidPort(const HidPort&) = delete;
  HidPort& operator=(const HidPort&) = delete;

  /**
   * Opens and claims a device. On failure, returns false and writes the reason and the cure to
   * `error`; IsInUse() then returns whether the device is in use elsewhere.
   */
  bool Open(const HidDeviceInfo& info, std::string& error);
  void Close() noexcept;
  bool IsInUse() const noexcept { return this->InUse; }

  /**
   * Reads a report to `bytes`. Waits at most `time` (ms). Returns the report's size: 0 if none
   * arrived, or a negative number if the device is gone.
   */
  int Read(std::uint8_t* bytes, std::size_t size, int time) noexcept;

  ///@{
  /**
   * Send a report, which begins with its id (0 if the device does not use ids). Return false if the
   * device refuses it.
   */
  bool Write(const std::uint8_t* report, std::size_t size) noexcept;
  bool SendFeature(const std::uint8_t* report, std::size_t size) noexcept;
  /**
   * Makes Write() a plain system call that bypasses the library, which may allocate memory. For a
   * crash handler.
   */
  void WriteByClaim() noexcept { this->WritesByClaim = true; }
  /**
   * Allows reports to be sent again. After the device has failed to accept a report within the
   * kernel's time-out, no more reports are sent until this call: each would wait equally long, and
   * the device's own watchdog has already ended its force.
   */
  void TryAgain() noexcept { this->Stuck = false; }
  /**
   * Reads the feature report whose id is the first byte of `report`. Returns its size including the
   * id, or a negative number if the device has no such report.
   */
  int GetFeature(std::uint8_t* report, std::size_t size) noexcept;
  ///@}

private:
  template <typename F>
  bool Send(F&& send) noexcept;

  hid_device* Device = nullptr;
  HidClaim Claim;
  bool InUse = false;
  bool Stuck = false;
  bool WritesByClaim = false;
};

} // namespace VolumeHaptics

#endif
