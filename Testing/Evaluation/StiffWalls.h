// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Measures the stiffness of the walls that a device can render, with and without
 * ForceAugmentation.h.
 */
#ifndef Evaluation_StiffWalls_h
#define Evaluation_StiffWalls_h

#include "Table.h"

namespace evaluation
{

/**
 * Measures arms similar to a Falcon and a Touch, pressed by weights and hands (Rigs/StiffWalls.h).
 */
Table MeasureStiffWalls();

} // namespace evaluation

#endif
