// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Makes the file of a recording from its journal: .vtp (everything) or .csv (the point arrays, one
 * line for each tick, and the field arrays in .csv.json beside it). It needs the same memory for
 * any length.
 *
 * Besides the arrays of vtkVolumeHapticsFilter's output a recording has the point arrays
 * `DeviceTip` (m), `DeviceOrientation` and, in the world, `Orientation` (4: w, x, y, z of a unit
 * quaternion, all 0 if the device has none), `Command` (3; N, world axes: the force that was sent
 * to the device), `TorqueCommand` (3; N m, the same), `Torque` (3; N m, computed),
 * `ToolOrientation` (4; of a tool with a shape, in the world; else 0), `Tick`, `Enabled`,
 * `Placement`, `Buttons`, `Armed`, `Fault`, `Share` (0 to 1, the share of the force that the gate
 * let through), `Reason` (why that is not 1: a GateReason of ForceGate.h), `Spinning` (whether a
 * burr was to spin), `RemovalRequest` (1 undo, 2 redo, 3 reset that began) and `RemovedVolume`
 * (mm^3), and the field arrays `DeviceToWorld` (16 for each placement), `InitialState`,
 * `InitialContacts` (of a tool with a shape that began in contact), `InitialBricks` and
 * `InitialShares` (if tissue had been removed: ShareArrays.h), `AirValue` (if it may be),
 * `TickPeriod` (s), `Caps` (N/m and N s/m), `DeviceId`, `Settings`, `Units`, `VolumeHash` and
 * `LostTicks`.
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
 * Writes the file; its ending selects the format. Removes the journal once the whole file is on the
 * disk. False, with the reason and the cure, if that fails: the journal then stays. If only a part
 * of the journal can be read, the file gets that part, unless it existed before. `trouble` is the
 * reason why the recording itself is incomplete.
 */
bool WriteRecording(const std::string& journal, const std::string& file, std::string& error);
bool WriteRecording(JournalReader& reader, const std::string& journal, const std::string& file,
  const std::string& trouble, std::string& error);
///@}

} // namespace VolumeHaptics

#endif
