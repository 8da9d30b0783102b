// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticReport.h"

#include "vtkHapticDevice.h"
#include "vtkPVHapticStateSource.h"
#include "vtkSMPropertyHelper.h"

#include <algorithm>

namespace VolumeHapticsLive
{

std::string HapticReport::TakeNewError()
{
  const std::string error = this->Errors.Take();
  const bool isNew = error != this->Reported;
  if (!error.empty())
  {
    this->Problem = error;
  }
  this->Reported = error;
  return isNew ? error : std::string();
}

void HapticReport::TellState(vtkSMProxy* proxy, vtkHapticDevice* device)
{
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
  if (device->HasTipOrientation())
  {
    std::copy_n(device->GetTipOrientation(), 4, next);
  }
  vtkSMPropertyHelper(proxy, "State").Set(state, vtkPVHapticStateSource::Length);
}

void HapticReport::TellInformation(vtkSMProxy* proxy, vtkHapticDevice* device, double latency) const
{
  const std::string wrong = this->Problem.empty() ? this->Notice : this->Problem;
  const std::string text = wrong.empty() ? device->GetStatusText() : wrong;
  vtkSMPropertyHelper(proxy, "StatusText").Set(text.c_str());
  vtkSMPropertyHelper(proxy, "TipPosition").Set(device->GetTipPosition(), 3);
  vtkSMPropertyHelper(proxy, "ProxyPosition").Set(device->GetProxyPosition(), 3);
  vtkSMPropertyHelper(proxy, "Force").Set(device->GetForce(), 3);
  vtkSMPropertyHelper(proxy, "ComputedForce").Set(device->GetComputedForce(), 3);
  vtkSMPropertyHelper(proxy, "Contact").Set(device->GetContact());
  vtkSMPropertyHelper(proxy, "TickRate").Set(device->GetTickRate());
  const auto count = [](vtkIdType ticks)
  { return static_cast<int>(std::min<vtkIdType>(ticks, VTK_INT_MAX)); };
  vtkSMPropertyHelper(proxy, "MissedTicks").Set(count(device->GetMissedTicks()));
  vtkSMPropertyHelper(proxy, "AbsentTicks").Set(count(device->GetAbsentTicks()));
  vtkSMPropertyHelper(proxy, "Latency").Set(latency);
  vtkSMPropertyHelper(proxy, "Residency").Set(device->GetResidency());
}

} // namespace VolumeHapticsLive
