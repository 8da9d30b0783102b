// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The behaviour of an emulated device, independent of its carrier, which is umockdev in the tests,
 * or a virtual USB port of a real kernel. The carrier's calls of a model never overlap, but may
 * come from different threads.
 */
#ifndef DeviceModels_h
#define DeviceModels_h

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace emulated
{

/** A USB device. Results are sizes in bytes or -errno; -EPIPE stalls. */
class UsbModel
{
public:
  virtual ~UsbModel() = default;
  /** Returns the device descriptor, followed by the configuration descriptor. */
  virtual std::vector<std::uint8_t> GetDescriptors() const = 0;
  virtual int Control(const std::uint8_t setup[8], std::uint8_t* data, int size) = 0;
  virtual int Out(std::uint8_t endpoint, const std::uint8_t* bytes, int size) = 0;
  /**
   * Reads data from the device. Returns -EAGAIN if no data are ready; the carrier then retries
   * after every Out() and every Ready().
   */
  virtual int In(std::uint8_t endpoint, std::uint8_t* bytes, int size) = 0;
  /** Called when the host has closed the device, if the carrier can detect this. */
  virtual void Released() {}

  /**
   * A function that the carrier sets. The model calls it when In() has data that were not caused by
   * an Out().
   */
  std::function<void()> Ready = [] {};
};

/** A HID device. Reports begin with their id, or with 0 if the device has no ids. */
class HidModel
{
public:
  virtual ~HidModel() = default;
  virtual std::uint16_t GetVendor() const = 0;
  virtual std::uint16_t GetProduct() const = 0;
  virtual std::string GetName() const = 0;
  virtual std::vector<std::uint8_t> GetReportDescriptor() const = 0;
  /** Receives an output report. Returns its size, or -errno. */
  virtual int Output(const std::uint8_t* report, int size) = 0;
  virtual int SetFeature(const std::uint8_t*, int size) { return size; }
  /** Fills in the bytes after the id. Returns the size including the id, or -errno. */
  virtual int GetFeature(std::uint8_t* report, int size) = 0;

  /**
   * A function that the carrier sets. The model calls it with each input report, without an id if
   * the device has none.
   */
  std::function<void(const std::uint8_t* report, int size)> Input = [](const std::uint8_t*, int) {};
  bool TellsSerial = true; ///< whether the device has a serial number
  /// whether the device is on bus 0005 without a USB parent, instead of on bus 0003 (USB)
  bool IsBluetooth = false;
};

} // namespace emulated

#endif
