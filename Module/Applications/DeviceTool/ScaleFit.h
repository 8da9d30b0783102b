// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Fits a straight line to requested forces and the readings of a scale. */
#ifndef ScaleFit_h
#define ScaleFit_h

#include <string>
#include <vector>

struct ScaleReading
{
  double Asked = 0.0; ///< N
  double Shown = 0.0; ///< N
};

/**
 * The least-squares line shown = offset + factor * requested. The offset absorbs the weight of the
 * handle, a zero error of the scale, and the friction, which always has the same direction.
 */
struct ScaleFit
{
  double Factor = 0.0;
  double Offset = 0.0;   ///< N
  double Residual = 0.0; ///< N, the root mean square with n - 2 degrees of freedom
  double Doubt = 0.0;    ///< standard error of the factor
};

/// Fits the line to at least three readings of different forces. Returns false, with the fault and
/// the cure, if the readings don't fit a rising line.
bool FitScale(const std::vector<ScaleReading>& readings, ScaleFit& fit, std::string& error);

#endif
