// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The results of one run, as ratios: times drift with the processor's speed, ratios much less. The
 * ratios of the least times are those of an idle machine, the ratios of the medians those of this
 * one.
 */
#ifndef RatioTable_h
#define RatioTable_h

#include "BallVolume.h"
#include "Medians.h"

namespace benchmarks
{

/** Prints every ratio whose two sides were measured, with its target if there is one. */
void PrintRatios(const Medians& medians);

/** Prints what a model of each estimator takes beside the image. */
void PrintMemory(const BallVolume& volume);

} // namespace benchmarks

#endif
