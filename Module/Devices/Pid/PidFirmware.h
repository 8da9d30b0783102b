// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Detects which published firmware a force-feedback device runs, and which way it pushes.
 *
 * The PID specification leaves open whether a direction is where a force comes from or where it
 * goes to, and firmwares differ. Two are known from their source, where the torque of their own
 * springs shows the sign of their axes:
 *
 * - OpenFFBoard (Ultrawipf/OpenFFBoard, HidFFB.cpp and EffectsCalculator.cpp, commit 160af910): a
 *   force comes from its direction, as in DirectInput and in Linux' hid-pidff. Versions 1.10.0 to
 *   1.16.0 push y the other way. Versions have the same numbers and reports, but since 1.16.5 the
 *   name of the board follows "FFBoard " in the product's name. Built with the descriptor of one
 *   axis, it looks for Direction Enable in a bit that the descriptor does not have, and uses the
 *   bit of the axis: then its direction is a share, from -1 at one end of the range to 1 at the
 *   other.
 * - ArduinoJoystickWithFFBLibrary (YukMingLaw's, Joystick.cpp, commit ed86e27): a force goes to its
 *   direction. It is identified by its board's maker and the sizes of all its reports.
 *
 * All others are treated like hid-pidff. If they have two axes, only the first one is used, where
 * the user states that the second one has no motor.
 */
#ifndef PidFirmware_h
#define PidFirmware_h

#include "Devices/Transport/Hid/HidDeviceInfo.h"

namespace VolumeHaptics
{

struct PidFirmware
{
  bool IsKnown = false;       ///< the signs of both axes are known
  double Sign = 1.0;          ///< -1 if a force goes to its direction
  bool HasShares = false;     ///< a direction is a share of the axis, with its bit
  const char* Objection = ""; ///< why no axis can be driven; empty if one can
};

PidFirmware FindPidFirmware(const HidDeviceInfo& info, const HidReportDescriptor& descriptor);

} // namespace VolumeHaptics

#endif
