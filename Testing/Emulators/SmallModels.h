// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Two devices that return the data they receive, for tests of the carriers alone. */
#ifndef SmallModels_h
#define SmallModels_h

#include "DeviceModels.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>

namespace machinetest
{
/**
 * A USB device with two bulk endpoints. Vendor requests without data succeed; all other requests
 * stall.
 */
class EchoUsb : public emulated::UsbModel
{
public:
  std::vector<std::uint8_t> GetDescriptors() const override
  {
    return { 18, 1, 0x00, 0x02, 0, 0, 0, 8, 0x34, 0x12, 0x01, 0x00, 0x00, 0x01, 0, 0, 0, 1, //
      9, 2, 32, 0, 1, 1, 0, 0x80, 45,                                                       //
      9, 4, 0, 0, 2, 0xFF, 0xFF, 0xFF, 0,                                                   //
      7, 5, 0x81, 2, 64, 0, 0, 7, 5, 0x02, 2, 64, 0, 0 };
  }
  int Control(const std::uint8_t setup[8], std::uint8_t*, int) override
  {
    return setup[0] == 0x40 ? 0 : -EPIPE;
  }
  int Out(std::uint8_t, const std::uint8_t* bytes, int size) override
  {
    if (!this->HasRoom)
    {
      return -EAGAIN;
    }
    this->Held.insert(this->Held.end(), bytes, bytes + size);
    return size;
  }
  int In(std::uint8_t, std::uint8_t* bytes, int size) override
  {
    const std::size_t given = std::min(this->Held.size(), static_cast<std::size_t>(size));
    std::copy_n(this->Held.begin(), given, bytes);
    this->Held.erase(this->Held.begin(), this->Held.begin() + static_cast<std::ptrdiff_t>(given));
    return given > 0 ? static_cast<int>(given) : -EAGAIN;
  }

  bool HasRoom = true;

private:
  std::vector<std::uint8_t> Held;
};

/**
 * A HID device with reports of four bytes, with or without ids. Output reports are returned as
 * input reports, and a feature report keeps its value.
 */
class EchoHid : public emulated::HidModel
{
public:
  explicit EchoHid(bool hasIds)
    : HasIds(hasIds)
  {
  }
  std::uint16_t GetVendor() const override { return 0x1234; }
  std::uint16_t GetProduct() const override { return this->HasIds ? 3 : 2; }
  std::string GetName() const override { return this->HasIds ? "Echo with ids" : "Echo"; }
  std::vector<std::uint8_t> GetReportDescriptor() const override
  {
    // Input, output and feature reports have four bytes each.
    std::vector<std::uint8_t> all = { 0x06, 0x00, 0xFF, 0x09, 0x01, 0xA1, 0x01, 0x85, 5, //
      0x15, 0x00, 0x26, 0xFF, 0x00, 0x75, 0x08, 0x95, 0x04,                              //
      0x09, 0x02, 0x81, 0x02, 0x09, 0x03, 0x91, 0x02, 0x09, 0x04, 0xB1, 0x02, 0xC0 };
    if (!this->HasIds)
    {
      all.erase(all.begin() + 7, all.begin() + 9);
    }
    return all;
  }
  int Output(const std::uint8_t* report, int size) override
  {
    const int front = this->HasIds ? 0 : 1;
    this->Input(report + front, size - front);
    return size;
  }
  int SetFeature(const std::uint8_t* report, int size) override
  {
    this->Feature.assign(report, report + size);
    return size;
  }
  int GetFeature(std::uint8_t* report, int size) override
  {
    const std::size_t given = std::min(this->Feature.size(), static_cast<std::size_t>(size));
    std::copy_n(this->Feature.begin(), given, report);
    return static_cast<int>(given);
  }

private:
  const bool HasIds;
  std::vector<std::uint8_t> Feature;
};
} // namespace machinetest

#endif
