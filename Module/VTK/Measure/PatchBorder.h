// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The border of an area: edges that belong to one triangle.
 */
#ifndef PatchBorder_h
#define PatchBorder_h

#include "VTK/Measure/Measurement.h"

#include <vector>

namespace VolumeHaptics
{

/**
 * The points of the longest closed line along the border, in order, the first not again at the end.
 * Of a closed surface, which has no border, its first triangle.
 */
std::vector<Vector3> FindBorder(const Measurement& area);

} // namespace VolumeHaptics

#endif
