// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Material/HapticFunctions.h"
#include "VTK/Tools/BurrDescription.h"
#include "VTK/Tools/HapticToolKinds.h"
#include "VTK/Tools/HapticToolSettings.h"
#include "VTK/Tools/ShellDescription.h"

#include "vtkPiecewiseFunction.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace VolumeHaptics
{
namespace
{

std::size_t IndexOfTool(vtkHapticTool* tool)
{
  const auto& kinds = GetToolKinds();
  const auto found = std::find_if(kinds.begin(), kinds.end(),
    [tool](const ToolKindRow& kind)
    { return tool->IsA((std::string("vtkHaptic") + kind.Name).c_str()); });
  return static_cast<std::size_t>(found - kinds.begin());
}

bool ReadToolFunction(const ToolKindRow& kind, const ToolFunction& function, vtkHapticTool* tool,
  Polyline& line, std::string& error)
{
  line = ToPolyline(function.Get(tool), function.Default);
  const std::string name = std::string("vtkHaptic") + kind.Name;
  error = FindFunctionFault(line, HUGE_VAL, std::string(function.Name) + " of the " + name,
    std::string("0 ") + function.Unit + " or more", name + "::Get" + function.Name + "()");
  return error.empty();
}

bool DescribeNeedle(vtkHapticNeedle* needle, HapticModelDescription& d, std::string& error)
{
  if (d.Settings.Method != HapticMethod::Proxy)
  {
    error = "A vtkHapticNeedle punctures surfaces, which only the method PROXY knows. Choose it "
            "with SetMethodToProxy(), or take the needle away with SetTool(nullptr).";
    return false;
  }
  if (!d.Frames.empty())
  {
    error = "A vtkHapticNeedle can't be inserted into a volume that moves, and the image on input "
            "port 0 has several frames. Stop time with SetTimeUnitsPerSecond(0), or take the "
            "needle away with SetTool(nullptr).";
    return false;
  }
  const ToolKindRow& kind = FindToolKind(needle);
  NeedleDescription& described = d.Tool.Needle;
  d.Tool.Kind = ToolKind::Needle;
  described.LateralStrength = needle->GetLateralStrength();
  described.HasCuttingForce = needle->GetCuttingForce()->GetSize() > 0;
  if (!std::isfinite(described.LateralStrength))
  {
    error = "The LateralStrength of the vtkHapticNeedle is not a finite number. Set it with "
            "SetLateralStrength().";
    return false;
  }
  return ReadToolFunction(kind, kind.Functions[0], needle, described.ShaftFriction, error) &&
    ReadToolFunction(kind, kind.Functions[1], needle, described.CuttingForce, error);
}

} // namespace

const std::vector<ToolKindRow>& GetToolKinds()
{
  using N = vtkHapticNeedle;
  // Never destroyed: a device that is deleted while the process exits may still print its tool.
  static const auto* const kinds = new std::vector<ToolKindRow>{
    { "Needle", "needle", [] { return vtkSmartPointer<vtkHapticTool>(vtkSmartPointer<N>::New()); },
      { { "ShaftFriction", "N/m",
          [](vtkHapticTool* tool) { return N::SafeDownCast(tool)->GetShaftFriction(); } },
        { "CuttingForce", "N",
          [](vtkHapticTool* tool) { return N::SafeDownCast(tool)->GetCuttingForce(); } } } },
    { "PointShell", "tool with a shape",
      [] { return vtkSmartPointer<vtkHapticTool>(vtkSmartPointer<vtkHapticPointShell>::New()); },
      {} },
    { "Burr", "burr",
      [] { return vtkSmartPointer<vtkHapticTool>(vtkSmartPointer<vtkHapticBurr>::New()); },
      { { "SpecificEnergy", "J/mm^3",
        [](vtkHapticTool* tool) { return vtkHapticBurr::SafeDownCast(tool)->GetSpecificEnergy(); },
        10.0 } } },
  };
  return *kinds;
}

bool HasToolKind(vtkHapticTool* tool)
{
  return IndexOfTool(tool) < GetToolKinds().size();
}

const ToolKindRow& FindToolKind(vtkHapticTool* tool)
{
  return GetToolKinds()[IndexOfTool(tool)];
}

std::string GetToolText(vtkHapticTool* tool)
{
  return HasToolKind(tool) ? FindToolKind(tool).Text : "";
}

void PrintTool(std::ostream& os, vtkIndent indent, vtkHapticTool* tool)
{
  if (auto* const needle = vtkHapticNeedle::SafeDownCast(tool))
  {
    PrintSettings(os, indent, needle, NeedleSettings);
  }
  if (auto* const shell = vtkHapticPointShell::SafeDownCast(tool))
  {
    PrintSettings(os, indent, shell, PointShellSettings);
    vtkPolyData* const mesh = shell->GetMesh();
    os << indent << "Mesh: ";
    mesh ? os << mesh->GetNumberOfPoints() << " points, " << mesh->GetNumberOfPolys() << " polygons"
         : os << "(none)";
    os << "\n";
  }
  if (auto* const burr = vtkHapticBurr::SafeDownCast(tool))
  {
    PrintSettings(os, indent, burr, HapticBurrSettings);
  }
  for (const ToolFunction& function : FindToolKind(tool).Functions)
  {
    os << indent << function.Name << ":\n";
    function.Get(tool)->PrintSelf(os, indent.GetNextIndent());
  }
}

bool DescribeTool(vtkHapticTool* tool, HapticModelDescription& description, std::string& error)
{
  if (auto* const shell = vtkHapticPointShell::SafeDownCast(tool))
  {
    return DescribePointShell(shell, description, error);
  }
  if (auto* const burr = vtkHapticBurr::SafeDownCast(tool))
  {
    const ToolKindRow& kind = FindToolKind(burr);
    return DescribeBurr(burr, description, error) &&
      ReadToolFunction(kind, kind.Functions[0], burr, description.Tool.Burr.SpecificEnergy, error);
  }
  auto* const needle = vtkHapticNeedle::SafeDownCast(tool);
  return !needle || DescribeNeedle(needle, description, error);
}

} // namespace VolumeHaptics
