// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The names of arrays that only recordings have.
 */
#ifndef RecordingNames_h
#define RecordingNames_h

namespace VolumeHaptics
{

/** Names of the arrays that only recordings have, for an exact replay. */
namespace RecordingNames
{
constexpr const char* DeviceTip = "DeviceTip"; ///< point array: the tip in device space (m)
/// point array: w, x, y, z of the stylus in device space; all 0: none
constexpr const char* DeviceOrientation = "DeviceOrientation";
constexpr const char* Orientation = "Orientation"; ///< point array: the same in the world
constexpr const char* Enabled = "Enabled";         ///< point array: 1 if the tick enabled
constexpr const char* Placement = "Placement";     ///< point array: tuple of DeviceToWorld
constexpr const char* Renewed = "Renewed";         ///< point array: 1 if a local surface came
constexpr const char* Spinning = "Spinning";       ///< point array: 1 if a burr was to spin
/// point array: 1 undo, 2 redo, 3 reset of removed tissue that began then; 0: none
constexpr const char* RemovalRequest = "RemovalRequest";
constexpr const char* DeviceToWorld = "DeviceToWorld"; ///< field array: 16 numbers, row by row
constexpr const char* TickPeriod = "TickPeriod";       ///< field array: s
constexpr const char* Caps = "Caps";                   ///< field array: N/m, N s/m; 0: no cap;
                                                       ///< of all placements, or of each
constexpr const char* InitialState = "InitialState";   ///< field array: the ServoState
/// field array: those of a tool with a shape then, see RecordedPath; a ContactRow each
constexpr const char* InitialContacts = "InitialContacts";
constexpr const char* AirValue = "AirValue"; ///< field array: of a sample without tissue
constexpr const char* Settings = "Settings"; ///< field array: a text
/// begins the line of the settings that has the hash of the label image, if there was one
constexpr const char* LabelHash = "LabelHash: ";
/// the same, of the fine voxels in a voxel of the label image, if it has a finer grid
constexpr const char* LabelGrid = "LabelGrid: ";
constexpr const char* DeviceRate = "ServoRate of the device: "; ///< the same, in all recordings
} // namespace RecordingNames

} // namespace VolumeHaptics

#endif
