// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Named materials of vtkHapticProperty::ApplyPreset, and the user's own materials as files (see
 * vtkHapticProperty::WritePreset and ReadPreset).
 */
#ifndef HapticPresets_h
#define HapticPresets_h

#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <string>

class vtkHapticProperty;
class vtkImageData;
class vtkPiecewiseFunction;

namespace VolumeHaptics
{

/**
 * Factors that convert a preset's values and gradients to those of an image, as a property scales
 * the image.
 */
struct PresetScale
{
  double Values = 1.0;
  double Gradients = 1.0;
  bool AreGradientsPerUnit = false; ///< whether gradients are per world unit, not per millimetre
};

/**
 * Computes the factors. Both are 1 if the preset's values have a unit, or if the image has no
 * background level. Returns false, with an error, if the image is needed and can't be read.
 */
bool ComputePresetScale(const char* name, vtkImageData* image, vtkHapticProperty* property,
  PresetScale& scale, std::string& error);

/** Fills a property from a preset. Returns false and changes nothing if there is no such preset. */
bool FillFromPreset(const char* name, vtkHapticProperty* property, const PresetScale& scale = {});

/**
 * Fills the function of the force (N) with which a needle cuts, for the presets of CT. Returns
 * false and changes nothing for any other name.
 */
bool FillCuttingForce(const char* name, vtkPiecewiseFunction* force);

vtkSmartPointer<vtkStringArray> MakePresetNames();
/** Lists the names, quoted and separated by commas. */
std::string ListPresets();

/** Returns whether the name of a preset is the name of a file. The name may be null. */
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
