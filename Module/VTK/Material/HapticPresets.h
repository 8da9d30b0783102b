// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The named materials of vtkHapticProperty::ApplyPreset.
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

/** If there is no such preset, returns false and changes nothing. */
bool FillFromPreset(const char* name, vtkHapticProperty* property);

/**
 * The force with which a needle cuts (N), for the presets of CT. If the name is of none of them,
 * returns false and changes nothing.
 */
bool FillCuttingForce(const char* name, vtkPiecewiseFunction* force);

vtkSmartPointer<vtkStringArray> MakePresetNames();
/** The names, quoted and separated by commas. */
std::string ListPresets();

} // namespace VolumeHaptics

#endif
