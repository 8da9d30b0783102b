// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticTool.h"

#include "VTK/Tools/ToolKind.h"

//------------------------------------------------------------------------------
vtkHapticTool::vtkHapticTool() = default;
vtkHapticTool::~vtkHapticTool() = default;

//------------------------------------------------------------------------------
std::string vtkHapticTool::GetText()
{
  const VolumeHaptics::ToolKind* const kind = VolumeHaptics::FindToolKind(this);
  return kind ? kind->Text : "";
}

//------------------------------------------------------------------------------
vtkHapticTool* vtkHapticTool::Make(const char* name)
{
  for (const VolumeHaptics::ToolKind* const kind : VolumeHaptics::GetToolKinds())
  {
    if (name && std::string(name) == kind->Name)
    {
      const vtkSmartPointer<vtkHapticTool> tool = kind->Make();
      tool->Register(nullptr);
      return tool;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
bool vtkHapticTool::SetNumber(const char* name, double value)
{
  const VolumeHaptics::ToolKind* const kind = VolumeHaptics::FindToolKind(this);
  return kind && name && kind->Set(this, name, value);
}

//------------------------------------------------------------------------------
vtkPiecewiseFunction* vtkHapticTool::GetFunction(const char* name)
{
  const VolumeHaptics::ToolKind* const kind = VolumeHaptics::FindToolKind(this);
  if (kind && name)
  {
    for (const VolumeHaptics::ToolFunction& function : kind->GetFunctions())
    {
      if (std::string(name) == function.Name)
      {
        return function.Get(this);
      }
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
void vtkHapticTool::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Text: " << this->GetText() << "\n";
}
