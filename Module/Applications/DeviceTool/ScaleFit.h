// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Fits a straight line to the forces that a device was asked for and the forces that a scale
 * showed.
 */
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
 * The least-squares line shown = offset + factor * asked. The offset absorbs the weight of the
 * handle, a scale that does not begin at zero, and the friction, which is always in the same
 * direction.
 */
struct ScaleFit
{
  double Factor = 0.0;
  double Offset = 0.0;   ///< N
  double Residual = 0.0; ///< N, the root mean square with n - 2 degrees of freedom
  double Doubt = 0.0;    ///< standard error of the factor
};

/// Fits the line to at least three readings of different forces. Returns false, with the fault and
/// the cure, if the readings do not fit a rising line.
bool FitScale(const std::vector<ScaleReading>& readings, ScaleFit& fit, std::string& error);

#endif
