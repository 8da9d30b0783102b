// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The tip path of the offline filter: one position per tick.
 */
#ifndef HapticTipPath_h
#define HapticTipPath_h

#include "Core/Servo/ServoTick.h"

#include <string>
#include <vector>

class vtkPolyData;

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

/**
 * Reads the points of a path in order. Without a point array `Time` every point is a tick. With it,
 * the path is resampled linearly to one tick every `period` seconds, starting at its first time. If
 * points have the same time, the last counts; a point whose time is a tick's is taken unchanged, to
 * the bit. A recording of vtkHapticDevice is taken tick by tick, in device space. False, with an
 * error, for numbers that are not finite, time that runs backwards, incomplete recordings, several
 * lines, or more ticks than fit into memory.
 */
bool ReadTipPath(vtkPolyData* path, double period, TipPath& result, std::string& error);

/** The error for so many ticks that they and their trace do not fit into memory. */
std::string DescribeLackOfMemory(double ticks);

} // namespace VolumeHaptics

#endif
