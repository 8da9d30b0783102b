// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Masks: piecewise-linear functions that are 0 or 1 everywhere; and functions that are masked.
 */
#ifndef PolylineMask_h
#define PolylineMask_h

#include "Core/Math/PiecewiseTable.h"

namespace VolumeHaptics
{

/**
 * Makes a mask that is 1 where a polyline is more than `floor`, else 0, with the argument
 * multiplied by `scale`.
 */
Polyline MaskAbove(const Polyline& line, double floor = 0.0, double scale = 1.0);

/** Makes a function that is 0 up to `from`, a polyline from `to` on, and linear in between. */
Polyline CutBelow(const Polyline& line, double from, double to);

} // namespace VolumeHaptics

#endif
