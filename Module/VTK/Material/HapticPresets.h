// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads and writes the materials of a vtkHapticProperty: the named presets of ApplyPreset, and the
 * user's preset files (WritePreset and ReadPreset).
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
 * Factors that convert a preset's values and gradients to those of an image that a property scales.
 */
struct PresetScale
{
  double Values = 1.0;
  double Gradients = 1.0;
  bool AreGradientsPerUnit = false; ///< whether gradients are per world unit instead of per
                                    ///< millimetre
};

/**
 * Computes the factors. Both are 1 if the preset's values have a unit, or if the image has no
 * background level. Returns false, with an error, if the preset needs the image and the image can't
 * be read.
 */
bool ComputePresetScale(const char* name, vtkImageData* image, vtkHapticProperty* property,
  PresetScale& scale, std::string& error);

/** Fills a property from a preset. Returns false and changes nothing if there is no such preset. */
bool FillFromPreset(const char* name, vtkHapticProperty* property, const PresetScale& scale = {});

/**
 * Fills the function of a needle's cutting force (N), for the presets of CT. Returns false and
 * changes nothing for any other name.
 */
bool FillCuttingForce(const char* name, vtkPiecewiseFunction* force);

vtkSmartPointer<vtkStringArray> MakePresetNames();
/** Returns the names of all presets, quoted and separated by commas. */
std::string ListPresets();

/** Returns whether a preset's name is a file name. The name may be null. */
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
