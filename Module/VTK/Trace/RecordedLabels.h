// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The label image that a recording was made with.
 */
#ifndef RecordedLabels_h
#define RecordedLabels_h

#include <string>

class vtkPolyData;

namespace VolumeHaptics
{

/**
 * The text Settings of the fields beside a recording .csv, in .csv.json; empty if it has none.
 * False, with the fault and the cure, if there is such a file but no JSON in it.
 */
bool ReadSettingsBeside(const std::string& csv, std::string& settings, std::string& error);

/** Gives a path the field array Settings, as a recording has it. */
void SetRecordedSettings(vtkPolyData* path, const std::string& settings);

/**
 * The rest of the line of the settings of a recording that begins with `prefix`; empty if there is
 * none, or no settings.
 */
std::string FindRecordedSetting(vtkPolyData* recording, const std::string& prefix);

/**
 * Whether a recording is older than the setting MaterialPlacement: its surfaces have the materials
 * of the kernel.
 */
bool IsOlderThanMaterialPlacement(vtkPolyData* recording);

/**
 * Whether walls of labels with thick slices are those of a finer grid: not with a recording that
 * was made without. The recording may be null, or a path.
 */
bool HasFineLabels(vtkPolyData* recording);

/** The hash of the label image in the settings of a recording; empty if it was made without. */
std::string FindLabelHash(vtkPolyData* recording);

/**
 * The error if a path was recorded with a label image, and the one of this hash (empty: none) is
 * another one; empty if it is the same, or if the path was recorded without labels.
 */
std::string CompareLabels(vtkPolyData* path, const std::string& hash);

} // namespace VolumeHaptics

#endif
