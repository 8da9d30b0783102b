// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * 3Dconnexion's six-axis mice: what their packets say.
 *
 * The cap gives way by a millimetre or so, and what counts is how hard it is pushed and turned:
 * rates, not positions. Older models send pushes (report 1) and turns (report 2) one after the
 * other, newer ones both in one packet; the length tells which. Axes keep the device's own order
 * and senses: pushes x, y, z, then turns about them.
 */
#ifndef SpaceMouse_h
#define SpaceMouse_h

#include <array>
#include <cstddef>
#include <cstdint>

namespace VolumeHaptics
{

class SpaceMouse
{
public:
  static constexpr double FullScale = 350.0; ///< counts
  /// Of the full scale, about ten counts: at rest, caps are off their zero by a few. Beyond, values
  /// rise from 0, so that nothing jumps at its border.
  static constexpr double DeadZone = 0.03;

  struct State
  {
    std::array<double, 6> Axes{}; ///< x, y, z, about x, about y, about z: -1 to 1
    std::uint32_t Buttons = 0;    ///< the first 32; bit 0 is the first one
  };

  /**
   * Whether this is such a device: by an explicit list, as the vendors' other products are mice and
   * keyboards.
   */
  static bool IsKnown(std::uint16_t vendor, std::uint16_t product) noexcept;

  /**
   * Takes a packet in, the report id in front. Why it is refused, as a text that lasts, and the
   * state as it was; else nullptr. Reports about other things, such as the battery, are taken and
   * change nothing.
   */
  static const char* Decode(const std::uint8_t* bytes, std::size_t size, State& state) noexcept;

  /** -1 to 1 from counts, with the dead zone. */
  static double Scale(int counts) noexcept;
};

} // namespace VolumeHaptics

#endif
