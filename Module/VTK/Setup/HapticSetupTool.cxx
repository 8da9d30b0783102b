// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Setup/HapticSetupTool.h"

#include "VTK/Material/HapticSetupFunctions.h"
#include "VTK/Tools/ToolKind.h"

#include "vtkVolumeHapticsFilter.h"

#include <algorithm>

namespace VolumeHaptics
{

void PassTool(SetupNode& haptics, vtkVolumeHapticsFilter* filter)
{
  if (haptics.IsWriting() ? !filter->GetTool() : !haptics.Has("Tool"))
  {
    return;
  }
  SetupNode node = haptics.Child("Tool");
  const std::vector<const ToolKind*>& kinds = GetToolKinds();
  std::vector<const char*> names;
  for (const ToolKind* const kind : kinds)
  {
    names.push_back(kind->Name);
  }
  vtkSmartPointer<vtkHapticTool> tool = filter->GetTool();
  const auto place = [&kinds, &tool]
  {
    const auto found = std::find(kinds.begin(), kinds.end(), FindToolKind(tool));
    return static_cast<int>(found - kinds.begin());
  };
  const int read = node.Choice("Kind", names, place, [](int) {});
  if (!haptics.IsWriting())
  {
    haptics.Require("Tool", read >= 0, "an object with the Kind of a tool");
    if (read < 0)
    {
      return;
    }
    const ToolKind& kind = *kinds[static_cast<std::size_t>(read)];
    tool = kind.Make();
    kind.TakeOver(tool, filter->GetTool());
  }
  const ToolKind& kind = *FindToolKind(tool);
  kind.Pass(node, tool);
  for (const ToolFunction& function : kind.GetFunctions())
  {
    PassFunction(
      node.Child(function.Name), NotNegative(), [tool, get = function.Get] { return get(tool); });
  }
  haptics.Then([=] { filter->SetTool(tool); });
}

} // namespace VolumeHaptics
