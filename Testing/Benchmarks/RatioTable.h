// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What one run says, as ratios: times drift with the processor's speed, ratios much less. Those of
 * the least times are what an idle machine would show, those of the medians what this one does.
 */
#ifndef RatioTable_h
#define RatioTable_h

#include "BallVolume.h"
#include "Medians.h"

namespace benchmarks
{

/** Prints every ratio whose two sides were measured, with its target where there is one. */
void PrintRatios(const Medians& medians);

/** Prints what a model of each estimator takes beside the image. */
void PrintMemory(const BallVolume& volume);

} // namespace benchmarks

#endif
