// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * How far one trace is from another, array by array.
 */
#ifndef CompareTraces_h
#define CompareTraces_h

#include "Trace.h"

#include <string>

namespace reference
{
struct Difference
{
  double worst = 0.0; // of all arrays, each relative to its scale
  std::string text;   // which array, which tick, what was expected and what came
};

/// The largest force of a trace (N), the scale of everything that is a force.
double ForceScale(const Trace& trace);

/// Forces count relative to the largest force of the trace, other arrays relative to their own
/// largest value, positions absolutely in world units (mm), contacts as wrong (1) or right (0): a
/// contact decided by less than 1e-9 N may be either.
Difference CompareTraces(const Trace& expected, const Trace& actual);

/// Only the force on the hand.
Difference CompareForces(const Trace& expected, const Trace& actual);

/// As CompareTraces, but only the arrays that FORCE_FIELD defines.
Difference CompareForceFields(const Trace& expected, const Trace& actual);
} // namespace reference

#endif
