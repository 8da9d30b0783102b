// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The results of one run as ratios: times drift with the processor's speed, ratios much less.
 * Ratios of the least times are those of an idle machine, ratios of medians those of this machine.
 */
#ifndef RatioTable_h
#define RatioTable_h

#include "BallVolume.h"
#include "Medians.h"

namespace benchmarks
{

/** Prints every ratio whose two sides were measured, with its target if there is one. */
void PrintRatios(const Medians& medians);

/** Prints the memory of a model with each estimator, without the image. */
void PrintMemory(const BallVolume& volume);

} // namespace benchmarks

#endif
