// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_GridLoader_h
#define Explore_GridLoader_h

#include "VTK/Reading/VolumeLoader.h"

#include <string>

namespace Explore
{
/// The endings of grid files, for messages.
extern const char* const GRID_ENDINGS;

/// Whether a file, by its name, holds a data set that is not an image: a rectilinear, structured or
/// unstructured grid, or several of them.
bool IsGrid(const std::string& path);

/// Reads such a file and resamples it to an image with cubes as large as a cell is on average, as
/// the filter does with data that are no image. Cell arrays are averaged to the points; outside of
/// all cells, scalars are the least value and vectors and tensors 0. If there are several times,
/// the last one is read. Throws InputError.
Volume ReadGrid(const std::string& path);
} // namespace Explore

#endif
