// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Computes the tolerance between a baked value and a vtkPiecewiseFunction. */
#ifndef FunctionChecks_h
#define FunctionChecks_h

#include <vtkPiecewiseFunction.h>
#include <vtkVersionMacros.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace apitest
{
/// Bounds from vtkHapticProperty.h: the error of a curved piece is at most 0.01 % of its height,
/// and at most 0.1 % of its value (except for rounding beside a much larger height).
inline constexpr double CurveBound = 1e-4;
inline constexpr double ValueBound = 1e-3;
inline constexpr double LastDigits = 1e-8;

struct Node
{
  double X, Y, Midpoint, Sharpness;
};

inline std::vector<Node> NodesOf(vtkPiecewiseFunction* function)
{
  std::vector<Node> nodes(function->GetSize());
  for (int i = 0; i < function->GetSize(); ++i)
  {
    function->GetNodeValue(i, &nodes[i].X);
  }
  return nodes;
}

/// Whether the sharpest piece is a steep curve, as in VTK 9.3 and later. In older versions, it is a
/// step.
inline constexpr bool SharpestIsCurve = VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0);

/// Returns the largest error that baking may cause at x. Linear pieces and plateaus only allow for
/// rounding.
inline double AllowedError(vtkPiecewiseFunction* function, double x)
{
  const std::vector<Node> nodes = NodesOf(function);
  double size = 0.0;
  for (const Node& node : nodes)
  {
    size = std::max(size, std::abs(node.Y));
  }
  const double rounding = 1e-11 * size;
  for (std::size_t i = 1; i < nodes.size(); ++i)
  {
    if (x > nodes[i - 1].X && x <= nodes[i].X)
    {
      const double sharpness = nodes[i - 1].Sharpness;
      const bool step = sharpness > 0.99 && !SharpestIsCurve;
      const bool curved = (sharpness >= 0.01 && !step) || function->GetUseLogScale();
      const double height = std::abs(nodes[i].Y - nodes[i - 1].Y);
      const double value = std::abs(function->GetValue(x));
      return rounding +
        (curved ? std::clamp(ValueBound * value, LastDigits * height, CurveBound * height) : 0.0);
    }
  }
  return rounding;
}

/// Returns the smallest and the largest value of the function within a few roundings of x (or of
/// its logarithm), including both ends of a step.
inline std::pair<double, double> ValuesAround(vtkPiecewiseFunction* function, double x)
{
  const double value = function->GetValue(x);
  std::pair<double, double> range = { value, value };
  for (const Node& node : NodesOf(function))
  {
    if (node.X == x)
    {
      return range; // no rounding at the node itself
    }
  }
  const double rounding = 16.0 * std::numeric_limits<double>::epsilon() * std::abs(x);
  std::vector<double> places = { x - rounding, x + rounding };
  for (const Node& node : NodesOf(function))
  {
    if (std::abs(node.X - x) < rounding)
    {
      places.push_back(std::nextafter(node.X, -HUGE_VAL));
      places.push_back(node.X);
    }
  }
  for (const double beside : places)
  {
    range.first = std::min(range.first, function->GetValue(beside));
    range.second = std::max(range.second, function->GetValue(beside));
  }
  return range;
}
} // namespace apitest

#endif
