// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Named presets of vtkVolumeHapticsFilter::ApplyModePreset.
 */
#ifndef ModePresets_h
#define ModePresets_h

#include "VTK/Modes/HapticModes.h"

#include <string>
#include <vector>

class vtkImageData;
class vtkStringArray;

namespace VolumeHaptics
{

/**
 * Makes the modes of a preset, with strengths that suit an image. Returns no modes, with the reason
 * and the cure in `error`, if there is no such preset, or if the image has nothing for it. Without
 * an image, strengths are 2 N everywhere.
 */
HapticModes MakeModePreset(const char* name, vtkImageData* image, std::string& error);

vtkSmartPointer<vtkStringArray> MakeModePresetNames();

} // namespace VolumeHaptics

#endif
