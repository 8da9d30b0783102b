// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Tools/ToolKind.h"

#include "VTK/Material/HapticFunctions.h"
#include "VTK/Tools/ToolArrays.h"

#include "vtkPiecewiseFunction.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{

///@{
/** Each kind is defined in its own file, such as NeedleKind.cxx. */
const ToolKind& GetPointShellKind();
const ToolKind& GetBurrKind();
const ToolKind& GetNeedleKind();
///@}

const std::vector<const ToolKind*>& GetToolKinds()
{
  // Never destroyed, because a device that is deleted at the exit of the process may still print
  // its tool.
  static const auto* const kinds =
    new std::vector<const ToolKind*>{ &GetPointShellKind(), &GetBurrKind(), &GetNeedleKind() };
  return *kinds;
}

const std::vector<const ToolColumn*>& GetToolArrays()
{
  // Never destroyed, for the same reason as the kinds.
  static const auto* const arrays = []
  {
    auto* const all = new std::vector<const ToolColumn*>;
    for (const ToolKind* const kind : GetToolKinds())
    {
      for (const ToolColumn& column : kind->GetColumns())
      {
        all->push_back(&column);
      }
    }
    return all;
  }();
  return *arrays;
}

const ToolKind* FindToolKind(vtkHapticTool* tool)
{
  const auto& kinds = GetToolKinds();
  const auto found = std::find_if(
    kinds.begin(), kinds.end(), [tool](const ToolKind* kind) { return kind->Is(tool); });
  return found == kinds.end() ? nullptr : *found;
}

Polyline ToolKind::ReadFunction(
  const ToolFunction& function, vtkHapticTool* tool, ToolPlan& plan) const
{
  Polyline line = ToPolyline(function.Get(tool), function.Default);
  const std::string name = std::string("vtkHaptic") + this->Name;
  const std::string error =
    DetectFunctionFault(line, HUGE_VAL, std::string(function.Name) + " of the " + name,
      std::string("0 ") + function.Unit + " or more", name + "::Get" + function.Name + "()");
  if (!error.empty())
  {
    plan.Error = plan.Error.empty() ? error : plan.Error;
    return ConstantPolyline(0.0);
  }
  ToScalars(plan.Property, line);
  return line;
}

void PrintTool(std::ostream& os, vtkIndent indent, vtkHapticTool* tool)
{
  const ToolKind* const kind = FindToolKind(tool);
  if (!kind)
  {
    return;
  }
  kind->Print(os, indent, tool);
  for (const ToolFunction& function : kind->GetFunctions())
  {
    os << indent << function.Name << ":\n";
    function.Get(tool)->PrintSelf(os, indent.GetNextIndent());
  }
}

bool DescribeTool(vtkHapticTool* tool, vtkHapticProperty* property,
  HapticModelDescription& description, std::string& error)
{
  ToolPlan plan{ property, description, nullptr, {} };
  if (const ToolKind* const kind = FindToolKind(tool))
  {
    kind->Describe(tool, plan);
  }
  error = plan.Error;
  description.Tool = error.empty() ? plan.Tool : nullptr;
  return error.empty();
}

} // namespace VolumeHaptics
