// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads the position of a stick or a wheel, and its pressed buttons, from its input reports. The
 * fields are found by their usages.
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
    /// x (or the wheel) and y, scaled from the logical range to -1 to 1
    std::array<double, 2> Axes{};
    std::uint32_t Buttons = 0; ///< bit 0 is button 1; at most 32 buttons
  };

  /**
   * Finds X or the steering wheel, Y if present, and all buttons with one bit each. If there is no
   * axis, returns false and writes the missing parts to `error`.
   */
  bool Map(const HidReportDescriptor& descriptor, std::string& error);

  /** Returns the smallest step that an axis reports, as a fraction of its logical range. */
  double GetStep() const noexcept;
  bool HasSecondAxis() const noexcept { return this->Axes.size() > 1; }
  /**
   * Makes Decode() read only the first axis: for a device whose second axis has no motor, and may
   * be a pedal. State::Axes[1] stays 0.
   */
  void UseOneAxis() { this->Axes.resize(1); }

  /**
   * Reads a packet, with the report id in front if the device uses ids. Returns nullptr, or the
   * reason why the packet is not valid, as a static text; the state is then unchanged. Other
   * reports are accepted and ignored. For the servo loop: no allocation.
   */
  const char* Decode(const std::uint8_t* bytes, std::size_t size, State& state) const noexcept;

private:
  std::vector<HidField> Axes;
  std::vector<HidField> Buttons;
  std::array<std::size_t, 256> Sizes{}; ///< size of each input report's payload, by id
  bool HasIds = false;
};

} // namespace VolumeHaptics

#endif
