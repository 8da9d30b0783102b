// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_VolumeSeries_h
#define Explore_VolumeSeries_h

#include "VTK/Reading/VolumeLoader.h"

#include <string>
#include <vector>

namespace Explore
{
/// Reads a volume as LoadVolume does, or one that moves: several files, a folder of volumes or of
/// folders of DICOM slices, in the order of their names and the numbers in them; a .pvd file; or a
/// NIfTI file with several times. All time steps are in memory. Its image is the first time step. A
/// volume that is large, or requested as large, is read as by LoadLargeVolume. If a number of a
/// DICOM series is given, a folder holds no time steps. For the array, see LoadVolume. Throws
/// InputError.
Volume LoadVolumes(const std::vector<std::string>& paths, bool isLarge = false, int dicomSeries = 0,
  const std::string& array = "");

/// Reads like LoadVolumes, but a volume that is large is read into memory, too, as it is; throws
/// InputError if it is larger than the free memory.
Volume LoadIntoMemory(
  const std::vector<std::string>& paths, int dicomSeries = 0, const std::string& array = "");

/// Sets the array of vectors that gives the motion of each time step's material to the next time
/// step. Throws InputError if a time step lacks it.
void UseDisplacements(Volume& volume, const std::string& array);
} // namespace Explore

#endif
