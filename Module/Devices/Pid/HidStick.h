// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Where a stick or a wheel is, and which of its buttons are held: its input reports, by usage.
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
   * Finds X or the steering wheel, Y if there is one, and the buttons that have a bit each. False,
   * with what is missing, where there is no axis.
   */
  bool Map(const HidReportDescriptor& descriptor, std::string& error);

  bool HasSecondAxis() const noexcept { return this->Axes.size() > 1; }

  /**
   * Takes a packet in, the report id in front where the device uses ids. Why it is refused, as a
   * text that lasts, and the state as it was; else nullptr. Reports about other things change
   * nothing. For the servo loop: no allocation.
   */
  const char* Decode(const std::uint8_t* bytes, std::size_t size, State& state) const noexcept;

private:
  std::vector<HidField> Axes;
  std::vector<HidField> Buttons;
  std::array<std::size_t, 256> Sizes{}; ///< of the input reports' payloads, by id
  bool HasIds = false;
};

} // namespace VolumeHaptics

#endif
