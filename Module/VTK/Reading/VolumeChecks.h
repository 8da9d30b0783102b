// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_VolumeChecks_h
#define Explore_VolumeChecks_h

#include <cstddef>
#include <string>

namespace Explore
{
struct Volume;

/// Returns the free memory (bytes) of the system, or of the container that this process is in, if
/// that is less; infinite if neither is known.
double GetFreeMemory();

/// Throws InputError unless this number of frames, each of this size (bytes), fits into the free
/// memory.
void CheckMemory(const std::string& path, double bytes, std::size_t frames);

/// Throws InputError unless a volume of this size along x, y and z can be touched.
void CheckSize(const std::string& path, const int size[3]);

/// Returns whether the values of a DICOM modality may be Hounsfield units. True for an unknown
/// modality.
bool MayBeHounsfield(const std::string& modality);

/// Reduces the scalars to one component: colours to their brightness, other scalars to the
/// component with the number `chosen`, which begins at 1; 0 stands for the first one. Lists the
/// components to choose from. If there are series to choose from, `chosen` is the number of the
/// series, and the first component is used. Throws InputError if there is no such component.
void UseComponent(const std::string& path, Volume& volume, int chosen);

/// Adds a number to the values, so that they are Hounsfield units.
void ShiftValues(Volume& volume, double shift);

/// Throws InputError unless the volume can be touched. If there are no active scalars, activates
/// the first point array, or a cell array; reduces the scalars to one component, with a note. For
/// `chosen`, see vtkHapticVolumeReader::SetSeries().
void CheckVolume(const std::string& path, Volume& volume, int chosen = 0);
} // namespace Explore

#endif
