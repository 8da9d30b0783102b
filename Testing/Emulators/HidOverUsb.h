// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Turns a HID device's model into a USB device: descriptors, requests of the HID class, and two
 * interrupt endpoints.
 */
#ifndef HidOverUsb_h
#define HidOverUsb_h

#include "DeviceModels.h"

#include <deque>
#include <mutex>

namespace emulated
{
class HidOverUsb : public UsbModel
{
public:
  /**
   * The model must outlive this object, which sets the model's Input. Input may be called from any
   * thread.
   */
  explicit HidOverUsb(HidModel& model);

  std::vector<std::uint8_t> GetDescriptors() const override;
  int Control(const std::uint8_t setup[8], std::uint8_t* data, int size) override;
  int Out(std::uint8_t endpoint, const std::uint8_t* bytes, int size) override;
  int In(std::uint8_t endpoint, std::uint8_t* bytes, int size) override;

  /** Drops unread input reports, like a loss of power. */
  void Forget();

private:
  using Bytes = std::vector<std::uint8_t>;

  Bytes MakeHidDescriptor() const;
  int GetDescriptor(const std::uint8_t setup[8], std::uint8_t* data, int size) const;
  int GetReport(std::uint8_t type, std::uint8_t id, std::uint8_t* data, int size);
  int SetReport(std::uint8_t type, const std::uint8_t* data, int size);

  HidModel& Model;
  const Bytes ReportDescriptor;
  const bool HasIds;
  std::mutex Mutex;
  std::deque<Bytes> Inputs;
};
} // namespace emulated

#endif
