// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Makes the file of a recording from its journal: .vtp (everything) or .csv (the point
 * arrays, one line for each tick, and the field arrays in .csv.json beside it). The memory that
 * this needs does not depend on the recording's length.
 *
 * Besides the arrays of vtkVolumeHapticsFilter's output a recording has the point arrays
 * `DeviceTip` (m), `DeviceOrientation` and, in the world, `Orientation` (4: w, x, y, z of a unit
 * quaternion, all 0 if the device has none), `Command` (3; N, world axes: the force that was sent
 * to the device), `TorqueCommand` (3; N m, the torque that was sent), `Torque` (3; N m, computed),
 * `ToolOrientation` (4; for a tool with a shape, in the world; otherwise 0), `Tick`, `Enabled`,
 * `Placement`, `Buttons`, `Armed`, `Fault`, `Share` (0 to 1, the fraction of the force that the
 * gate let through), `Reason` (why Share is not 1: a GateReason of ForceGate.h), `Spinning`
 * (whether a burr should spin), `RemovalRequest` (1 undo, 2 redo, 3 reset that began) and
 * `RemovedVolume` (mm^3), and the field arrays `DeviceToWorld` (16 for each placement),
 * `InitialState`, `InitialContacts` (for a tool with a shape that began in contact),
 * `InitialBricks` and `InitialShares` (if tissue had been removed: TissueArrays.h), `AirValue` (if
 * tissue may be removed), `TickPeriod` (s), `Caps` (N/m and N s/m), `DeviceId`, `Settings`,
 * `Units`, `VolumeHash` and `LostTicks`.
 */
#ifndef HapticRecordingFile_h
#define HapticRecordingFile_h

#include <string>

namespace VolumeHaptics
{
class JournalReader;

/** Text of the field array Units, which states the units of all arrays. */
extern const char* const RecordingUnits;

///@{
/**
 * Writes the file in the format that its extension selects. Removes the journal once the whole file
 * is on the disk. On failure, keeps the journal and returns false, with the reason and the cure in
 * `error`. If only a part of the journal can be read, writes that part, unless the file already
 * existed. `trouble` is the reason why the recording itself is incomplete.
 */
bool WriteRecording(const std::string& journal, const std::string& file, std::string& error);
bool WriteRecording(JournalReader& reader, const std::string& journal, const std::string& file,
  const std::string& trouble, std::string& error);
///@}

} // namespace VolumeHaptics

#endif
