// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Tools/ShellDescription.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace VolumeHaptics
{
namespace
{

/** Evaluates a piecewise linear function, which is constant beyond its ends. */
double ValueAt(const Polyline& line, double x)
{
  if (line.empty() || !(x > line.front().X))
  {
    return line.empty() ? 0.0 : line.front().Y;
  }
  for (std::size_t i = 1; i < line.size(); ++i)
  {
    if (x <= line[i].X)
    {
      const double way = line[i].X - line[i - 1].X;
      const double fraction = way > 0.0 ? (x - line[i - 1].X) / way : 1.0;
      return line[i - 1].Y + fraction * (line[i].Y - line[i - 1].Y);
    }
  }
  return line.back().Y;
}

/**
 * Computes the surface strength of visible values; hidden values have 0. The result has the break
 * points of both functions.
 */
Polyline ComputeFeltStrength(const HapticMaterial& material)
{
  // The visibility is 0 or 1 and jumps where two vertices have the same value, so evaluate on both
  // sides of each vertex.
  std::vector<double> values;
  for (const Polyline* const line : { &material.SurfaceStrength, &material.ScalarVisibility })
  {
    for (const Vertex& vertex : *line)
    {
      values.push_back(vertex.X);
      values.push_back(std::nextafter(vertex.X, HUGE_VAL));
    }
  }
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  Polyline felt;
  for (const double x : values)
  {
    felt.push_back(
      { x, ValueAt(material.SurfaceStrength, x) * ValueAt(material.ScalarVisibility, x) });
  }
  return felt;
}

bool CheckToolVolume(
  vtkHapticTool* tool, const char* deed, const HapticModelDescription& d, std::string& error)
{
  const std::string begin = std::string("A ") + tool->GetClassName();
  if (d.Settings.Method != HapticMethod::Proxy)
  {
    error = begin + " " + deed +
      ", which only the method PROXY knows. Choose it with SetMethodToProxy(), or remove the "
      "tool with SetTool(nullptr).";
    return false;
  }
  if (!d.TimeSteps.empty())
  {
    error = begin +
      " can't feel a volume that moves, and the image on input port 0 has several frames. Stop "
      "time with SetTimeUnitsPerSecond(0), or remove the tool with SetTool(nullptr).";
    return false;
  }
  return true;
}

bool FindSolid(
  vtkHapticShapedTool* tool, const HapticMaterial& material, SolidLevel& level, std::string& error)
{
  if (tool->GetSolid() == vtkHapticShapedTool::FROM_STRENGTH)
  {
    return ComputeSolidLevel(material, level, error) ||
      ((error = std::string("The ") + tool->GetClassName() + error), false);
  }
  level = { tool->GetContactValue(), tool->GetSolid() == vtkHapticShapedTool::BELOW };
  if (!std::isfinite(level.Level))
  {
    error = std::string("The ContactValue of the ") + tool->GetClassName() +
      " is not a finite number. Set it with SetContactValue().";
    return false;
  }
  return true;
}

} // namespace

bool CheckToolNumber(vtkHapticTool* tool, const ToolNumber& number, std::string& error)
{
  if (number.Value > 0.0 && std::isfinite(number.Value))
  {
    return true;
  }
  std::ostringstream text;
  text << "The " << number.Name << " of the " << tool->GetClassName() << " is " << number.Value
       << " " << number.Unit << ". Set it to more than 0 with Set" << number.Name << "().";
  error = text.str();
  return false;
}

bool DescribeShapedTool(
  vtkHapticShapedTool* tool, const char* deed, ToolPlan& plan, ShellDescription& described)
{
  const ToolNumber area{ "ContactArea", tool->GetContactArea(), "square world units" };
  const ToolNumber spring{ "CouplingStiffness", tool->GetCouplingStiffness(), "N/m" };
  SolidLevel solid;
  if (!CheckToolNumber(tool, area, plan.Error) || !CheckToolNumber(tool, spring, plan.Error) ||
    !CheckToolVolume(tool, deed, plan.Model, plan.Error) ||
    !FindSolid(tool, plan.Model.Material, solid, plan.Error))
  {
    return false;
  }
  ShellSettings& touch = described.Touch;
  touch.Level = solid.Level;
  touch.IsBelow = solid.IsBelow;
  touch.ContactArea = tool->GetContactArea();
  touch.CouplingStiffness = tool->GetCouplingStiffness();
  return true;
}

bool ComputeSolidLevel(const HapticMaterial& material, SolidLevel& level, std::string& error)
{
  const Polyline felt = ComputeFeltStrength(material);
  double most = 0.0;
  for (const Vertex& vertex : felt)
  {
    most = std::max(most, vertex.Y);
  }
  int passes = 0;
  for (std::size_t i = 1; i < felt.size(); ++i)
  {
    const Vertex& a = felt[i - 1];
    const Vertex& b = felt[i];
    const double half = 0.5 * most;
    if ((a.Y > half) != (b.Y > half))
    {
      ++passes;
      level = { a.X + (half - a.Y) / (b.Y - a.Y) * (b.X - a.X), a.Y > half };
    }
  }
  if (passes == 1)
  {
    return true;
  }
  std::ostringstream text;
  text << " can't tell what is solid: the surface strength of the "
          "vtkHapticProperty passes half of its largest "
       << (passes == 0 ? "nowhere" : std::to_string(passes) + " times")
       << ". Set the value at the surface with SetContactValue(), and SetSolidToAbove() or "
          "SetSolidToBelow().";
  error = text.str();
  return false;
}

} // namespace VolumeHaptics
