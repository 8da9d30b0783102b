// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The behaviour of an emulated device, apart from its carrier: umockdev in the tests, or a virtual
 * USB port of a real kernel.
 *
 * The carrier calls a model from one thread at a time, but not always from the same thread.
 */
#ifndef DeviceModels_h
#define DeviceModels_h

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace emulated
{

/** A USB device: results are sizes in bytes, or -errno; -EPIPE stalls. */
class UsbModel
{
public:
  virtual ~UsbModel() = default;
  /** The device descriptor, followed by the configuration descriptor. */
  virtual std::vector<std::uint8_t> GetDescriptors() const = 0;
  virtual int Control(const std::uint8_t setup[8], std::uint8_t* data, int size) = 0;
  virtual int Out(std::uint8_t endpoint, const std::uint8_t* bytes, int size) = 0;
  /** -EAGAIN if no data are ready: the carrier asks again after every Out and every Ready. */
  virtual int In(std::uint8_t endpoint, std::uint8_t* bytes, int size) = 0;
  /** The host has closed the device, if the carrier can detect that. */
  virtual void Released() {}

  /** Set by the carrier: the model calls it if In has data of its own accord. */
  std::function<void()> Ready = [] {};
};

/** A HID device: reports begin with their id, 0 if the device has none. */
class HidModel
{
public:
  virtual ~HidModel() = default;
  virtual std::uint16_t GetVendor() const = 0;
  virtual std::uint16_t GetProduct() const = 0;
  virtual std::string GetName() const = 0;
  virtual std::vector<std::uint8_t> GetReportDescriptor() const = 0;
  /** Returns the size, or -errno. */
  virtual int Output(const std::uint8_t* report, int size) = 0;
  virtual int SetFeature(const std::uint8_t*, int size) { return size; }
  /** Fills in the bytes after the id; returns the size with the id, or -errno. */
  virtual int GetFeature(std::uint8_t* report, int size) = 0;

  /**
   * Set by the carrier: the model calls it with an input report, without the id if the device has
   * none.
   */
  std::function<void(const std::uint8_t* report, int size)> Input = [](const std::uint8_t*, int) {};
  bool TellsSerial = true; ///< whether it has a serial number
  bool IsBluetooth =
    false; ///< its bus is 0005 instead of USB's 0003, and it has no USB device above
};

} // namespace emulated

#endif
