// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The tip path of the offline filter: one position per tick.
 */
#ifndef HapticTipPath_h
#define HapticTipPath_h

#include "Vector3.h"

#include "vtkType.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace VolumeHaptics
{

struct TipPath
{
  double StartTime = 0.0;    ///< s, of the first tick
  std::vector<Vector3> Tips; ///< world
};

/**
 * Reads the points of a path in order. Without a point array `Time` every point is a tick; with it,
 * the path is resampled linearly to one tick every `period` seconds from its first time on (of
 * points with the same time, the last counts; a point whose time is a tick's is taken as it is, to
 * the bit). False, with an error, for coordinates or times that are not finite, and for time that
 * runs backwards.
 */
bool ReadTipPath(vtkPolyData* path, double period, TipPath& result, std::string& error);

} // namespace VolumeHaptics

#endif
