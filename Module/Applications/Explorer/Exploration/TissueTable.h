// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_TissueTable_h
#define Explore_TissueTable_h

#include "Applications/Explorer/Analysis/VolumeAnalysis.h"

#include <string>
#include <vector>

class vtkHapticProperty;
class vtkImageData;
class vtkVolumeHapticsFilter;

namespace Explore
{
/// A named range of values.
struct Tissue
{
  std::string Name;
  double From; // lower limit, inclusive
  double To;   // upper limit, exclusive
};

/// Makes the table of tissues: for a CT, the project's Hounsfield table; for other volumes, classes
/// divided by the histogram's thresholds; for a field, an empty table.
std::vector<Tissue> MakeTissueTable(const Analysis& analysis);

/// Returns the row of a table whose range contains the value. The table must not be empty.
std::size_t FindTissue(const std::vector<Tissue>& table, double value);

/// Sets the functions of a filter's property. "propose" derives them from the edges of the image,
/// and sets the filter's KernelRadius. "histogram" makes materials with the histogram's thresholds,
/// and raises thresholds that are within the background's noise. "auto" uses the preset for
/// Hounsfield units if it fits, otherwise "propose" or, if the image has no edges, "histogram". Any
/// other name must be a preset of vtkHapticProperty. Throws InputError. Returns the name of the
/// materials.
std::string ApplyMaterials(const std::string& preset, Analysis& analysis, vtkImageData* image,
  vtkVolumeHapticsFilter* filter);

/// If the property was proposed from an image, moves the outer threshold to the middle of the
/// boundary with the outside, so that a soft edge is drawn and pressed where the hand feels it.
void FitThresholds(vtkHapticProperty* property, Analysis& analysis);
} // namespace Explore

#endif
