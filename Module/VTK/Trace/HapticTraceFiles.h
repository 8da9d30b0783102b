// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads traces from files: .vtp (everything) and .csv (the point arrays, one line for each tick,
 * and the field arrays in .csv.json beside it).
 */
#ifndef HapticTraceFiles_h
#define HapticTraceFiles_h

#include "Core/Math/Quaternion.h"
#include "Core/Math/Vector3.h"

#include <string>
#include <vector>

namespace VolumeHaptics
{

/** Returns ".vtp" or ".csv"; empty for any other file. */
std::string GetTraceEnding(const std::string& file);

/** The tips of a trace or a recording. */
struct RecordedTips
{
  std::vector<Vector3> Tips;
  std::vector<double> Times;            ///< time of every tip (s); empty if the file has none
  std::vector<Quaternion> Orientations; ///< orientation of every tip, not checked; may be empty
  /** Whether tips and orientations are in device space; otherwise they are in the world. */
  bool InDeviceSpace = false;
};

/**
 * Reads the tips of a .vtp or .csv: from DeviceTip if there is one, else from Tip, else from the
 * points. Orientations come from DeviceOrientation, or with Tip or the points from Orientation.
 * Only a whole trace is accepted. False, with an error that names the file, for missing, truncated,
 * foreign or empty files, numbers that are not finite, and times or ticks that run backwards.
 */
bool ReadTraceFile(const std::string& file, RecordedTips& tips, std::string& error);

/**
 * Reads a path in world units as ReadTraceFile reads tips, but never from DeviceTip, and without
 * orientations. If a .csv has no Tip, the columns "Points:0" to "Points:2" or "x", "y" and "z" are
 * read. The end of the last line may be missing.
 */
bool ReadPathFile(const std::string& file, RecordedTips& tips, std::string& error);

} // namespace VolumeHaptics

#endif
