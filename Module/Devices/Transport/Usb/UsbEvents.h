// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Waits for USB transfers and for the servo at the same time.
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
  /**
   * Prepares to wait for the transfers of an open interface. Interface and exchange must outlive
   * this object.
   */
  UsbEvents(UsbInterface& usb, HardwareExchange& exchange);

  /**
   * Waits until a transfer has ended (its owner is called), until the exchange wakes up, or for at
   * most `time` (ns). Returns whether the exchange woke up. On systems that can't report this,
   * waits for at most a millisecond and returns true.
   */
  bool Wait(std::int64_t time) noexcept;

  /** Waits only for transfers, for at most `time` (ns). */
  void WaitForTransfers(std::int64_t time) noexcept;

private:
  UsbInterface& Usb;
  HardwareExchange& Exchange;
#if defined(__linux__)
  std::vector<pollfd> Watched; ///< descriptors to wait for; the first one is the exchange's
#endif
};

} // namespace VolumeHaptics

#endif
