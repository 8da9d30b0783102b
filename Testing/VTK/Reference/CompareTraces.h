// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The difference between two traces, array by array.
 */
#ifndef CompareTraces_h
#define CompareTraces_h

#include "Trace.h"

#include <string>

namespace reference
{
struct Difference
{
  double worst = 0.0; // largest of all arrays, each relative to its scale
  std::string text;   // the array, the tick, and the expected and actual values
};

/// Returns the largest force of a trace (N), by which all forces are scaled.
double ForceScale(const Trace& trace);

/// Compares all arrays. Forces are relative to the trace's largest force, other arrays to their own
/// largest value, positions are absolute in world units (mm), and contacts are wrong (1) or right
/// (0). A contact that less than 1e-9 N decides may be either.
Difference CompareTraces(const Trace& expected, const Trace& actual);

/// Compares only the force on the hand.
Difference CompareForces(const Trace& expected, const Trace& actual);

/// Like CompareTraces(), with only the arrays that FORCE_FIELD defines.
Difference CompareForceFields(const Trace& expected, const Trace& actual);
} // namespace reference

#endif
