// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Makes the modes for the presets of vtkVolumeHapticsFilter::ApplyModePreset, and proposes
 * strengths that suit an image (vtkHapticMode::ProposeFromImage).
 */
#ifndef ModePresets_h
#define ModePresets_h

#include "VTK/Modes/HapticModes.h"

#include <string>
#include <vector>

class vtkHapticMode;
class vtkImageData;
class vtkStringArray;

namespace VolumeHaptics
{

/**
 * Makes the modes of a preset, with strengths that suit an image. Returns no modes, with the reason
 * and the cure in `error`, if there is no such preset, or if the image has nothing to feel in this
 * way. Without an image, strengths are 2 N everywhere.
 */
HapticModes MakeModePreset(const char* name, vtkImageData* image, std::string& error);

vtkSmartPointer<vtkStringArray> MakeModePresetNames();

/**
 * Replaces the Strength of a mode with one that suits an image. Returns false, with the reason in
 * `error`, if there is nothing to propose.
 */
bool ProposeStrength(vtkHapticMode* mode, vtkImageData* image, std::string& error);

} // namespace VolumeHaptics

#endif
