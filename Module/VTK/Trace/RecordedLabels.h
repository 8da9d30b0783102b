// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks that a replay uses the same label image as the recording.
 */
#ifndef RecordedLabels_h
#define RecordedLabels_h

#include <string>

class vtkPolyData;

namespace VolumeHaptics
{

/**
 * Reads the field array Settings from the file .csv.json beside a recording .csv. The text is empty
 * if there is no such file. Returns false, with the fault and the cure in `error`, if the file is
 * not JSON.
 */
bool ReadSettingsBeside(const std::string& csv, std::string& settings, std::string& error);

/** Adds the field array Settings of a recording to a path. */
void SetRecordedSettings(vtkPolyData* path, const std::string& settings);

/**
 * Returns the rest of the line that starts with `prefix` in the settings of a recording; empty
 * without such a line or without settings.
 */
std::string FindRecordedSetting(vtkPolyData* recording, const std::string& prefix);

/**
 * Returns whether a recording is older than the setting MaterialPlacement, so that its surfaces
 * have the materials of the kernel.
 */
bool IsOlderThanMaterialPlacement(vtkPolyData* recording);

/**
 * Returns whether label walls in thick slices come from a finer grid: always, except for a
 * recording that was made without this grid. `recording` may be null or any path.
 */
bool HasFineLabels(vtkPolyData* recording);

/** Returns the hash of the label image from the settings of a recording; empty if it had none. */
std::string ReadLabelHash(vtkPolyData* recording);

/**
 * Compares the label image of a recorded path with the hash of the present one (empty: no image).
 * Returns an error if they differ; empty if they are equal, or if the path was recorded without
 * labels.
 */
std::string CompareLabels(vtkPolyData* path, const std::string& hash);

} // namespace VolumeHaptics

#endif
