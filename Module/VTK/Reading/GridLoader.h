// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_GridLoader_h
#define Explore_GridLoader_h

#include "VTK/Reading/VolumeLoader.h"

#include <string>

namespace Explore
{
/// Returns the file extensions of grids, for messages.
std::string ListGridEndings();

/// Returns whether a file's extension is that of a data set that is not an image: a rectilinear,
/// structured or unstructured grid, or a collection of them.
bool IsGrid(const std::string& path);

/// Reads a grid file and resamples it to an image with cubic voxels of the average cell's volume,
/// as the filter does with data that are not images. Averages cell arrays to the points. Outside
/// all cells, scalars have the smallest value, and vectors and tensors are 0. If there are several
/// times, reads the last one. Throws InputError.
Volume ReadGrid(const std::string& path);

/// Reads a grid inside the reader process, which a damaged file may crash. Returns the bytes that
/// ReadGrid() unpacks.
std::string PackGrid(const std::string& path);
} // namespace Explore

#endif
