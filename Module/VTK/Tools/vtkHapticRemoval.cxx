// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticRemoval.h"

#include "Core/Platform/HapticFiles.h"
#include "VTK/Tools/RemovalAccess.h"
#include "VTK/Tools/TissueArrays.h"

#include "vtkFieldData.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <utility>

vtkStandardNewMacro(vtkHapticRemoval);
vtkInformationKeyRestrictedMacro(vtkHapticRemoval, TOUCHED_ARRAY, ObjectBase, "vtkDataArray");

namespace
{

using VolumeHaptics::RemovalData;
using VolumeHaptics::RemovalRequest;

bool Ask(vtkHapticRemoval* removal, RemovalRequest request, bool isPossible)
{
  RemovalData& data = RemovalData::Of(removal);
  if (!data.Tissue || !isPossible || !data.Tissue->Request(request))
  {
    return false;
  }
  if (!data.Holder)
  {
    data.ServeAll();
    removal->Modified();
  }
  return true;
}

} // namespace

//------------------------------------------------------------------------------
vtkHapticRemoval::vtkHapticRemoval()
  : Data(new VolumeHaptics::RemovalData)
{
}

//------------------------------------------------------------------------------
vtkHapticRemoval::~vtkHapticRemoval() = default;

//------------------------------------------------------------------------------
void vtkHapticRemoval::SetAirValue(double value)
{
  if (this->AutoAirValue || this->AirValue != value)
  {
    this->AutoAirValue = false;
    this->AirValue = value;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkHapticRemoval::Undo()
{
  return Ask(this, RemovalRequest::Undo, this->GetNumberOfUndos() > 0);
}

//------------------------------------------------------------------------------
bool vtkHapticRemoval::Redo()
{
  return Ask(this, RemovalRequest::Redo, this->GetNumberOfRedos() > 0);
}

//------------------------------------------------------------------------------
bool vtkHapticRemoval::Reset()
{
  const bool hadRead = std::exchange(this->Data->Read, nullptr) != nullptr;
  return Ask(this, RemovalRequest::Reset, !this->IsEmpty()) || hadRead;
}

//------------------------------------------------------------------------------
int vtkHapticRemoval::GetNumberOfUndos()
{
  const auto& tissue = this->Data->Tissue;
  return tissue ? static_cast<int>(tissue->Journal.GetUndoable()) : 0;
}

//------------------------------------------------------------------------------
int vtkHapticRemoval::GetNumberOfRedos()
{
  const auto& tissue = this->Data->Tissue;
  return tissue ? static_cast<int>(tissue->Journal.GetRedoable()) : 0;
}

//------------------------------------------------------------------------------
double vtkHapticRemoval::GetRemovedVolume()
{
  return this->Data->Tissue ? this->Data->Tissue->Journal.GetVolume() : 0.0;
}

//------------------------------------------------------------------------------
bool vtkHapticRemoval::IsEmpty()
{
  return !this->Data->Tissue || this->Data->Tissue->Bricks.IsWhole();
}

//------------------------------------------------------------------------------
bool vtkHapticRemoval::IsUsedUp()
{
  return this->Data->Tissue && this->Data->Tissue->IsUsedUp();
}

//------------------------------------------------------------------------------
int vtkHapticRemoval::GetNumberOfRequests()
{
  return this->Data->Tissue ? static_cast<int>(this->Data->Tissue->GetPending()) : 0;
}

//------------------------------------------------------------------------------
void vtkHapticRemoval::MakeShares(vtkImageData* fractions)
{
  const auto& tissue = this->Data->Tissue;
  vtkImageData* const geometry = this->Data->Geometry;
  if (fractions)
  {
    VolumeHaptics::MakeTissueImage(
      tissue ? &tissue->Bricks : nullptr, geometry, geometry->GetExtent(), fractions);
  }
}

//------------------------------------------------------------------------------
bool vtkHapticRemoval::WriteFile(const std::string& file)
{
  std::string error;
  if (!this->Data->Tissue)
  {
    vtkErrorMacro("There is no removed tissue to write: no burr has ticked yet. Give the filter a "
                  "vtkHapticBurr with SetTool() and feel with it first.");
    return false;
  }
  if (!VolumeHaptics::WriteRemovalFile(
        this->Data->Tissue->Bricks, this->AirValue, this->Data->Geometry, file, error))
  {
    vtkErrorMacro(<< "The removed tissue can't be written to " << VolumeHaptics::Printable(file)
                  << ": " << error);
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHapticRemoval::ReadFile(const std::string& file)
{
  auto content = std::make_unique<VolumeHaptics::RemovalContent>();
  std::string error;
  if (!VolumeHaptics::ReadRemovalFile(file, *content, error))
  {
    vtkErrorMacro(<< "The file " << VolumeHaptics::Printable(file) << " " << error);
    return false;
  }
  RemovalData::SetFoundAir(this, content->AirValue);
  this->Data->ApplyContent(std::move(content));
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
bool vtkHapticRemoval::ReadTrace(vtkPolyData* trace)
{
  const VolumeHaptics::TissueArrayNames& names = VolumeHaptics::FinalTissueNames;
  std::vector<VolumeHaptics::BrickTissue> fractions;
  std::string flaw;
  if (!this->Data->Tissue)
  {
    flaw = "can't be placed, as no model of a volume was made. Update() the filter with a "
           "vtkHapticBurr first.";
  }
  else if (!trace || !trace->GetFieldData()->HasArray(names.Bricks))
  {
    flaw = "has no removed tissue. Make it with a vtkHapticBurr and a single path.";
  }
  else if (!VolumeHaptics::ReadTissueArrays(trace->GetFieldData(), names, fractions, flaw))
  {
    flaw = "can't be read: " + flaw + ". Make it again.";
  }
  else if (!this->Data->Replace(fractions, this->Data->Geometry))
  {
    flaw = "has tissue removed in more bricks than there is memory for. Shorten its path.";
  }
  if (!flaw.empty())
  {
    vtkErrorMacro("The trace " << flaw);
    return false;
  }
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
void vtkHapticRemoval::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "AutoAirValue: " << (this->AutoAirValue ? "On" : "Off") << "\n"
     << indent << "AirValue: " << this->AirValue << "\n"
     << indent << "NumberOfUndos: " << this->GetNumberOfUndos() << "\n"
     << indent << "NumberOfRedos: " << this->GetNumberOfRedos() << "\n"
     << indent << "IsEmpty: " << (this->IsEmpty() ? "yes" : "no") << "\n";
}
