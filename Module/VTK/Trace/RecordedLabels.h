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
 * Reads the text Settings of the field arrays in .csv.json, beside a recording .csv. The text is
 * empty if there is no such file. Returns false, with the fault and the cure in `error`, if the
 * file is not JSON.
 */
bool ReadSettingsBeside(const std::string& csv, std::string& settings, std::string& error);

/** Adds the field array Settings, as recordings have it, to a path. */
void SetRecordedSettings(vtkPolyData* path, const std::string& settings);

/**
 * Returns the rest of the line that begins with `prefix` in the settings of a recording; empty if
 * there is no such line, or no settings.
 */
std::string FindRecordedSetting(vtkPolyData* recording, const std::string& prefix);

/**
 * Returns whether a recording is older than the setting MaterialPlacement. Its surfaces then have
 * the materials of the kernel.
 */
bool IsOlderThanMaterialPlacement(vtkPolyData* recording);

/**
 * Returns whether walls of labels with thick slices come from a finer grid. It is false only for a
 * recording that was made without this grid. `recording` may be null, or a path.
 */
bool HasFineLabels(vtkPolyData* recording);

/**
 * Returns the hash of the label image from the settings of a recording; empty if there was no label
 * image.
 */
std::string ReadLabelHash(vtkPolyData* recording);

/**
 * Compares the label image of a recorded path with the label image of this hash (empty: no image).
 * Returns an error if they differ; empty if they are equal, or if the path was recorded without
 * labels.
 */
std::string CompareLabels(vtkPolyData* path, const std::string& hash);

} // namespace VolumeHaptics

#endif
