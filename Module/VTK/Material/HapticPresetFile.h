// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes and reads the user's own materials as files: see vtkHapticProperty::WritePreset and
 * ReadPreset.
 */
#ifndef HapticPresetFile_h
#define HapticPresetFile_h

#include <string>

class vtkHapticProperty;

namespace VolumeHaptics
{

/** Whether the name of a preset is the name of a file. The name may be null. */
bool IsPresetFile(const char* name);

///@{
/**
 * Write and read a preset. On failure, both return false, with an error that names the file and the
 * cure, and change nothing.
 */
bool WritePresetFile(const std::string& file, vtkHapticProperty* property, std::string& error);
bool ReadPresetFile(const std::string& file, vtkHapticProperty* property, std::string& error);
///@}

} // namespace VolumeHaptics

#endif
