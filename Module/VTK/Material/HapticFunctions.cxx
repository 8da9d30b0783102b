// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Material/HapticFunctions.h"

#include "vtkHapticProperty.h"
#include "vtkPiecewiseFunction.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace VolumeHaptics
{
namespace
{

/**
 * A node as vtkPiecewiseFunction stores it. Midpoint and sharpness shape the curve from this node
 * to the next one.
 */
struct Node
{
  double X;
  double Y;
  double Midpoint;
  double Sharpness;
};

/** Adds vertices between two vertices of a curve if the chord is too far from the curve. */
void Subdivide(vtkPiecewiseFunction* function, const Vertex& a, const Vertex& b, double height,
  int depth, Polyline& line)
{
  // Use a smaller tolerance than documented, because the chord is checked at only three positions.
  // The tolerance is relative to the value where that is tiny compared with the height of the
  // piece, except for the last digits near zero.
  constexpr double fraction = 0.6;
  const double value = std::min(std::abs(a.Y), std::abs(b.Y));
  const double tolerance = std::clamp(
    fraction * CurveValueTolerance * value, 1e-9 * height, fraction * CurveTolerance * height);
  const auto at = [&](double s)
  {
    const double x = a.X + s * (b.X - a.X);
    return Vertex{ x, function->GetValue(x) };
  };
  const Vertex middle = at(0.5);
  const auto isOff = [&](const Vertex& v, double s)
  { return std::abs(v.Y - (a.Y + s * (b.Y - a.Y))) > tolerance; };
  const bool split = isOff(middle, 0.5) || isOff(at(0.25), 0.25) || isOff(at(0.75), 0.75);
  if (!split || depth == 0 || !(a.X < middle.X && middle.X < b.X))
  {
    return;
  }
  Subdivide(function, a, middle, height, depth - 1, line);
  line.push_back(middle);
  Subdivide(function, middle, b, height, depth - 1, line);
}

/** Returns the position where a piece changes from its first to its second half. */
double ComputeMiddle(vtkPiecewiseFunction* function, const Node& a, const Node& b)
{
  constexpr double margin = 1e-5; // as in vtkPiecewiseFunction
  const double midpoint = std::clamp(a.Midpoint, margin, 1.0 - margin);
  return function->GetUseLogScale() && a.X > 0.0 ? a.X * std::pow(b.X / a.X, midpoint)
                                                 : a.X + midpoint * (b.X - a.X);
}

/**
 * Returns whether a piece is a step from one value to the other at its middle. For a sharpness near
 * 1, VTK 9.1 makes a step, and later versions such as 9.3 and 9.6 a steep curve.
 */
bool IsStep(vtkPiecewiseFunction* function, const Node& a, double middle, const Node& b)
{
  constexpr double step = 0.99;
  return a.Sharpness > step && function->GetValue(a.X + 0.75 * (middle - a.X)) == a.Y &&
    function->GetValue(middle + 0.25 * (b.X - middle)) == b.Y;
}

/** Adds the vertices between two nodes, without the nodes themselves. */
void AddPiece(vtkPiecewiseFunction* function, const Node& a, const Node& b, Polyline& line)
{
  // The thresholds of vtkPiecewiseFunction: a sharpness near 0 is linear, near 1 a step.
  constexpr double linear = 0.01;
  if (!(a.X < b.X) || a.Y == b.Y)
  {
    return;
  }
  const double middle = ComputeMiddle(function, a, b);
  if (IsStep(function, a, middle, b))
  {
    // End just before the step, because at the step itself the function already has the value of
    // the right side.
    const double before = std::nextafter(middle, a.X);
    line.push_back({ before, a.Y });
    line.push_back({ before, b.Y });
    return;
  }
  if (a.Sharpness < linear && !function->GetUseLogScale())
  {
    if (a.Midpoint != 0.5)
    {
      line.push_back({ middle, 0.5 * (a.Y + b.Y) });
    }
    return;
  }
  // Allow many levels, because a logarithmic scale has many decades at its low end.
  constexpr int depth = 24;
  const double height = std::abs(b.Y - a.Y);
  const Vertex kink{ middle, function->GetValue(middle) };
  Subdivide(function, { a.X, a.Y }, kink, height, depth, line);
  line.push_back(kink);
  Subdivide(function, kink, { b.X, b.Y }, height, depth, line);
}

std::vector<Node> GetNodes(vtkPiecewiseFunction* function)
{
  std::vector<Node> nodes;
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double values[4];
    function->GetNodeValue(i, values);
    nodes.push_back({ values[0], values[1], values[2], values[3] });
  }
  return nodes;
}

bool AreSame(const Node& a, const Node& b)
{
  return a.X == b.X && a.Y == b.Y && a.Midpoint == b.Midpoint && a.Sharpness == b.Sharpness;
}

} // namespace

