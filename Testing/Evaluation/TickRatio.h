// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Measures how much longer ticks take with a setting, on strokes over a scan.
 */
#ifndef Evaluation_TickRatio_h
#define Evaluation_TickRatio_h

#include "Feel.h"

#include <functional>

namespace evaluation
{

/** A change to the settings of a filter that has the surface's image and preset. */
using Setting = std::function<void(vtkVolumeHapticsFilter*)>;

/**
 * Returns the median time of a tick with one setting divided by that with another, or 0 after an
 * error. Measures both in turns on the same strokes, so that other work of the machine affects
 * both.
 */
double MeasureTickRatio(
  const FeltSurface& surface, const Setting& measured, const Setting& reference);

} // namespace evaluation

#endif
