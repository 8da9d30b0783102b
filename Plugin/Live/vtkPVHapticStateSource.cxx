// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVHapticStateSource.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

vtkStandardNewMacro(vtkPVHapticStateSource);

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
bool vtkPVHapticStateSource::ReadState(ShownState& state)
{
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
  return this->State[0] != 0.0;
}

//------------------------------------------------------------------------------
int vtkPVHapticStateSource::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->IsNew = false;
  vtkInformation* const output = outputs->GetInformationObject(0);
  return output->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0
    ? 1
    : this->Superclass::RequestData(request, inputs, outputs);
}

//------------------------------------------------------------------------------
void vtkPVHapticStateSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "HasState: " << (this->State[0] != 0.0 ? "Yes" : "No") << "\n";
}
