// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Finds the border of an area: edges that belong to only one triangle.
 */
#ifndef PatchBorder_h
#define PatchBorder_h

#include "VTK/Measure/Measurement.h"

#include <vector>

namespace VolumeHaptics
{

/**
 * Returns the points of the longest closed line along the border, in order, without the first point
 * again at the end. A closed surface has no border; it gives its first triangle.
 */
std::vector<Vector3> FindBorder(const Measurement& area);

} // namespace VolumeHaptics

#endif
