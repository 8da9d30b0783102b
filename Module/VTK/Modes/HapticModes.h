// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Converts vtkHapticMode to the core's modes, after checking their input.
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

/** Returns the array of the first active mode that reads one; null if no mode does. */
vtkDataArray* FindModeArray(const HapticModes& modes, vtkImageData* image);

/**
 * Describes modes on the samples of an image; `view` is one of its components. Arrays are used
 * without a copy, unless they store their components separately. Returns false, with the reason and
 * the cure in `error`, if an active mode can't be felt.
 */
bool DescribeModes(const HapticModes& modes, vtkImageData* image, const VolumeView& view,
  std::vector<ModeDescription>& described, std::string& error);

/** Returns whether a tick has enough time for all of these modes, including inactive ones. */
bool FitIntoATick(const HapticModes& modes);

} // namespace VolumeHaptics

#endif
