// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A port of the kernel's virtual USB hub (vhci_hcd) with a model plugged in. Everything above the
 * port is a real kernel. This needs root and the module vhci_hcd, and is meant for a virtual
 * machine.
 */
#ifndef VirtualUsb_h
#define VirtualUsb_h

#include "DeviceModels.h"

#include <memory>
#include <thread>

namespace emulated
{
class VirtualUsb
{
public:
  /** Starts with an empty port. The model must outlive the port, which sets the model's Ready. */
  VirtualUsb(UsbModel& model, int port);
  /** Unplugs the device. */
  ~VirtualUsb();
  VirtualUsb(const VirtualUsb&) = delete;
  VirtualUsb& operator=(const VirtualUsb&) = delete;

  /**
   * Plugs the device in. The kernel then requests its descriptors. Throws std::runtime_error if the
   * kernel does not accept the device.
   */
  void Plug();
  /** Unplugs the device; may be called at any time. Returns when the port is free again. */
  void Unplug();

  bool IsPlugged() const { return this->Thread.joinable(); }

private:
  class Descriptor;
  void Serve();

  UsbModel& Model;
  const int Port;
  const std::shared_ptr<Descriptor> Wake; ///< an eventfd, to which Ready writes
  std::unique_ptr<Descriptor> Socket;
  std::thread Thread;
};
} // namespace emulated

#endif
