// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Makes masks, which are piecewise-linear functions with the values 0 and 1, and masked functions.
 */
#ifndef PolylineMask_h
#define PolylineMask_h

#include "Core/Math/PiecewiseTable.h"

namespace VolumeHaptics
{

/**
 * Makes a mask that is 1 where a polyline exceeds `floor`, and 0 elsewhere. Multiplies the
 * polyline's arguments by `scale`.
 */
Polyline MaskAbove(const Polyline& line, double floor = 0.0, double scale = 1.0);

/**
 * Makes a function that is 0 up to `from`, equals a polyline from `to` on, and is linear between
 * them.
 */
Polyline CutBelow(const Polyline& line, double from, double to);

} // namespace VolumeHaptics

#endif
