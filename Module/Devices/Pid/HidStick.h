// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The position of a stick or a wheel and its pressed buttons, found in its input reports by usage.
 */
#ifndef HidStick_h
#define HidStick_h

#include "Devices/Transport/Hid/HidReportDescriptor.h"

#include <array>

namespace VolumeHaptics
{

class HidStick
{
public:
  struct State
  {
    std::array<double, 2> Axes{}; ///< x (or the wheel), y: -1 to 1 over the logical range
    std::uint32_t Buttons = 0;    ///< bit 0 is button 1; up to 32
  };

  /**
   * Finds X or the steering wheel, Y if there is one, and the buttons that have a bit each. If
   * there is no axis, returns false and writes the missing parts to `error`.
   */
  bool Map(const HidReportDescriptor& descriptor, std::string& error);

  /** Returns the smallest reported step of an axis, as a fraction of the axis's logical range. */
  double GetStep() const noexcept;
  bool HasSecondAxis() const noexcept { return this->Axes.size() > 1; }
  /**
   * Reads only one axis, for a device without a motor on its second axis, which may be a pedal.
   * State::Axes[1] stays 0.
   */
  void UseOneAxis() { this->Axes.resize(1); }

  /**
   * Reads a packet, with the report id in front if the device uses ids. Returns nullptr, or the
   * reason for refusing the packet, as a text that lasts; the state is then unchanged. Reports
   * about other things change nothing. For the servo loop: no allocation.
   */
  const char* Decode(const std::uint8_t* bytes, std::size_t size, State& state) const noexcept;

private:
  std::vector<HidField> Axes;
  std::vector<HidField> Buttons;
  std::array<std::size_t, 256> Sizes{}; ///< payloads of the input reports, by id
  bool HasIds = false;
};

} // namespace VolumeHaptics

#endif
