// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Setup/HapticSetupTool.h"

#include "VTK/Base/PassSettings.h"
#include "VTK/Material/HapticSetupFunctions.h"
#include "VTK/Tools/HapticToolKinds.h"
#include "VTK/Tools/HapticToolSettings.h"

#include "vtkVolumeHapticsAlgorithm.h"

namespace VolumeHaptics
{

void PassTool(SetupNode& haptics, vtkVolumeHapticsAlgorithm* filter)
{
  if (haptics.IsWriting() ? !filter->GetTool() : !haptics.Has("Tool"))
  {
    return;
  }
  SetupNode node = haptics.Child("Tool");
  std::vector<const char*> names;
  for (const ToolKindRow& kind : GetToolKinds())
  {
    names.push_back(kind.Name);
  }
  vtkSmartPointer<vtkHapticTool> tool = filter->GetTool();
  const int read = node.Choice(
    "Kind", names, [&] { return static_cast<int>(&FindToolKind(tool) - GetToolKinds().data()); },
    [](int) {});
  if (!haptics.IsWriting())
  {
    haptics.Require("Tool", read >= 0, "an object with the Kind of a tool");
    if (read < 0)
    {
      return;
    }
    tool = GetToolKinds()[static_cast<std::size_t>(read)].Make();
  }
  if (auto* const needle = vtkHapticNeedle::SafeDownCast(tool))
  {
    PassSettings(node, needle, NeedleSettings);
  }
  if (auto* const shaped = vtkHapticShapedTool::SafeDownCast(tool))
  {
    PassSettings(node, shaped, ShapedToolSettings);
  }
  if (auto* const shell = vtkHapticPointShell::SafeDownCast(tool))
  {
    // The mesh stays the filter's, like the shapes of guides: a setup holds settings only.
    auto* const before = vtkHapticPointShell::SafeDownCast(filter->GetTool());
    shell->SetMesh(before ? before->GetMesh() : nullptr);
    PassSettings(node, shell, PointShellSettings);
  }
  if (auto* const burr = vtkHapticBurr::SafeDownCast(tool))
  {
    PassSettings(node, burr, HapticBurrSettings);
  }
  for (const ToolFunction& function : FindToolKind(tool).Functions)
  {
    PassFunction(
      node.Child(function.Name), NotNegative(), [tool, get = function.Get] { return get(tool); });
  }
  haptics.Then([=] { filter->SetTool(tool); });
}

} // namespace VolumeHaptics
