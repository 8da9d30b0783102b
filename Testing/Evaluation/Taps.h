// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What a tap on a wall feels, without and with ContactTransient.h.
 */
#ifndef Evaluation_Taps_h
#define Evaluation_Taps_h

#include "Table.h"

namespace evaluation
{

/** Arms like a Falcon and a Touch are thrown at walls of one stiffness (Rigs/Taps.h). */
Table MeasureTaps();

} // namespace evaluation

#endif
