// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/DeviceTool/ScaleFit.h"

#include <cmath>
#include <cstdio>

namespace
{

/// Largest residual, as a fraction of the scale's change from the first to the last level.
constexpr double MostResidual = 0.05;

} // namespace

bool FitScale(const std::vector<ScaleReading>& readings, ScaleFit& fit, std::string& error)
{
  const auto n = static_cast<double>(readings.size());
  double asked = 0.0;
  double shown = 0.0;
  for (const ScaleReading& reading : readings)
  {
    asked += reading.Asked / n;
    shown += reading.Shown / n;
  }
  double askedAsked = 0.0;
  double askedShown = 0.0;
  for (const ScaleReading& reading : readings)
  {
    askedAsked += (reading.Asked - asked) * (reading.Asked - asked);
    askedShown += (reading.Asked - asked) * (reading.Shown - shown);
  }
  fit.Factor = askedShown / askedAsked;
  fit.Offset = shown - fit.Factor * asked;
  double squares = 0.0;
  for (const ScaleReading& reading : readings)
  {
    const double residual = reading.Shown - fit.Offset - fit.Factor * reading.Asked;
    squares += residual * residual;
  }
  fit.Residual = std::sqrt(squares / (n - 2.0));
  fit.Doubt = fit.Residual / std::sqrt(askedAsked);
  const double range = fit.Factor * (readings.back().Asked - readings.front().Asked);
  if (fit.Factor > 0.0 && fit.Residual <= MostResidual * range)
  {
    return true;
  }
  char text[400];
  std::snprintf(text, sizeof(text),
    fit.Factor > 0.0
      ? "What the scale showed is not on a straight line: it differs by %.2f N. Were the numbers "
        "grams? See that the handle stands on the scale safely and touches nothing else, and try "
        "again."
      : "The scale did not show more when the force rose. See that it is under the handle and was "
        "read while the force was on, or name the direction to it with --axis, such as -y.",
    fit.Residual);
  error = text;
  return false;
}
