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
  double worst = 0.0; // largest difference of all arrays, each relative to its scale
  std::string text;   // text with the array, the tick, and the expected and actual values
};

/// Returns the largest force (N) of a trace, which is the scale of all its forces.
double ForceScale(const Trace& trace);

/// Compares all arrays. Forces are compared relative to the trace's largest force, and other arrays
/// relative to their own largest value. Positions differ by world units (mm), and contacts by 0 or
/// 1. If less than 1e-9 N decides a contact, both contacts are right.
Difference CompareTraces(const Trace& expected, const Trace& actual);

/// Compares only the force on the hand.
Difference CompareForces(const Trace& expected, const Trace& actual);

/// Compares as CompareTraces() does, but only the arrays that FORCE_FIELD defines.
Difference CompareForceFields(const Trace& expected, const Trace& actual);
} // namespace reference

#endif
