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

/** Number of packets that the kernel stores for a reader. */
constexpr int LongestQueue = 64;

/**
 * A device that is claimed and open. A call waits at most for its time limit, or for the kernel's 5
 * s for USB.
 */
class HidPort
{
public:
  HidPort() = default;
  ~HidPort() { this->Close(); }
  HidPort(const HidPort&) = delete;
  HidPort& operator=(const HidPort&) = delete;

  /**
   * Opens and claims a device. Returns false and writes the reason and the cure to `error` if this
   * fails. IsInUse() then returns whether another holder is the reason.
   */
  bool Open(const HidDeviceInfo& info, std::string& error);
  void Close() noexcept;
  bool IsInUse() const noexcept { return this->InUse; }

  /**
   * Reads a report to `bytes`. Waits at most `time` (ms). Returns the report's size, 0 if none
   * came, or a negative number if the device is gone.
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
   * Makes Write() a system call, without the library, which may take memory. For a handler of a
   * crash.
   */
  void WriteByClaim() noexcept { this->WritesByClaim = true; }
  /**
   * Allows reports to be sent again. After the kernel has waited in vain for the device to accept a
   * report, no more reports are sent until this call: each would wait as long, and the device's own
   * watchdog has already ended its force.
   */
  void TryAgain() noexcept { this->Stuck = false; }
  /**
   * Reads the feature report whose id is the first byte of `report`. Returns its size including the
   * id, or a negative number if there is no such report.
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