void ToScalars(vtkHapticProperty* property, Polyline& line)
{
  for (Vertex& vertex : line)
  {
    vertex.X = property->ValueToScalar(vertex.X);
  }
}

std::string DetectFunctionFault(const Polyline& line, double maximum, const std::string& what,
  const std::string& allowed, const std::string& getter)
{
  for (const Vertex& vertex : line)
  {
    // The negated comparison also refuses NaN.
    if (!(vertex.Y >= 0.0 && vertex.Y <= maximum && std::isfinite(vertex.Y) &&
          std::isfinite(vertex.X)))
    {
      std::ostringstream message;
      message << "The function " << what << " has the value " << vertex.Y << " at " << vertex.X
              << ": it must be finite and " << allowed << ". Correct this point of " << getter
              << ".";
      return message.str();
    }
  }
  return {};
}

vtkPiecewiseFunction* ProvideFunction(vtkSmartPointer<vtkPiecewiseFunction>& owned)
{
  if (!owned)
  {
    owned = vtkSmartPointer<vtkPiecewiseFunction>::New();
  }
  return owned;
}

void CopyFunction(vtkPiecewiseFunction* source, vtkPiecewiseFunction* target)
{
  const std::vector<Node> nodes = GetNodes(source);
  const std::vector<Node> before = GetNodes(target);
  if (!std::equal(nodes.begin(), nodes.end(), before.begin(), before.end(), AreSame))
  {
    target->SetAllowDuplicateScalars(1);
    target->RemoveAllPoints();
    for (const Node& node : nodes)
    {
      target->AddPoint(node.X, node.Y, node.Midpoint, node.Sharpness);
    }
  }
  target->SetAllowDuplicateScalars(source->GetAllowDuplicateScalars());
  target->SetClamping(source->GetClamping());
  target->SetUseLogScale(source->GetUseLogScale());
}

Polyline ToPolyline(vtkPiecewiseFunction* function, double emptyValue)
{
  if (!function || function->GetSize() == 0)
  {
    return ConstantPolyline(emptyValue);
  }
  Polyline line;
  const std::vector<Node> nodes = GetNodes(function);
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    if (i > 0)
    {
      AddPiece(function, nodes[i - 1], nodes[i], line);
    }
    line.push_back({ nodes[i].X, nodes[i].Y });
  }
  if (!function->GetClamping())
  {
    line.insert(line.begin(), { line.front().X, 0.0 });
    line.push_back({ line.back().X, 0.0 });
  }
  // If several vertices share a position, the line has the first one's value there, as in VTK 9.1.
  // In later versions (tested: 9.3 and 9.6), vtkPiecewiseFunction has the last one's value.
  for (auto first = line.begin(); first != line.end(); ++first)
  {
    const auto last =
      std::find_if(first, line.end(), [&](const Vertex& vertex) { return vertex.X != first->X; }) -
      1;
    if (first->Y != last->Y && function->GetValue(last->X) == last->Y)
    {
      const double before = std::nextafter(last->X, -HUGE_VAL);
      std::for_each(first, last, [=](Vertex& vertex) { vertex.X = before; });
    }
    first = last;
  }
  return line;
}

} // namespace VolumeHaptics
