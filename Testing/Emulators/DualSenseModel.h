// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A DualSense by cable or by Bluetooth.
 *
 * Written from Sony's driver in Linux, drivers/hid/hid-playstation.c (torvalds/linux 0b25b55, and
 * the newer vibration of 6.1): the reports, their sizes and checksums, buttons, the feature
 * reports, and the selection of classic vibration. Checksums are those of zlib, with a preceding
 * byte for the direction. By Bluetooth, a pad sends shortened reports until its calibration is
 * requested, as by SDL's and other drivers. The pad has no watchdog, which is the worst case.
 */
#ifndef DualSenseModel_h
#define DualSenseModel_h

#include "DeviceModels.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <mutex>

#include <zlib.h>

namespace emulated
{

class DualSenseModel : public HidModel
{
public:
  /** Speeds of the motors, from 0 to 255. */
  struct Motors
  {
    int Left = 0;  ///< strong
    int Right = 0; ///< weak
  };

  /** @param version feature version of the firmware, such as 0x0215 for 2.21 */
  DualSenseModel(bool isWireless, int version, bool isEdge = false)
    : IsWireless(isWireless)
    , Version(version)
    , IsEdge(isEdge)
  {
    this->Sticks.fill(128);
    this->Sticks[4] = this->Sticks[5] = 0;
  }

  std::uint16_t GetVendor() const override { return 0x054C; }
  std::uint16_t GetProduct() const override { return this->IsEdge ? 0x0DF2 : 0x0CE6; }
  std::string GetName() const override { return "DualSense Wireless Controller"; }
  std::vector<std::uint8_t> GetReportDescriptor() const override
  {
    // A gamepad with six axes of one byte each. The other fields contain vendor data.
    return { 0x05, 0x01, 0x09, 0x05, 0xA1, 0x01, 0x85, 0x01, 0x09, 0x30, 0x09, 0x31, 0x09, 0x32,
      0x09, 0x35, 0x09, 0x33, 0x09, 0x34, 0x15, 0x00, 0x26, 0xFF, 0x00, 0x75, 0x08, 0x95, 0x06,
      0x81, 0x02, 0x06, 0x00, 0xFF, 0x09, 0x21, 0x95, 0x39, 0x81, 0x02, 0x85, 0x02, 0x09, 0x23,
      0x95, 0x2F, 0x91, 0x02, 0xC0 };
  }

  int Output(const std::uint8_t* report, int size) override
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    if (this->RefusesReports)
    {
      return -EIO;
    }
    const bool isRight = this->IsWireless
      ? size == 78 && report[0] == 0x31 && report[2] == 0x10 && HasChecksum(0xA2, report, 78)
      : size == 63 && report[0] == 0x02;
    if (!isRight)
    {
      ++this->BadReports;
      return size;
    }
    if (this->IsWireless)
    {
      const int number = report[1] >> 4;
      this->BadReports += this->LastNumber >= 0 && number != (this->LastNumber + 1) % 16 ? 1 : 0;
      this->BadReports += report[1] & 0xF ? 1 : 0;
      this->LastNumber = number;
    }
    const std::uint8_t* const common = report + (this->IsWireless ? 3 : 1);
    const bool hasNewer = this->IsEdge || this->Version >= 0x0215;
    const bool isClassic = (common[0] & 1) != 0 || (hasNewer && (common[38] & 4) != 0);
    const bool isSelected = (common[0] & 2) != 0;
    if (isClassic && isSelected)
    {
      this->Now = { common[3], common[2] };
      this->Most = { std::max(this->Most.Left, this->Now.Left),
        std::max(this->Most.Right, this->Now.Right) };
    }
    // The driver must not use the parts of the report for lights, sound and triggers.
    for (int i = 0; i < 47; ++i)
    {
      const bool isKnown = i == 0 || i == 2 || i == 3 || i == 38;
      this->BadReports += (!isKnown && common[i] != 0) || (i == 0 && common[0] > 3) ? 1 : 0;
    }
    ++this->Reports;
    return size;
  }

