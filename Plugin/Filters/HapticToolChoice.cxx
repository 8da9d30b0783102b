// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticToolChoice.h"

#include "HapticFunctionText.h"

#include "vtkDataObject.h"
#include "vtkHapticBurr.h"
#include "vtkHapticNeedle.h"
#include "vtkHapticPointShell.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkVolumeHapticsFilter.h"

#include <ostream>

namespace
{

constexpr const char* NeedleKind = "Needle";
constexpr const char* ShellKind = "Point shell";
constexpr const char* BurrKind = "Burr";
constexpr const char* NoKind = "None";

void ReadToolText(const std::string& name, const std::string& text, vtkPiecewiseFunction* function,
  std::string& error)
{
  if (!ReadFunctionText(text, function))
  {
    error += name + " is \"" + text +
      "\". Give a number, or pairs of a scalar and a number, such as \"-100 0, 300 50\". ";
  }
}

} // namespace

//------------------------------------------------------------------------------
std::string HapticToolChoice::Fill(vtkVolumeHapticsFilter* filter)
{
  const bool isShell = this->Kind == ShellKind;
  vtkDataObject* const shape = isShell && filter->GetNumberOfInputConnections(2) > 0
    ? filter->GetInputDataObject(2, 0)
    : nullptr;
  if (!this->IsDirty && shape == this->Shape)
  {
    return {};
  }
  this->IsDirty = false; // the calls below call this function again
  this->Shape = shape;
  std::string error;
  if (isShell)
  {
    this->SetShell(filter, error);
  }
  else if (this->Kind == NeedleKind)
  {
    this->SetNeedle(filter, error);
  }
  else if (this->Kind == BurrKind)
  {
    this->SetBurr(filter, error);
  }
  else
  {
    filter->SetTool(nullptr);
    error = this->Kind == NoKind ? ""
                                 : "There is no tool \"" + this->Kind + "\". Use \"" + NoKind +
        "\", \"" + NeedleKind + "\", \"" + ShellKind + "\" or \"" + BurrKind + "\".";
  }
  this->IsMade = error.empty();
  return error;
}

//------------------------------------------------------------------------------
void HapticToolChoice::SetNeedle(vtkVolumeHapticsFilter* filter, std::string& error) const
{
  vtkNew<vtkHapticNeedle> needle;
  needle->SetLateralStrength(this->LateralStrength);
  ReadToolText("Needle Shaft Friction", this->ShaftFriction, needle->GetShaftFriction(), error);
  ReadToolText("Needle Cutting Force", this->CuttingForce, needle->GetCuttingForce(), error);
  filter->SetTool(needle);
}

//------------------------------------------------------------------------------
void HapticToolChoice::SetShell(vtkVolumeHapticsFilter* filter, std::string& error) const
{
  auto* const mesh = vtkPolyData::SafeDownCast(this->Shape);
  if (!mesh)
  {
    error = "The tool Point shell has no shape. Choose closed polygons as Surface, such as those "
            "of an STL file.";
  }
  vtkNew<vtkHapticPointShell> shell;
  shell->SetMesh(mesh);
  shell->SetNumberOfPoints(this->Points);
  shell->SetContactArea(this->ContactArea);
  filter->SetTool(shell);
}

//------------------------------------------------------------------------------
void HapticToolChoice::SetBurr(vtkVolumeHapticsFilter* filter, std::string& error) const
{
  vtkNew<vtkHapticBurr> burr;
  burr->SetRadius(this->BurrRadius);
  burr->SetSpeed(this->BurrSpeed);
  ReadToolText("Burr Specific Energy", this->SpecificEnergy, burr->GetSpecificEnergy(), error);
  filter->SetTool(burr);
}

//------------------------------------------------------------------------------
void HapticToolChoice::Print(std::ostream& os, vtkIndent indent) const
{
  os << indent << "ToolKind: " << this->Kind << "\n";
  os << indent << "NeedleShaftFriction: " << this->ShaftFriction << "\n";
  os << indent << "NeedleCuttingForce: " << this->CuttingForce << "\n";
  os << indent << "NeedleLateralStrength: " << this->LateralStrength << " N\n";
  os << indent << "ShellPoints: " << this->Points << "\n";
  os << indent << "ShellContactArea: " << this->ContactArea << "\n";
  os << indent << "BurrRadius: " << this->BurrRadius << "\n";
  os << indent << "BurrSpeed: " << this->BurrSpeed << " 1/min\n";
  os << indent << "BurrSpecificEnergy: " << this->SpecificEnergy << "\n";
}
