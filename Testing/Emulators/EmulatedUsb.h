// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A USB port of umockdev's simulated computer, with a device in it. The port answers libusb's
 * requests to the kernel, and passes the data to a model.
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
   * Plugs the device in, with a new address.
   * @param port in the form of sysfs: "1-2" is bus 1, port 2
   */
  EmulatedUsb(UsbModel& model, const std::string& port);
  /** Unplugs the device. */
  ~EmulatedUsb();
  EmulatedUsb(const EmulatedUsb&) = delete;
  EmulatedUsb& operator=(const EmulatedUsb&) = delete;

  ///@{
  /**
   * Plug the device in or out, with the kernel's events. Unplug() makes pending transfers fail with
   * ESHUTDOWN.
   */
  void PlugIn();
  void Unplug();
  ///@}

  /** Returns the path of the file that replaces the device's node. */
  std::string GetNode() const;
  /**
   * Binds a kernel driver to interface 0, as if the device had just been plugged in. "" stands for
   * no driver.
   */
  void BindDriver(const std::string& name);
  std::string GetDriver() const;
  /** Returns whether a program has claimed interface 0. */
  bool IsClaimed() const;

  /**
   * Acts as if the program that has claimed the device had been killed, because umockdev does not
   * report a program that ends in the middle of an answer.
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
