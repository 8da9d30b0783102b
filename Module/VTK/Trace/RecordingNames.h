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

/** Names of the arrays for exact replays, which only recordings have. */
namespace RecordingNames
{
constexpr const char* DeviceTip = "DeviceTip"; ///< point array: tip in device space (m)
/// point array: orientation of the stylus in device space (w, x, y, z); all 0 without one
constexpr const char* DeviceOrientation = "DeviceOrientation";
/** point array: orientation of the stylus in the world */
constexpr const char* Orientation = "Orientation";
constexpr const char* Enabled = "Enabled"; ///< point array: 1 if the tick enabled the servo
/** point array: index of the tuple in DeviceToWorld */
constexpr const char* Placement = "Placement";
constexpr const char* Renewed = "Renewed";   ///< point array: 1 if a new local surface arrived
constexpr const char* Spinning = "Spinning"; ///< point array: 1 if a burr should spin
/// point array: request about removed tissue that began in the tick; 0: none, 1: undo, 2: redo, 3:
/// reset
constexpr const char* RemovalRequest = "RemovalRequest";
/** field array: matrices of 16 numbers, row by row */
constexpr const char* DeviceToWorld = "DeviceToWorld";
constexpr const char* TickPeriod = "TickPeriod"; ///< field array: period of the servo (s)
/**
 * field array: caps of stiffness (N/m) and damping (N s/m), 0: no cap; one tuple, or one per
 * placement
 */
constexpr const char* Caps = "Caps";
constexpr const char* InitialState = "InitialState"; ///< field array: numbers of the ServoState
/// field array: initial contacts of a tool with a shape, as ContactRow; see RecordedPath
constexpr const char* InitialContacts = "InitialContacts";
constexpr const char* AirValue = "AirValue"; ///< field array: value of a sample without tissue
constexpr const char* Settings = "Settings"; ///< field array: the filter's settings as text
/// start of the line in the settings with the hash of the label image, if there was one
constexpr const char* LabelHash = "LabelHash: ";
/// start of the line with the number of fine voxels in a label voxel, if there is a finer grid
constexpr const char* LabelGrid = "LabelGrid: ";
/** start of a line that all recordings have */
constexpr const char* DeviceRate = "ServoRate of the device: ";
} // namespace RecordingNames

} // namespace VolumeHaptics

#endif
