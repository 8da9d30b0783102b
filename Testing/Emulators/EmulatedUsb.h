// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A port of the computer that umockdev plays, and a USB device in it: what libusb asks the kernel
 * for is answered here, and what it sends goes to a model.
 */
#ifndef EmulatedUsb_h
#define EmulatedUsb_h

#include "DeviceModels.h"

#include <memory>

namespace emulated
{

class EmulatedUsb
{
public:
  /**
   * Plugs the device in, under an address of its own. The port is as in sysfs: "1-2" is bus 1, port
   * 2.
   */
  EmulatedUsb(UsbModel& model, const std::string& port);
  /** Unplugs it. */
  ~EmulatedUsb();
  EmulatedUsb(const EmulatedUsb&) = delete;
  EmulatedUsb& operator=(const EmulatedUsb&) = delete;

  ///@{
  /**
   * With the events that the kernel would send. What flies when it is unplugged fails with
   * ESHUTDOWN.
   */
  void PlugIn();
  void Unplug();
  ///@}

  /** The file that stands for the device, for chmod. */
  std::string GetNode() const;
  /**
   * A driver of the kernel binds to interface 0, as it would when the device is plugged in; "" for
   * none.
   */
  void BindDriver(const std::string& name);
  std::string GetDriver() const;
  /** Whether a program has claimed interface 0. */
  bool IsClaimed() const;

  /**
   * The program that had it was killed. umockdev does not tell if it broke off in the middle of an
   * answer.
   */
  void ForgetProgram();

private:
  class Plug;
  UsbModel& Model;
  const std::string Port;
  std::vector<std::unique_ptr<Plug>> Plugs;
};

} // namespace emulated

#endif
