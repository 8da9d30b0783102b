// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_VolumeSeries_h
#define Explore_VolumeSeries_h

#include "VTK/Reading/VolumeLoader.h"

#include <string>
#include <vector>

namespace Explore
{
/// Reads a volume as LoadVolume does, or a moving volume from several files; a folder of volumes,
/// or of folders of DICOM slices, in natural order of their names; a .pvd file; or a NIfTI file
/// with several times. All time steps are then in memory, and the image is the first one. A volume
/// that is large, or requested as large, is read by LoadLargeVolume. If a series is chosen, the
/// series with this number is read from each of several files, and folders of slices are not
/// treated as time steps. For `series`, see vtkHapticVolumeReader::SetSeries(); for `array`, see
/// LoadVolume. Throws InputError.
Volume LoadVolumes(const std::vector<std::string>& paths, bool isLarge = false, int series = 0,
  const std::string& array = "");

/// Reads like LoadVolumes, but reads even a large volume into memory, unchanged. Throws InputError
/// if it is larger than the free memory.
Volume LoadIntoMemory(
  const std::vector<std::string>& paths, int series = 0, const std::string& array = "");

/// Lists the volumes among the files of a folder, in natural order of their names.
std::vector<std::string> ListVolumeFiles(const std::string& folder);

/// Selects the vector array with the motion of each time step's material to the next time step.
/// Throws InputError if a time step lacks it.
void UseDisplacements(Volume& volume, const std::string& array);
} // namespace Explore

#endif
