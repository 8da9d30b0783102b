// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticReport.h"

#include "vtkHapticDevice.h"
#include "vtkPVHapticStateSource.h"
#include "vtkSMPropertyHelper.h"

#include <algorithm>

namespace VolumeHapticsLive
{

std::string HapticReport::DrainNewError()
{
  const std::string error = this->Errors.Drain();
  const bool isNew = error != this->Reported;
  if (!error.empty())
  {
    this->Problem = error;
  }
  this->Reported = error;
  return isNew ? error : std::string();
}

void HapticReport::ReportState(vtkSMProxy* proxy, vtkHapticDevice* device)
{
  vtkHapticState* const latest = device->GetState();
  double state[vtkPVHapticStateSource::Length] = { 1.0 };
  double* next = state + 1;
  for (const double* const vector : { latest->GetTipPosition(), latest->GetProxyPosition(),
         latest->GetSurfacePosition(), latest->GetMediumPosition(), latest->GetForce(),
         latest->GetComputedForce(), latest->GetNormal() })
  {
    next = std::copy_n(vector, 3, next);
  }
  for (const double number : { latest->GetNormalForce(), latest->GetFrictionForce(),
         static_cast<double>(latest->GetContact()), latest->GetSurfaceValue() })
  {
    *next++ = number;
  }
  if (latest->HasTipOrientation())
  {
    std::copy_n(latest->GetTipOrientation(), 4, next);
  }
  vtkSMPropertyHelper(proxy, "State").Set(state, vtkPVHapticStateSource::Length);
}

void HapticReport::ReportInformation(
  vtkSMProxy* proxy, vtkHapticDevice* device, double latency) const
{
  const std::string wrong = this->Problem.empty() ? this->Notice : this->Problem;
  const std::string text = wrong.empty() ? device->GetStatusText() : wrong;
  vtkHapticState* const latest = device->GetState();
  vtkSMPropertyHelper(proxy, "StatusText").Set(text.c_str());
  vtkSMPropertyHelper(proxy, "TipPosition").Set(latest->GetTipPosition(), 3);
  vtkSMPropertyHelper(proxy, "ProxyPosition").Set(latest->GetProxyPosition(), 3);
  vtkSMPropertyHelper(proxy, "Force").Set(latest->GetForce(), 3);
  vtkSMPropertyHelper(proxy, "ComputedForce").Set(latest->GetComputedForce(), 3);
  vtkSMPropertyHelper(proxy, "Contact").Set(latest->GetContact());
  vtkSMPropertyHelper(proxy, "TickRate").Set(device->GetTickRate());
  const auto count = [](vtkIdType ticks)
  { return static_cast<int>(std::min<vtkIdType>(ticks, VTK_INT_MAX)); };
  vtkSMPropertyHelper(proxy, "MissedTicks").Set(count(device->GetMissedTicks()));
  vtkSMPropertyHelper(proxy, "AbsentTicks").Set(count(device->GetAbsentTicks()));
  vtkSMPropertyHelper(proxy, "Latency").Set(latency);
  vtkSMPropertyHelper(proxy, "Residency").Set(latest->GetResidency());
}

} // namespace VolumeHapticsLive
