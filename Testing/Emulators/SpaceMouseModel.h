// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A six-axis mouse. A hand pushes and turns its cap by counts, which the mouse repeats while the
 * cap is deflected.
 *
 * The source is FreeSpacenav/spacenavd, src/dev.c, commit bac572a: the models, their axes (for most
 * models, y points towards the hand and z down; for some, y points up and z away from the hand),
 * and the numbers of the Enterprise's keys (usbdb; bnhack_sment(), where the kernel's code of a key
 * is 255 more than its number in the report). That file does not contain the lengths of reports,
 * because it uses evdev. Here they are 3Dconnexion's, as in other public drivers.
 */
#ifndef SpaceMouseModel_h
#define SpaceMouseModel_h

#include "DeviceModels.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <mutex>

namespace emulated
{

class SpaceMouseModel : public HidModel
{
public:
  /// pushes along the three axes, then rotations about them
  using Counts = std::array<std::int16_t, 6>;

  enum class Kind : std::uint8_t
  {
    Navigator, ///< sends pushes and turns in separate reports
    PlusXt,    ///< like Navigator, but y points up
    Compact,
    Enterprise ///< has keys with numbers up to 176
  };

  explicit SpaceMouseModel(Kind kind)
    : Model(kind)
    , IsOld(kind == Kind::Navigator || kind == Kind::PlusXt)
  {
  }
  explicit SpaceMouseModel(bool isOld)
    : SpaceMouseModel(isOld ? Kind::Navigator : Kind::Compact)
  {
  }
  std::uint16_t GetVendor() const override { return this->IsOld ? 0x046D : 0x256F; }
  std::uint16_t GetProduct() const override
  {
    constexpr std::uint16_t products[] = { 0xC626, 0xC603, 0xC635, 0xC633 };
    return products[static_cast<int>(this->Model)];
  }
  std::string GetName() const override
  {
    constexpr const char* names[] = { "SpaceNavigator", "SpaceMouse Plus XT", "SpaceMouse Compact",
      "SpaceMouse Enterprise" };
    return names[static_cast<int>(this->Model)];
  }
  std::vector<std::uint8_t> GetReportDescriptor() const override
  {
    const std::vector<std::uint8_t> six{ 0x09, 0x30, 0x09, 0x31, 0x09, 0x32, 0x09, 0x33, 0x09, 0x34,
      0x09, 0x35, 0x95, 0x06, 0x81, 0x06, 0xC0 };
    const std::vector<std::uint8_t> twice{ 0x09, 0x30, 0x09, 0x31, 0x09, 0x32, 0x95, 0x03, 0x81,
      0x06, 0xC0, 0xA1, 0x00, 0x85, 0x02, 0x09, 0x33, 0x09, 0x34, 0x09, 0x35, 0x81, 0x06, 0xC0 };
    // A multi-axis controller: axes, 16 or 176 buttons in report 3, and the light in report 4.
    const std::uint8_t buttons = this->Model == Kind::Enterprise ? 176 : 16;
    std::vector<std::uint8_t> all{ 0x05, 0x01, 0x09, 0x08, 0xA1, 0x01, 0xA1, 0x00, 0x85, 0x01, 0x16,
      0xA2, 0xFE, 0x26, 0x5E, 0x01, 0x75, 0x10 };
    const std::vector<std::uint8_t> rest{ 0xA1, 0x02, 0x85, 0x03, 0x05, 0x09, 0x19, 0x01, 0x29,
      buttons, 0x15, 0x00, 0x25, 0x01, 0x75, 0x01, 0x95, buttons, 0x81, 0x02, 0xC0, 0x05, 0x08,
      0x09, 0x4B, 0xA1, 0x02, 0x85, 0x04, 0x95, 0x01, 0x91, 0x02, 0x75, 0x07, 0x91, 0x03, 0xC0,
      0xC0 };
    const std::vector<std::uint8_t>& axes = this->IsOld ? twice : six;
    all.insert(all.end(), axes.begin(), axes.end());
    all.insert(all.end(), rest.begin(), rest.end());
    return all;
  }
  int Output(const std::uint8_t* report, int size) override
  {
    if (report[0] != 4 || size != 2 || this->HasNoLight)
    {
      return -EPIPE;
    }
    this->Light = report[1];
    return size;
  }
  int GetFeature(std::uint8_t*, int) override { return -EPIPE; }

  /** Sets the cap's deflection from now on. The mouse reports zeros only once. */
  void Push(const Counts& counts)
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    this->Held = counts;
    this->Report();
  }
  /** Advances by a millisecond. The mouse repeats a constant deflection every 16 ms. */
  void Step()
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    if (++this->Time % 16 == 0 && this->Held != Counts{} && !this->IsSilent)
    {
      this->Report();
    }
  }
  void Press(std::uint8_t buttons)
  {
    const std::uint8_t report[3]{ 3, buttons, 0 };
    this->Input(report, 3);
  }
  /** Presses a key of the Enterprise (1 to 176), or releases it (0). */
  void PressKey(int number)
  {
    std::uint8_t report[23]{ 3 };
    if (number > 0)
    {
      report[1 + (number - 1) / 8] = static_cast<std::uint8_t>(1 << (number - 1) % 8);
    }
    this->Input(report, 23);
  }
  void SendRaw(const std::vector<std::uint8_t>& report)
  {
    this->Input(report.data(), static_cast<int>(report.size()));
  }

  std::atomic<int> Light{ -1 };
  std::atomic<bool> HasNoLight{ false };
  std::atomic<bool> IsSilent{ false };

private:
  void Report()
  {
    std::uint8_t bytes[14]{ 1 };
    for (std::size_t a = 0; a < 6; ++a)
    {
      bytes[1 + 2 * a] = static_cast<std::uint8_t>(this->Held[a] & 0xFF);
      bytes[2 + 2 * a] = static_cast<std::uint8_t>(this->Held[a] >> 8 & 0xFF);
    }
    if (!this->IsOld)
    {
      this->Input(bytes, 13);
      return;
    }
    this->Input(bytes, 7);
    bytes[6] = 2;
    this->Input(bytes + 6, 7);
  }

  const Kind Model;
  const bool IsOld;
  std::mutex Guard;
  Counts Held{};
  int Time = 0;
};

} // namespace emulated

#endif
