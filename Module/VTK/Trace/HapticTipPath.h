// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The tip path of the offline filter: one position per tick.
 */
#ifndef HapticTipPath_h
#define HapticTipPath_h

#include "Core/Servo/ServoTick.h"

#include <vector>

namespace VolumeHaptics
{

struct TipPath
{
  std::vector<Vector3> Tips; ///< world; in device space for a recording
  double StartTime = 0.0;    ///< s, of the first tick
  std::vector<double> Times; ///< s, of every tick; empty if they are evenly spaced
  bool IsRecording = false;  ///< whether it is a recording and has the following
  std::vector<Affine3> Placements;
  std::vector<int> PlacementOf; ///< per tick
  std::vector<bool> Enabled;    ///< per tick
  std::vector<bool> Renewed;    ///< per tick
  ServoState InitialState;
  double TickPeriod = 0.0;     ///< s, of the recorded servo
  std::vector<ForceCaps> Caps; ///< of the recorded device, per placement
};

} // namespace VolumeHaptics

#endif
