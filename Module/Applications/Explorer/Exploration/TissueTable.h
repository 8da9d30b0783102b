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
/// A range of values, with a common name.
struct Tissue
{
  std::string Name;
  double From; // least value, inclusive
  double To;   // upper limit, exclusive
};

/// Makes the table: for a CT, the project's Hounsfield table; else the classes by the histogram's
/// thresholds. Empty for a field.
std::vector<Tissue> MakeTissueTable(const Analysis& analysis);

/// Returns the row of a table, which is not empty, whose range contains the value.
std::size_t FindTissue(const std::vector<Tissue>& table, double value);

/// Sets the functions of a filter's property. "propose" uses what the edges of the image suggest,
/// and sets the filter's KernelRadius; "histogram" builds materials on the histogram's thresholds,
/// and raises thresholds that lie in the background's noise. "auto" uses the preset for Hounsfield
/// units, else "propose" or, if the image has no edges, "histogram". Any other name must be a
/// preset of vtkHapticProperty. Throws InputError. Returns the name of the materials.
std::string ApplyMaterials(const std::string& preset, Analysis& analysis, vtkImageData* image,
  vtkVolumeHapticsFilter* filter);

/// Moves the outer threshold to the middle of the boundary with the outside, if the property was
/// proposed from an image: a soft edge is drawn and pressed where a hand feels it.
void FitThresholds(vtkHapticProperty* property, Analysis& analysis);
} // namespace Explore

#endif
