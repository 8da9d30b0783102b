// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The gamepads for which Linux has drivers, as sysfs lists them.
 */
#ifndef EvdevPads_h
#define EvdevPads_h

#include <cstdint>
#include <string>
#include <vector>

namespace VolumeHaptics
{

struct EvdevPad
{
  std::string Path; ///< its node, such as /dev/input/event5
  std::string Name; ///< the product's
  std::uint16_t Vendor = 0;
  std::uint16_t Product = 0;
  bool Vibrates = false; ///< its driver supports FF_RUMBLE

  /** Name and path, as shown to the user. */
  std::string GetLabel() const;
  /** "available", "in use", or the obstacle and its cure. */
  std::string GetState() const;
  /** The obstacle for an error of open() or EVIOCGRAB. */
  static std::string Explain(int fault);
};

/** In the order of their numbers: all pads with a first button and a stick of two axes. */
std::vector<EvdevPad> FindEvdevPads();

/** The obstacle and its cure for a pad whose driver can't make it vibrate. */
extern const char* const NoRumbleText;

} // namespace VolumeHaptics

#endif
