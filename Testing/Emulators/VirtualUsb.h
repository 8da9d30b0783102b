// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A port of the kernel's virtual USB hub (vhci_hcd) with a model plugged in: everything above it is
 * a real kernel's.
 *
 * Needs root and the module vhci_hcd; meant for a virtual machine of its own.
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
  /**
   * Nothing is plugged in yet. The model outlives the port; its Ready is set here, and stays set.
   */
  VirtualUsb(UsbModel& model, int port);
  /** Unplugs. */
  ~VirtualUsb();
  VirtualUsb(const VirtualUsb&) = delete;
  VirtualUsb& operator=(const VirtualUsb&) = delete;

  /** The kernel begins to ask for descriptors; std::runtime_error if it takes no devices. */
  void Plug();
  /** In the midst of whatever goes on. Returns once the port is free again. */
  void Unplug();

  bool IsPlugged() const { return this->Thread.joinable(); }

private:
  class Descriptor;
  void Serve();

  UsbModel& Model;
  const int Port;
  const std::shared_ptr<Descriptor> Wake; ///< an eventfd, which Ready writes to
  std::unique_ptr<Descriptor> Socket;
  std::thread Thread;
};
} // namespace emulated

#endif