  int GetFeature(std::uint8_t* report, int size) override
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    const int whole = report[0] == 0x05 ? 41 : report[0] == 0x20 ? 64 : 0;
    if (whole == 0 || size < whole)
    {
      return -EINVAL;
    }
    std::memset(report + 1, 0, static_cast<std::size_t>(whole) - 1);
    if (report[0] == 0x20)
    {
      report[44] = static_cast<std::uint8_t>(this->Version & 0xFF);
      report[45] = static_cast<std::uint8_t>(this->Version >> 8);
    }
    this->IsAwake = this->IsAwake || report[0] == 0x05;
    return whole;
  }

  ///@{
  /**
   * Moves the sticks (x, y, rx, ry) and the triggers (0 to 255 each), and presses buttons by their
   * bits.
   */
  void Move(int axis, int value)
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    this->Sticks[static_cast<std::size_t>(axis)] = static_cast<std::uint8_t>(value);
  }
  void Press(int byte, int bits)
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    this->Buttons[static_cast<std::size_t>(byte)] = static_cast<std::uint8_t>(bits);
  }
  ///@}

  /** Advances by a millisecond. The pad reports every 4 ms. */
  void Step()
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    if (++this->Time % 4 != 0 || this->IsSilent)
    {
      return;
    }
    if (this->IsWireless && !this->IsAwake)
    {
      const std::uint8_t brief[10] = { 1, this->Sticks[0], this->Sticks[1], this->Sticks[2],
        this->Sticks[3], 8, 0, 0, 0, 0 };
      this->Input(brief, 10);
      return;
    }
    std::uint8_t report[78] = {};
    report[0] = this->IsWireless ? 0x31 : 0x01;
    std::uint8_t* const common = report + (this->IsWireless ? 2 : 1);
    std::memcpy(common, this->Sticks.data(), 6);
    common[6] = static_cast<std::uint8_t>(this->Time);
    std::memcpy(common + 7, this->Buttons.data(), 3);
    common[7] = static_cast<std::uint8_t>(common[7] | 8); // the direction pad is released
    if (this->IsWireless)
    {
      const std::uint32_t crc = Checksum(0xA1, report, 74);
      for (int i = 0; i < 4; ++i)
      {
        report[74 + i] = static_cast<std::uint8_t>(crc >> 8 * i);
      }
      report[20] = static_cast<std::uint8_t>(report[20] ^ (this->IsSpoilt ? 1 : 0));
    }
    this->Input(report, this->IsWireless ? 78 : 64);
  }

  Motors GetMotors()
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    return this->Now;
  }
  bool IsStill()
  {
    const Motors motors = this->GetMotors();
    return motors.Left == 0 && motors.Right == 0;
  }
  /** Returns the largest value of each motor since the last call. */
  Motors DrainLargest()
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    const Motors most = this->Most;
    this->Most = {};
    return most;
  }

  std::atomic<bool> IsSilent{ false };
  std::atomic<bool> IsSpoilt{ false }; ///< whether each report over Bluetooth has a wrong bit
  std::atomic<bool> RefusesReports{ false };
  std::atomic<int> BadReports{ 0 }; ///< number of unexpected reports, or parts of reports
  std::atomic<int> Reports{ 0 };

private:
  static std::uint32_t Checksum(std::uint8_t first, const std::uint8_t* bytes, unsigned size)
  {
    return static_cast<std::uint32_t>(crc32(crc32(crc32(0, nullptr, 0), &first, 1), bytes, size));
  }
  static bool HasChecksum(std::uint8_t first, const std::uint8_t* bytes, unsigned size)
  {
    const std::uint8_t* const end = bytes + size - 4;
    const std::uint32_t told = end[0] | end[1] << 8 | end[2] << 16 | std::uint32_t{ end[3] } << 24;
    return Checksum(first, bytes, size - 4) == told;
  }

  const bool IsWireless;
  const int Version;
  const bool IsEdge;
  std::mutex Guard;
  std::array<std::uint8_t, 6> Sticks{};
  std::array<std::uint8_t, 3> Buttons{};
  bool IsAwake = false;
  int Time = 0;
  int LastNumber = -1;
  Motors Now;
  Motors Most;
};

} // namespace emulated

#endif
