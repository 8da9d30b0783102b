// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The journal of a running recording: FILE.part, from which FILE is made at the end.
 *
 * A journal is written from beginning to end, in chunks that each carry a checksum: facts about the
 * recording, the first state with its contacts and removed tissue, placements, and groups of ticks.
 * A group holds the columns one after the other, each compressed as a block of VTK's XML format, so
 * that a .vtp can be made by copying blocks. If a full disk or a crash ends a journal, all chunks
 * before its end can be read. A journal is only for the machine that wrote it: numbers are stored
 * as in memory.
 */
#ifndef HapticJournal_h
#define HapticJournal_h

#include "Core/Carving/ShareSnapshot.h"
#include "Core/State/ServoStateNumbers.h"
#include "VTK/Trace/ContactRows.h"
#include "VTK/Trace/TraceRow.h"

#include <array>
#include <cstddef>
#include <string>

namespace VolumeHaptics
{

/** Facts about a whole recording. */
struct RecordingAbout
{
  std::string DeviceId;
  std::string Settings;   ///< the filter's PrintSelf when the recording began
  std::string VolumeHash; ///< hash of the touched scalars; empty while it is not known
};

/** Hashes that become known some time after a recording began; empty if there are none. */
struct RecordingHashes
{
  std::string Volume;
  std::string Labels;
};

/** The state and the settings from which a replay begins. */
struct RecordingBegin
{
  std::array<double, ServoStateSize> State;
  double TickPeriod; ///< s
  double AirValue;   ///< air value of a volume whose tissue may be removed; otherwise NaN
};

/** Placement and caps of the device while a generation of ticks is made. */
struct PlacementRow
{
  std::array<double, 16> Matrix; ///< DeviceToWorld, row by row
  std::array<double, 2> Caps;    ///< stiffness and damping (N/m and N s/m)
};

/** Number of ticks in a group; only the last group may have fewer. */
constexpr std::size_t GroupSize = 256;

/** The suffix of a journal's name. */
constexpr const char* JournalEnding = ".part";

} // namespace VolumeHaptics

#endif
