// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVHapticStateSource.h"

#include "VTK/Device/StateGeometry.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

vtkStandardNewMacro(vtkPVHapticStateSource);

//------------------------------------------------------------------------------
vtkPVHapticStateSource::vtkPVHapticStateSource()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
void vtkPVHapticStateSource::SetState(const double state[30])
{
  if (!std::equal(state, state + Length, this->State))
  {
    std::copy_n(state, Length, this->State);
    this->IsNew = true;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkPVHapticStateSource::GetNeedsUpdate()
{
  return this->IsNew;
}

//------------------------------------------------------------------------------
int vtkPVHapticStateSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  this->IsNew = false;
  vtkInformation* const output = outputs->GetInformationObject(0);
  if (this->State[0] == 0.0 ||
    output->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    return 1;
  }
  VolumeHaptics::ShownState state;
  const double* next = this->State + 1;
  for (vtkVector3d* const vector : { &state.Tip, &state.Proxy, &state.SurfacePosition,
         &state.MediumPosition, &state.Force, &state.ComputedForce, &state.Normal })
  {
    *vector = vtkVector3d(next);
    next += 3;
  }
  for (double* const number :
    { &state.NormalForce, &state.FrictionForce, &state.Contact, &state.SurfaceValue })
  {
    *number = *next++;
  }
  std::copy_n(next, 4, state.Orientation);
  VolumeHaptics::WriteStateGeometry(
    state, this->ForceScale, this->ShowCommandedForce, vtkPolyData::GetData(outputs));
  return 1;
}

//------------------------------------------------------------------------------
void vtkPVHapticStateSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ForceScale: " << this->ForceScale << "\n";
  os << indent << "ShowCommandedForce: " << (this->ShowCommandedForce ? "On" : "Off") << "\n";
  os << indent << "HasState: " << (this->State[0] != 0.0 ? "Yes" : "No") << "\n";
}
