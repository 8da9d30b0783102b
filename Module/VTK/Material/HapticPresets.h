// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Named materials of vtkHapticProperty::ApplyPreset.
 */
#ifndef HapticPresets_h
#define HapticPresets_h

#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <string>

class vtkHapticProperty;
class vtkPiecewiseFunction;

namespace VolumeHaptics
{

/** Fills a property from a preset. Returns false and changes nothing if there is no such preset. */
bool FillFromPreset(const char* name, vtkHapticProperty* property);

/**
 * Fills the force with which a needle cuts (N), for the presets of CT. Returns false and changes
 * nothing for any other name.
 */
bool FillCuttingForce(const char* name, vtkPiecewiseFunction* force);

vtkSmartPointer<vtkStringArray> MakePresetNames();
/** Lists the names, quoted and separated by commas. */
std::string ListPresets();

} // namespace VolumeHaptics

#endif
