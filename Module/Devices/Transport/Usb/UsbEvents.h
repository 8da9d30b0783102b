// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A wait for USB transfers and for the servo at once.
 */
#ifndef UsbEvents_h
#define UsbEvents_h

#include "Devices/Common/HardwareExchange.h"
#include "Devices/Transport/Usb/UsbInterface.h"

#if defined(__linux__)
#include <poll.h>
#endif

namespace VolumeHaptics
{

class UsbEvents
{
public:
  /** Of an open interface. Both outlive this. */
  UsbEvents(UsbInterface& usb, HardwareExchange& exchange);

  /**
   * Waits until transfers have ended, which their owners are told, until the exchange wakes up, or
   * for a time (ns). Returns whether the exchange woke up. If the system can't tell, this waits for
   * a millisecond at most and returns true.
   */
  bool Wait(std::int64_t time) noexcept;

  /** The same for transfers alone. */
  void WaitForTransfers(std::int64_t time) noexcept;

private:
  UsbInterface& Usb;
  HardwareExchange& Exchange;
#if defined(__linux__)
  std::vector<pollfd> Watched; ///< the exchange's first
#endif
};

} // namespace VolumeHaptics

#endif
