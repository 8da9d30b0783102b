// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From vtkHapticMode to the core's modes, with every check of their input.
 */
#ifndef HapticModes_h
#define HapticModes_h

#include "Core/Model/BakedMode.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkHapticMode;
class vtkImageData;

namespace VolumeHaptics
{

using HapticModes = std::vector<vtkSmartPointer<vtkHapticMode>>;

/** The array of the first active mode that is about one; null if there is none. */
vtkDataArray* FindModeArray(const HapticModes& modes, vtkImageData* image);

/**
 * Describes modes on the samples of an image, of which `view` is one component. Arrays are viewed
 * without a copy, unless they keep their components apart. False, with the reason and the cure in
 * `error`, if one that is active can't be felt.
 */
bool DescribeModes(const HapticModes& modes, vtkImageData* image, const VolumeView& view,
  std::vector<ModeDescription>& described, std::string& error);

/** Whether a tick has time for these modes at once, the active ones and the others. */
bool FitIntoATick(const HapticModes& modes);

} // namespace VolumeHaptics

#endif
