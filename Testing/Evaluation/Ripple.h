// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Measures the ripple of the force on a clean plane at 0.1 m/s, where the force should be smooth.
 */
#ifndef Evaluation_Ripple_h
#define Evaluation_Ripple_h

#include "Figure.h"

namespace evaluation
{

/**
 * Returns the root mean square (N) of the force at 0, 1, 2 ... 500 Hz, on a 16-bit ramp or blurred
 * edge with k = 500 N/m.
 */
std::vector<double> MeasureSpectrum(const Candidate& candidate, bool isEdge);

} // namespace evaluation

#endif
