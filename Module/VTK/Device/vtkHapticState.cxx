// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticState.h"

#include "Core/Model/BakedMode.h"
#include "VTK/Device/DeviceParts.h"
#include "VTK/Device/StateGeometry.h"
#include "VTK/Tools/NeedleTrace.h"

#include "vtkHapticDevice.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <string>

vtkStandardNewMacro(vtkHapticState);

using namespace VolumeHaptics;

//------------------------------------------------------------------------------
double* vtkHapticState::GetModeForce(int mode)
{
  static_assert(MostPrimitives == sizeof(ModeForces) / sizeof(ModeForces[0]) - 1);
  const bool isThere = mode >= 0 && mode < MostPrimitives;
  return this->ModeForces[isThere ? mode : MostPrimitives];
}

//------------------------------------------------------------------------------
void vtkHapticState::GetFollowed(vtkPolyData* shapes, double reach)
{
  if (!shapes)
  {
    vtkErrorMacro("GetFollowed() needs a polydata to write to, but got a null pointer.");
    return;
  }
  const HapticModel* const model = this->Parts ? this->Parts->Session.FindModel() : nullptr;
  if (model && this->Time > 0.0)
  {
    WriteFollowed(*model, this->Parts->Session.GetState().Record.Proxy, reach, shapes);
  }
  else
  {
    shapes->Initialize();
  }
}

//------------------------------------------------------------------------------
void vtkHapticState::GetNeedleTrack(vtkPolyData* track)
{
  if (!track)
  {
    vtkErrorMacro("GetNeedleTrack() needs a polydata to write to, but got a null pointer.");
    return;
  }
  const HapticModel* const model = this->Parts ? this->Parts->Session.FindModel() : nullptr;
  if (model && this->Time > 0.0)
  {
    const ServoState& before = this->Parts->Session.GetState().Before;
    WriteNeedleTrack(*model, before.Needle, before.Proxy, track);
  }
  else
  {
    track->Initialize();
  }
}

//------------------------------------------------------------------------------
void vtkHapticState::GetGeometry(vtkPolyData* geometry, double forceScale, bool commanded)
{
  if (!geometry || !(forceScale > 0.0))
  {
    vtkErrorMacro("GetGeometry() needs a polydata to write to and a force scale above 0 (N per "
                  "world unit), but got "
      << (geometry ? std::to_string(forceScale) : "a null pointer") << ".");
    return;
  }
  if (this->Time == 0.0)
  {
    geometry->Initialize();
    return;
  }
  ShownState state;
  state.Tip = vtkVector3d(this->TipPosition);
  state.Proxy = vtkVector3d(this->ProxyPosition);
  state.SurfacePosition = vtkVector3d(this->SurfacePosition);
  state.MediumPosition = vtkVector3d(this->MediumPosition);
  state.Force = vtkVector3d(this->Force);
  state.ComputedForce = vtkVector3d(this->ComputedForce);
  state.Normal = vtkVector3d(this->Normal);
  state.NormalForce = this->NormalForce;
  state.FrictionForce = this->FrictionForce;
  state.Contact = this->Contact;
  state.SurfaceValue = this->SurfaceValue;
  if (this->HasTipOrientation())
  {
    std::copy_n(this->TipOrientation, 4, state.Orientation);
  }
  WriteStateGeometry(state, forceScale, commanded, geometry);
}

//------------------------------------------------------------------------------
double vtkHapticState::GetNeedleDepth()
{
  const HapticModel* const model = this->Parts ? this->Parts->Session.FindModel() : nullptr;
  return model ? model->WorldUnitsPerMeter * this->Parts->Session.GetState().Record.Depth : 0.0;
}

//------------------------------------------------------------------------------
void vtkHapticState::Drain(vtkTable* states, int reader)
{
  if (this->Parts)
  {
    this->Parts->Session.DrainStates(this->Parts->Models.GetPlacement(), states, reader);
  }
  else if (states)
  {
    states->Initialize();
  }
}

//------------------------------------------------------------------------------
int vtkHapticState::AddReader()
{
  return this->Parts ? this->Parts->Session.AddReader() : 0;
}

//------------------------------------------------------------------------------
void vtkHapticState::RemoveReader(int reader)
{
  if (this->Parts)
  {
    this->Parts->Session.RemoveReader(reader);
  }
}

//------------------------------------------------------------------------------
void vtkHapticState::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, const double* x, int count)
  {
    os << indent << name << ":";
    for (int i = 0; i < count; ++i)
    {
      os << " " << x[i];
    }
    os << "\n";
  };
  print("TipPosition", this->TipPosition, 3);
  print("ProxyPosition", this->ProxyPosition, 3);
  print("Force", this->Force, 3);
  print("ComputedForce", this->ComputedForce, 3);
  print("Torque", this->Torque, 3);
  print("ComputedTorque", this->ComputedTorque, 3);
  print("ToolOrientation", this->ToolOrientation, 4);
  print("TipOrientation", this->TipOrientation, 4);
  print("TurnRate", this->TurnRate, 3);
  print("Normal", this->Normal, 3);
  print("SurfacePosition", this->SurfacePosition, 3);
  print("MediumPosition", this->MediumPosition, 3);
  print("ModeForces", this->ModeForces[0], 3 * MostPrimitives);
  os << indent << "HasTipOrientation: " << this->IsOriented << "\n";
  os << indent << "IsTipOrientationMeasured: " << this->IsMeasured << "\n";
  os << indent << "IsSpinning: " << this->Spins << "\n";
  os << indent << "IsAtForbiddenLabel: " << this->IsHeldAtLabel << "\n";
  os << indent << "Buttons: " << this->Buttons << "\n";
  os << indent << "Contact: " << this->Contact << "\n";
  os << indent << "SurfaceValue: " << this->SurfaceValue << "\n";
  os << indent << "NormalForce: " << this->NormalForce << "\n";
  os << indent << "FrictionForce: " << this->FrictionForce << "\n";
  os << indent << "DragForce: " << this->DragForce << "\n";
  os << indent << "Slack: " << this->Slack << "\n";
  os << indent << "Label: " << this->Label << "\n";
  os << indent << "Residency: " << this->Residency << "\n";
  os << indent << "Tick: " << this->Tick << "\n";
  os << indent << "Time: " << this->Time << "\n";
}
