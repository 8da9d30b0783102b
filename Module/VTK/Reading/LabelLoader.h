// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_LabelLoader_h
#define Explore_LabelLoader_h

#include "VTK/Reading/VolumeLoader.h"

#include <string>
#include <vector>

namespace Explore
{
/// Reads a segmentation: a DICOM SEG, a NRRD file with segments, a folder of masks, or any image
/// that ReadVolume() reads. The table gets the names in the file. The voxels stay in the order of
/// the file. Values within 0.001 of integers are rounded. `series` chooses one of several volumes
/// or segments; `canChoose` is whether the user can set it. Throws InputError, with the fault and
/// the cure.
Volume ReadLabels(const std::string& path, int series = 0, bool canChoose = true);

/// Adds the labels of a segmentation (see ReadLabels()) to a volume, with the names in the file,
/// and then the contents of each label table: see vtkHapticLabelTable::ReadFile. Throws InputError,
/// with the fault and the cure.
void LoadLabels(
  Volume& volume, const std::string& segmentation, const std::vector<std::string>& tables);

/// Returns notes if no label is inside the volume, and on labels of the table that occur in no
/// voxel.
std::vector<std::string> DescribeLabels(
  vtkImageData* labels, vtkImageData* volume, vtkHapticLabelTable* table);

/// Uses the values of the volume itself as labels, with names and colours from the file at `path`.
/// Other labels get generated names and colours. Throws InputError if the values can't be labels.
void UseAsLabels(Volume& volume, const std::string& path, const std::vector<std::string>& tables);
} // namespace Explore

#endif
