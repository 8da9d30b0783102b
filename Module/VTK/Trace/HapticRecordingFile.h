// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Makes the file of a recording from its journal: .vtp (everything) or .csv (the point arrays, one
 * line a tick, with the field arrays beside it in .csv.json). Memory does not grow with the
 * recording's length.
 *
 * Beyond the arrays of vtkVolumeHapticsFilter's output a recording has the point arrays `DeviceTip`
 * (m), `Command` (3; N, world axes: the force that went to the device), `Tick`, `Enabled`,
 * `Placement`, `Buttons`, `Armed`, `Fault`, `Share` (0 to 1, of the force, that the gate let
 * through) and `Reason` (why that is not 1: a GateReason of ForceGate.h), and the field arrays
 * `DeviceToWorld` (16 a placement), `InitialState`, `TickPeriod` (s), `Caps` (N/m and N s/m),
 * `DeviceId`, `Settings`, `Units`, `VolumeHash` and `LostTicks`.
 */
#ifndef HapticRecordingFile_h
#define HapticRecordingFile_h

#include <string>

namespace VolumeHaptics
{
class JournalReader;

/** The field array Units. */
extern const char* const RecordingUnits;

///@{
/**
 * Writes the file, by its ending, and removes the journal when all of it is in the file and that is
 * on the disk. False, with the reason and the cure, if that fails: the journal then stays. If only
 * a part of it can be read, the file gets that part, unless a file was there before. The trouble is
 * the reason why the recording itself is not whole.
 */
bool WriteRecording(const std::string& journal, const std::string& file, std::string& error);
bool WriteRecording(JournalReader& reader, const std::string& journal, const std::string& file,
  const std::string& trouble, std::string& error);
///@}

} // namespace VolumeHaptics

#endif
