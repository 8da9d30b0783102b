// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Masks: piecewise-linear functions that are 0 or 1 everywhere.
 */
#ifndef PolylineMask_h
#define PolylineMask_h

#include "Core/Math/PiecewiseTable.h"

namespace VolumeHaptics
{

/** 1 if a polyline is more than `floor`, else 0, with the argument multiplied by `scale`. */
Polyline MaskAbove(const Polyline& line, double floor = 0.0, double scale = 1.0);

} // namespace VolumeHaptics

#endif
