// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Tools/ShellDescription.h"
#include "VTK/Tools/ShellPoints.h"

#include "vtkHapticPointShell.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace VolumeHaptics
{
namespace
{

bool CheckShellNumbers(vtkHapticPointShell* shell, std::string& error)
{
  if (!CheckToolNumber(
        shell, { "TurningStiffness", shell->GetTurningStiffness(), "N m/rad" }, error))
  {
    return false;
  }
  const int points = shell->GetNumberOfPoints();
  if (points < 1 || points > MostShellPoints)
  {
    std::ostringstream text;
    text << "The NumberOfPoints of the vtkHapticPointShell is " << points
         << ". A tick has time for "
         << "1 to " << MostShellPoints << ": set it with SetNumberOfPoints(), to at most 10000 at "
         << "1 kHz.";
    error = text.str();
    return false;
  }
  return true;
}

class PointShellKind final : public ToolKindOf<vtkHapticPointShell, PointShellSettings>
{
public:
  using ToolKindOf::ToolKindOf;

  void Print(std::ostream& os, vtkIndent indent, vtkHapticTool* tool) const override
  {
    this->ToolKindOf::Print(os, indent, tool);
    vtkPolyData* const mesh = vtkHapticPointShell::SafeDownCast(tool)->GetMesh();
    os << indent << "Mesh: ";
    mesh ? os << mesh->GetNumberOfPoints() << " points, " << mesh->GetNumberOfPolys() << " polygons"
         : os << "(none)";
    os << "\n";
  }
  /** Takes the mesh from the previous tool, because setups contain only settings. */
  void TakeOver(vtkHapticTool* tool, vtkHapticTool* before) const override
  {
    auto* const shell = vtkHapticPointShell::SafeDownCast(before);
    vtkHapticPointShell::SafeDownCast(tool)->SetMesh(shell ? shell->GetMesh() : nullptr);
  }
  const ToolColumns& GetColumns() const override { return BakedShell::Columns(); }
  void Describe(vtkHapticTool* tool, ToolPlan& plan) const override;
  vtkSmartPointer<vtkPolyData> MakeShape(vtkHapticTool* tool) const override
  {
    return vtkHapticPointShell::SafeDownCast(tool)->GetMesh();
  }
  double ComputeReach(vtkHapticTool* tool) const override;
  bool IsTurnable() const override { return true; }
};

void PointShellKind::Describe(vtkHapticTool* tool, ToolPlan& plan) const
{
  auto* const shell = vtkHapticPointShell::SafeDownCast(tool);
  ShellDescription described;
  if (!CheckShellNumbers(shell, plan.Error) ||
    !DescribeShapedTool(shell, "is pressed out of what is solid", plan, described))
  {
    return;
  }
  // For an unchanged mesh, this returns the points that existing models use.
  described.Points = GetShellPoints(shell->GetMesh(), shell->GetNumberOfPoints(), plan.Error);
  if (!described.Points)
  {
    plan.Error += " It is the one of SetMesh() of the vtkHapticPointShell.";
    return;
  }
  described.Touch.TurningStiffness = shell->GetTurningStiffness();
  plan.Tool = std::make_shared<const BakedShell>(std::move(described));
}

double PointShellKind::ComputeReach(vtkHapticTool* tool) const
{
  vtkPolyData* const mesh = vtkHapticPointShell::SafeDownCast(tool)->GetMesh();
  if (!mesh || mesh->GetNumberOfPoints() == 0)
  {
    return 0.0;
  }
  double bounds[6];
  mesh->GetBounds(bounds);
  double reach = 0.0;
  for (const double bound : bounds)
  {
    reach = std::max(reach, std::abs(bound));
  }
  return reach;
}

} // namespace

const ToolKind& GetPointShellKind();
const ToolKind& GetPointShellKind()
{
  static const auto* const kind = new PointShellKind("PointShell", "tool with a shape");
  return *kind;
}

} // namespace VolumeHaptics
