// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * By how much a setting makes a tick longer, on strokes over a scan.
 */
#ifndef Evaluation_TickRatio_h
#define Evaluation_TickRatio_h

#include "Feel.h"

#include <functional>

namespace evaluation
{

/** Sets a filter that has the surface's image and preset. */
using Setting = std::function<void(vtkVolumeHapticsFilter*)>;

/**
 * The median time of a tick with one setting over that with another, both measured in turns on the
 * same strokes, so that what else the machine does counts for both. 0 after an error.
 */
double MeasureTickRatio(
  const FeltSurface& surface, const Setting& measured, const Setting& reference);

} // namespace evaluation

#endif
