// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The journal of a recording that is under way: FILE.part, from which FILE is made when it ends.
 *
 * A journal is written from its beginning to its end, in chunks that each carry a checksum: what
 * the recording is about, the first state, placements, and groups of ticks. A group holds the
 * columns one after the other, each compressed as a block of VTK's XML format is, so that a .vtp is
 * made by copying blocks. Whatever ends a journal, a full disk or the death of the program, all
 * chunks before are read. It is for the machine that wrote it: numbers are as in memory.
 */
#ifndef HapticJournal_h
#define HapticJournal_h

#include "Core/Solvers/ServoStateNumbers.h"
#include "VTK/Trace/HapticTraceColumns.h"

#include <array>
#include <cstddef>
#include <string>

namespace VolumeHaptics
{

/** Facts about a whole recording. */
struct RecordingAbout
{
  std::string DeviceId;
  std::string Settings;   ///< what the filter printed when the recording began
  std::string VolumeHash; ///< of the scalars that were touched
};

/** The state and the settings from which a replay begins. */
struct RecordingBegin
{
  std::array<double, ServoStateSize> State;
  double TickPeriod; ///< s
  double Caps[2];    ///< N/m and N s/m
};

/** DeviceToWorld, row by row. */
using PlacementRow = std::array<double, 16>;

/** Ticks in a group, but for the last one. */
constexpr std::size_t GroupSize = 256;

/** The ending of a journal's name. */
constexpr const char* JournalEnding = ".part";

} // namespace VolumeHaptics

#endif
