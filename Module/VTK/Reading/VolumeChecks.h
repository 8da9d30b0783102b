// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_VolumeChecks_h
#define Explore_VolumeChecks_h

#include <cstddef>
#include <string>

namespace Explore
{
struct Volume;

/// Returns the free memory (bytes) of the system or of this process's container, whichever is less;
/// infinite if neither is known.
double GetFreeMemory();

/// Throws InputError unless `frames` images of `bytes` bytes each fit into the free memory.
void CheckMemory(const std::string& path, double bytes, std::size_t frames);

/// Throws InputError unless a volume of this size along x, y and z can be touched.
void CheckSize(const std::string& path, const int size[3]);

/// Returns whether the values of a DICOM modality may be Hounsfield units. Returns true for an
/// unknown modality.
bool MayBeHounsfield(const std::string& modality);

/// Reduces the scalars to one component: colours to their brightness, other scalars to the
/// component with the number `chosen`, counted from 1; 0 stands for the first one. Lists the
/// components to choose from. If the volume has several series, `chosen` is the number of the
/// series, and the first component is used. Throws InputError if there is no such component.
void UseComponent(const std::string& path, Volume& volume, int chosen);

/// Adds a number to all values to convert them to Hounsfield units.
void ShiftValues(Volume& volume, double shift);

/// Throws InputError unless the volume can be touched. Without active scalars, activates the first
/// point array, or a cell array. Reduces the scalars to one component, with a note. For `chosen`,
/// see vtkHapticVolumeReader::SetSeries().
void CheckVolume(const std::string& path, Volume& volume, int chosen = 0);
} // namespace Explore

#endif
