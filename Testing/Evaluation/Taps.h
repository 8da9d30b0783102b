// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Measures the force of a tap on a wall, with and without ContactTransient.h.
 */
#ifndef Evaluation_Taps_h
#define Evaluation_Taps_h

#include "Table.h"

namespace evaluation
{

/**
 * Measures arms similar to a Falcon and a Touch that are thrown at walls of one stiffness
 * (Rigs/Taps.h).
 */
Table MeasureTaps();

} // namespace evaluation

#endif
