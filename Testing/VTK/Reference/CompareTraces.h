// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Difference between two traces, array by array.
 */
#ifndef CompareTraces_h
#define CompareTraces_h

#include "Trace.h"

#include <string>

namespace reference
{
struct Difference
{
  double worst = 0.0; // largest difference in any array, relative to the array's scale
  std::string text;   // text with the array, the tick, and the expected and actual values
};

/// Returns the largest force (N) of a trace, which is the scale of all its forces.
double ForceScale(const Trace& trace);

/// Compares all arrays. Forces are compared relative to the trace's largest force, and other arrays
/// relative to their own largest value. Differences of positions are in world units (mm), and those
/// of contacts are 0 or 1. If a contact depends on less than 1e-9 N, both results are correct.
Difference CompareTraces(const Trace& expected, const Trace& actual);

/// Compares only the force on the hand.
Difference CompareForces(const Trace& expected, const Trace& actual);

/// Compares like CompareTraces(), but only the arrays that FORCE_FIELD defines.
Difference CompareForceFields(const Trace& expected, const Trace& actual);
} // namespace reference

#endif
