// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_RawHeader_h
#define Explore_RawHeader_h

#include "vtkHapticRegionSource.h"

#include <string>
#include <vector>

namespace Explore
{
/// Whether a name is that of a MetaImage or NRRD file.
bool HasRawHeader(const std::string& path);

/// The size (bytes) of the samples that the header of such a file speaks of; 0 if it can't be
/// read, or if the samples are compressed or have several components.
double FindRawSize(const std::string& path);

/// Sets the source to the samples, which lie beside the header or behind it; returns what the user
/// should know. Throws InputError.
std::vector<std::string> OpenRawHeader(const std::string& path, vtkHapticRegionSource* source);
} // namespace Explore

#endif
