// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The packets of 3Dconnexion's six-axis mice.
 *
 * The cap moves by only about a millimetre, so the device reports how hard it is pushed and turned,
 * and not positions. Older models send pushes (report 1) and turns (report 2) separately; newer
 * ones send both in one packet, which its length shows. Axes keep the device's order and signs:
 * pushes along x, y, z, then turns about them.
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
  /// Dead zone as a fraction of the full scale, about ten counts: at rest, caps are off their zero
  /// by a few counts. Outside the dead zone, values rise from 0, so that nothing jumps at its
  /// border.
  static constexpr double DeadZone = 0.03;

  struct State
  {
    std::array<double, 6> Axes{}; ///< x, y, z, about x, about y, about z: -1 to 1
    std::uint32_t Buttons = 0;    ///< the first 32 buttons; bit 0 is button 1
  };

  /**
   * Returns whether this is a six-axis mouse. The products are listed explicitly, because the
   * vendors also make mice and keyboards.
   */
  static bool IsKnown(std::uint16_t vendor, std::uint16_t product) noexcept;
  /**
   * Returns whether the device's y axis points up and its z axis away from the hand. On most
   * devices, y points towards the hand and z down.
   */
  static bool HasAxisUp(std::uint16_t vendor, std::uint16_t product) noexcept;

  /**
   * Reads a packet, with the report id in front. Returns nullptr, or the reason why the packet is
   * not valid, as a static text; the state is then unchanged. Reports about other things, such as
   * the battery, are accepted and ignored.
   */
  static const char* Decode(const std::uint8_t* bytes, std::size_t size, State& state) noexcept;

  /** Converts counts to the range -1 to 1, with the dead zone applied. */
  static double Scale(int counts) noexcept;
};

} // namespace VolumeHaptics

#endif
