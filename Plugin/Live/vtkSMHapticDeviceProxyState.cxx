// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// The part of vtkSMHapticDeviceProxy that says how it stands.
#include "vtkSMHapticDeviceProxyInternals.h"

#include "vtkPVHapticStateSource.h"
#include "vtkPVXMLElement.h"
#include "vtkSMPropertyHelper.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <utility>

namespace
{

/** A hand is on the other end of these. */
const char* const Orders[] = { "Armed", "Recording", "Running" };

} // namespace

//------------------------------------------------------------------------------
vtkPVXMLElement* vtkSMHapticDeviceProxy::SaveXMLState(
  vtkPVXMLElement* root, vtkSMPropertyIterator* properties)
{
  vtkPVXMLElement* const state = this->Superclass::SaveXMLState(root, properties);
  for (unsigned int i = state ? state->GetNumberOfNestedElements() : 0; i > 0; --i)
  {
    vtkPVXMLElement* const property = state->GetNestedElement(i - 1);
    const char* const name = property->GetAttribute("name");
    if (name &&
      std::any_of(std::begin(Orders), std::end(Orders),
        [name](const char* order) { return std::strcmp(order, name) == 0; }))
    {
      state->RemoveNestedElement(property);
    }
  }
  return state;
}

//------------------------------------------------------------------------------
int vtkSMHapticDeviceProxy::LoadXMLState(vtkPVXMLElement* element, vtkSMProxyLocator* locator)
{
  // Nothing in between may obey what a state says, whoever wrote it.
  auto& d = *this->Internals;
  const bool wasBusy = std::exchange(d.IsBusy, true);
  int orders[3];
  std::transform(std::begin(Orders), std::end(Orders), orders,
    [this](const char* order) { return this->GetInt(order); });
  const int isLoaded = this->Superclass::LoadXMLState(element, locator);
  for (int i = 0; i < 3; ++i)
  {
    vtkSMPropertyHelper(this, Orders[i]).Set(orders[i]);
  }
  d.IsBusy = wasBusy;
  return isLoaded;
}

//------------------------------------------------------------------------------
void vtkSMHapticDeviceProxy::Report()
{
  auto& d = *this->Internals;
  const std::string error = d.Errors.Take();
  if (!error.empty())
  {
    d.Problem = error;
    if (error != d.Reported)
    {
      vtkErrorMacro(<< error);
    }
  }
  d.Reported = error;
}

//------------------------------------------------------------------------------
void vtkSMHapticDeviceProxy::ShowState()
{
  vtkHapticDevice* const device = this->Internals->Device;
  double state[vtkPVHapticStateSource::Length] = { 1.0 };
  double* next = state + 1;
  for (const double* const vector : { device->GetTipPosition(), device->GetProxyPosition(),
         device->GetSurfacePosition(), device->GetMediumPosition(), device->GetForce(),
         device->GetComputedForce(), device->GetNormal() })
  {
    next = std::copy_n(vector, 3, next);
  }
  for (const double number : { device->GetNormalForce(), device->GetFrictionForce(),
         static_cast<double>(device->GetContact()), device->GetSurfaceValue() })
  {
    *next++ = number;
  }
  vtkSMPropertyHelper(this, "State").Set(state, vtkPVHapticStateSource::Length);
  this->Superclass::UpdateVTKObjects();
}

//------------------------------------------------------------------------------
void vtkSMHapticDeviceProxy::TellInformation()
{
  auto& d = *this->Internals;
  vtkHapticDevice* const device = d.Device;
  const std::string wrong = d.Problem.empty() ? d.Notice : d.Problem;
  const std::string text = wrong.empty() ? device->GetStatusText() : wrong;
  vtkSMPropertyHelper(this, "StatusText").Set(text.c_str());
  vtkSMPropertyHelper(this, "TipPosition").Set(device->GetTipPosition(), 3);
  vtkSMPropertyHelper(this, "ProxyPosition").Set(device->GetProxyPosition(), 3);
  vtkSMPropertyHelper(this, "Force").Set(device->GetForce(), 3);
  vtkSMPropertyHelper(this, "ComputedForce").Set(device->GetComputedForce(), 3);
  vtkSMPropertyHelper(this, "Contact").Set(device->GetContact());
  vtkSMPropertyHelper(this, "TickRate").Set(device->GetTickRate());
  const auto count = [](vtkIdType ticks)
  { return static_cast<int>(std::min<vtkIdType>(ticks, VTK_INT_MAX)); };
  vtkSMPropertyHelper(this, "MissedTicks").Set(count(device->GetMissedTicks()));
  vtkSMPropertyHelper(this, "AbsentTicks").Set(count(device->GetAbsentTicks()));
  vtkSMPropertyHelper(this, "Latency").Set(d.Region.GetLatency());
  vtkSMPropertyHelper(this, "Residency").Set(device->GetResidency());
}

//------------------------------------------------------------------------------
void vtkSMHapticDeviceProxy::UpdatePropertyInformationInternal(vtkSMProperty*)
{
  // They are of the client: there is nothing to ask the server for.
  if (this->ObjectsCreated && !this->Internals->IsBusy)
  {
    this->Internals->Device->UpdateState();
    this->TellInformation();
  }
}
