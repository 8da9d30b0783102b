// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A recording as the offline filter replays it, tick by tick.
 */
#ifndef RecordedPath_h
#define RecordedPath_h

#include "Core/Servo/ServoTick.h"

#include <limits>
#include <vector>

namespace VolumeHaptics
{

struct RecordedPath
{
  std::vector<Vector3> Tips; ///< in device space
  std::vector<double> Times; ///< s, of every tick
  std::vector<Affine3> Placements;
  std::vector<int> PlacementOf;  ///< per tick
  std::vector<bool> Enabled;     ///< per tick
  std::vector<bool> Renewed;     ///< per tick
  std::vector<double> DataTimes; ///< per tick; empty if the volume did not move
  /// per tick, in device space; NoOrientation where there was none; empty if there never was one
  std::vector<Quaternion> Orientations;
  std::vector<bool> Spinning;           ///< per tick, of a burr; empty if it never did
  std::vector<RemovalRequest> Requests; ///< per tick; empty if there never was one
  ServoState InitialState;
  ///@{
  /** With the state: the removed tissue, and the value of a sample without any, or NaN. */
  std::vector<BrickShares> InitialShares;
  double AirValue = std::numeric_limits<double>::quiet_NaN();
  ///@}
  ///@{
  /** With the state: what a tool with a shape touched. */
  std::vector<ShellContact> InitialContacts;
  double ContactShare = 1.0; ///< of their energies that counts
  ///@}
  double TickPeriod = 0.0;     ///< s, of the recorded servo
  std::vector<ForceCaps> Caps; ///< of the recorded device, per placement
};

} // namespace VolumeHaptics

#endif
