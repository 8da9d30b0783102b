// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads traces from files: .vtp (everything) and .csv (the point arrays, one line per tick, with
 * the field arrays in .csv.json beside it).
 */
#ifndef HapticTraceFiles_h
#define HapticTraceFiles_h

#include "Core/Math/Quaternion.h"
#include "Core/Math/Vector3.h"

#include <string>
#include <vector>

namespace VolumeHaptics
{

/** Returns the extension ".vtp" or ".csv"; empty for any other file. */
std::string GetTraceEnding(const std::string& file);

/** Tips in a trace or recording. */
struct RecordedTips
{
  std::vector<Vector3> Tips;
  std::vector<double> Times;            ///< time of each tip (s); empty if the file has no times
  std::vector<Quaternion> Orientations; ///< orientation of each tip, unchecked; may be empty
  /** Whether tips and orientations are in device space instead of the world. */
  bool InDeviceSpace = false;
};

/**
 * Reads the tips of a .vtp or .csv: from DeviceTip if the file has it, otherwise from Tip,
 * otherwise from the points. Orientations come from DeviceOrientation, or from Orientation if the
 * tips come from Tip or the points. Accepts only complete traces. Returns false, with an error that
 * names the file, if the file is missing, truncated, foreign or empty, if numbers are not finite,
 * or if times or ticks run backwards.
 */
bool ReadTraceFile(const std::string& file, RecordedTips& tips, std::string& error);

/**
 * Reads a path in world units. Reads tips like ReadTraceFile, but never from DeviceTip, and without
 * orientations. If a .csv has no Tip, reads the columns "Points:0" to "Points:2" or "x", "y" and
 * "z". The last line need not end with a line break.
 */
bool ReadPathFile(const std::string& file, RecordedTips& tips, std::string& error);

} // namespace VolumeHaptics

#endif
