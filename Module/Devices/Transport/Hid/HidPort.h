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

/** The number of packets that the kernel keeps for a reader. */
constexpr int LongestQueue = 64;

/**
 * A device that is claimed and open. No call waits longer than its time limit, or than the kernel's
 * 5 s for USB.
 */
class HidPort
{
public:
  HidPort() = default;
  ~HidPort() { this->Close(); }
  HidPort(const HidPort&) = delete;
  HidPort& operator=(const HidPort&) = delete;

  /**
   * Opens and claims a device. If this fails, returns false and writes the reason and the cure to
   * `error`; IsInUse returns whether another holder is the reason.
   */
  bool Open(const HidDeviceInfo& info, std::string& error);
  void Close() noexcept;
  bool IsInUse() const noexcept { return this->InUse; }

  /**
   * Reads a report to `bytes`. Returns the report's size, 0 if none came within the time (ms),
   * negative if the device is gone.
   */
  int Read(std::uint8_t* bytes, std::size_t size, int time) noexcept;

  ///@{
  /**
   * Sends a report, which begins with its id (0 if the device has none). Returns false if the
   * device refuses the report.
   */
  bool Write(const std::uint8_t* report, std::size_t size) noexcept;
  bool SendFeature(const std::uint8_t* report, std::size_t size) noexcept;
  /**
   * Lets reports be sent again. If the kernel has waited in vain for a device to take a report,
   * nothing more is sent until this call, because each further report would wait as long, and the
   * device's own watchdog has ended its force.
   */
  void TryAgain() noexcept { this->Stuck = false; }
  /**
   * Reads the feature report whose id is the first byte of `report`. Returns the size with the id,
   * negative if there is no such report.
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
};

} // namespace VolumeHaptics

#endif
