// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_VolumeChecks_h
#define Explore_VolumeChecks_h

#include <cstddef>
#include <string>

namespace Explore
{
struct Volume;

/// Throws InputError unless so many frames, of so many bytes each, fit into the free memory.
void CheckMemory(const std::string& path, double bytes, std::size_t frames);

/// Whether the values of a DICOM modality may be Hounsfield units; those of an unknown one may.
bool MayBeHounsfield(const std::string& modality);

/// Throws InputError unless the volume can be touched; makes the first point array (or cell array)
/// the active scalars and reduces it to its first component, with a note.
void CheckVolume(const std::string& path, Volume& volume);
} // namespace Explore

#endif
