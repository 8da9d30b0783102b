// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_TissueTable_h
#define Explore_TissueTable_h

#include "Applications/Explorer/Analysis/VolumeAnalysis.h"

#include "vtkHapticProperty.h"

#include <string>
#include <vector>

namespace Explore
{
/// A range of values, with a common name.
struct Tissue
{
  std::string Name;
  double From; // inclusive
  double To;   // exclusive
};

/// CT: the project's Hounsfield table; else the classes by the histogram's thresholds.
std::vector<Tissue> MakeTissueTable(const Analysis& analysis);

/// The row of the table that holds the value.
std::size_t FindTissue(const std::vector<Tissue>& table, double value);

/// "auto" takes the preset that suits the kind of volume; "histogram" builds materials on the
/// histogram's thresholds; anything else must be a preset of vtkHapticProperty (InputError if not).
/// Returns the name of the materials.
std::string ApplyMaterials(
  const std::string& preset, const Analysis& analysis, vtkHapticProperty* property);
} // namespace Explore

#endif
