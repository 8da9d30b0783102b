// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Prints the results of a run as ratios: times change with the processor's speed, ratios much less.
 * Ratios of the least times are those of an idle machine; ratios of medians are those of this
 * machine.
 */
#ifndef RatioTable_h
#define RatioTable_h

#include "BallVolume.h"
#include "Medians.h"

namespace benchmarks
{

/** Prints every ratio whose two sides were measured, with its target if there is one. */
void PrintRatios(const Medians& medians);

/** Prints the memory that a model takes with each estimator, excluding the image. */
void PrintMemory(const BallVolume& volume);

} // namespace benchmarks

#endif
