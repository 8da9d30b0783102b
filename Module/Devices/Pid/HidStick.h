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
    std::array<double, 2> Axes{}; ///< x (or the wheel) and y, from -1 to 1 over the logical range
    std::uint32_t Buttons = 0;    ///< bit 0 is button 1; at most 32 buttons
  };

  /**
   * Finds X or the steering wheel, Y if there is one, and the buttons that have one bit each.
   * Returns false and writes the missing parts to `error` if there is no axis.
   */
  bool Map(const HidReportDescriptor& descriptor, std::string& error);

  /**
   * Returns the smallest step of an axis that is reported, as a fraction of the axis's logical
   * range.
   */
  double GetStep() const noexcept;
  bool HasSecondAxis() const noexcept { return this->Axes.size() > 1; }
  /**
   * Makes Decode() read only one axis. For a device without a motor on its second axis, which may
   * be a pedal. State::Axes[1] stays 0.
   */
  void UseOneAxis() { this->Axes.resize(1); }

  /**
   * Reads a packet, with the report id in front if the device uses ids. Returns nullptr, or the
   * reason why the packet is not valid, as a text that is never freed; then the state does not
   * change. Other reports are accepted and change nothing. For the servo loop: no allocation.
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
