// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_LabelLoader_h
#define Explore_LabelLoader_h

#include "Applications/Explorer/Volume/VolumeLoader.h"

#include <string>
#include <vector>

namespace Explore
{
/// Gives a volume the labels of a segmentation, .seg.nrrd .nrrd .nii .nii.gz .mhd .mha .vti, with
/// the names that the file has, and tables of labels, which add up: see
/// vtkHapticLabelTable::ReadFile. Throws InputError, with the fault and the cure.
void LoadLabels(
  Volume& volume, const std::string& segmentation, const std::vector<std::string>& tables);

/// Takes the volume itself as a label image: its values are numbers of labels, with the names and
/// colours that the file at `path` has for them, and others for the rest. Throws InputError if they
/// can't be that.
void TakeAsLabels(Volume& volume, const std::string& path, const std::vector<std::string>& tables);
} // namespace Explore

#endif
