// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Proposes strengths of modes that suit an image: see vtkHapticMode::ProposeFromImage.
 */
#ifndef ModeProposal_h
#define ModeProposal_h

#include <string>

class vtkHapticMode;
class vtkImageData;

namespace VolumeHaptics
{

/**
 * Replaces the Strength of a mode by one that suits an image. Returns false, with the reason in
 * `error`, if there is nothing to propose.
 */
bool ProposeStrength(vtkHapticMode* mode, vtkImageData* image, std::string& error);

} // namespace VolumeHaptics

#endif
