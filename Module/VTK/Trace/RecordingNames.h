// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Names of the arrays that only recordings have.
 */
#ifndef RecordingNames_h
#define RecordingNames_h

namespace VolumeHaptics
{

/** Names of the arrays that only recordings have, for an exact replay. */
namespace RecordingNames
{
constexpr const char* DeviceTip = "DeviceTip"; ///< point array: the tip in device space (m)
/// point array: orientation of the stylus in device space (w, x, y, z); all 0: none
constexpr const char* DeviceOrientation = "DeviceOrientation";
constexpr const char* Orientation = "Orientation"; ///< point array: orientation in the world
constexpr const char* Enabled = "Enabled";         ///< point array: 1 if the tick enabled the servo
constexpr const char* Placement = "Placement";     ///< point array: tuple of DeviceToWorld
constexpr const char* Renewed = "Renewed";         ///< point array: 1 if a local surface arrived
constexpr const char* Spinning = "Spinning";       ///< point array: 1 if a burr should spin
/// point array: request about removed tissue that began then; 1 undo, 2 redo, 3 reset; 0: none
constexpr const char* RemovalRequest = "RemovalRequest";
constexpr const char* DeviceToWorld = "DeviceToWorld"; ///< field array: 16 numbers, row by row
constexpr const char* TickPeriod = "TickPeriod";       ///< field array: s
constexpr const char* Caps = "Caps";                   ///< field array: N/m, N s/m; 0: no cap; one
                                                       ///< tuple, or one per placement
constexpr const char* InitialState = "InitialState";   ///< field array: the ServoState
/// field array: contacts of a tool with a shape at the beginning, see RecordedPath; ContactRows
constexpr const char* InitialContacts = "InitialContacts";
constexpr const char* AirValue = "AirValue"; ///< field array: value of a sample without tissue
constexpr const char* Settings = "Settings"; ///< field array: a text
/// begins the settings' line with the hash of the label image, if there was one
constexpr const char* LabelHash = "LabelHash: ";
/// begins the line with the number of fine voxels in a label voxel, if there is a finer grid
constexpr const char* LabelGrid = "LabelGrid: ";
constexpr const char* DeviceRate = "ServoRate of the device: "; ///< begins a line in all recordings
} // namespace RecordingNames

} // namespace VolumeHaptics

#endif
