// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Interprets the events of a gamepad in Linux.
 *
 * The codes are those of the kernel's gamepad specification (gamepad.rst of its documentation of
 * input), with triggers at Z and RZ as the drivers of Xbox and PlayStation pads have them. Pads
 * without RX and RY may have their right stick at Z and RZ: an axis there belongs to a stick if it
 * was centred at first.
 */
#ifndef EvdevReader_h
#define EvdevReader_h

#include "Devices/Pad/PadState.h"

#include <linux/input.h>

#include <array>

namespace VolumeHaptics
{

/** Processes the events of a pad and stores its state. */
class EvdevReader
{
public:
  enum class News : std::uint8_t
  {
    None,
    Report,  ///< a report is complete; Get() returns a new state
    MustRead ///< events were lost; all axes and buttons must be read from the device
  };

  ///@{
  /** Set the state of an axis or a button. Codes that the device does not have are ignored. */
  void SetAxis(unsigned code, const input_absinfo& axis) noexcept;
  void SetButton(unsigned code, bool isHeld) noexcept;
  ///@}
  News Receive(const input_event& event) noexcept;
  PadState Get() const noexcept;

private:
  struct Axis
  {
    bool Exists = false;
    /** Whether the axis was centred at first; a trigger would be at an end. */
    bool IsCentred = false;
    int Value = 0;
    int Least = 0;
    int Most = 0;
    int Flat = 0;
  };
  double Stick(unsigned code) const noexcept;
  /**
   * Returns the value of a trigger: the largest value of its axes, or the value of its button if it
   * has no axis.
   */
  double Trigger(unsigned code, unsigned other, std::uint32_t button) const noexcept;

  std::array<Axis, ABS_CNT> Axes{};
  std::uint32_t Buttons = 0; ///< PadButton bits, and two further bits for triggers that are buttons
  bool IsDropping = false;
};

} // namespace VolumeHaptics

#endif
