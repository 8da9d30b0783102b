// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A port of the computer that umockdev plays, with a USB device in it. It answers libusb's requests
 * to the kernel, and passes sent data to a model.
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
   * Plugs the device in, with a new address. The port has sysfs' form: "1-2" is bus 1, port 2.
   */
  EmulatedUsb(UsbModel& model, const std::string& port);
  /** Unplugs the device. */
  ~EmulatedUsb();
  EmulatedUsb(const EmulatedUsb&) = delete;
  EmulatedUsb& operator=(const EmulatedUsb&) = delete;

  ///@{
  /**
   * Plug in and unplug with the kernel's events. Transfers in flight fail with ESHUTDOWN when the
   * device is unplugged.
   */
  void PlugIn();
  void Unplug();
  ///@}

  /** The file that replaces the device, for chmod. */
  std::string GetNode() const;
  /**
   * Binds a kernel driver to interface 0, as if the device had just been plugged in; "" for none.
   */
  void BindDriver(const std::string& name);
  std::string GetDriver() const;
  /** Whether a program has claimed interface 0. */
  bool IsClaimed() const;

  /**
   * Acts as if the program that claimed the device had been killed. umockdev does not report a
   * program that ends in the middle of an answer.
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
