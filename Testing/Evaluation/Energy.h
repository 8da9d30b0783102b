// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Measures closed paths of the tip in a static volume. The hand must not gain energy from
 * them.
 */
#ifndef Evaluation_Energy_h
#define Evaluation_Energy_h

#include "Figure.h"

namespace evaluation
{

/** Returns the work (J) of the force on the hand along a path, by the trapezoidal rule. */
double EnergyGiven(const Path& path, const Trace& trace);

/**
 * Returns the energy (J) that the hand gains in each of some random cycles, from no contact to no
 * contact.
 */
std::vector<double> MeasureCycles(const Candidate& candidate, int cycles);

} // namespace evaluation

#endif
