// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticReport.h"

#include "vtkHapticDevice.h"
#include "vtkPVHapticStateSource.h"
#include "vtkSMPropertyHelper.h"

#include <algorithm>
#include <cstring>

namespace VolumeHapticsLive
{
namespace
{

/**
 * Replaces the library's texts for programmers by the texts of ParaView's dock and panels. The
 * first match in the list is used.
 */
constexpr const char* Words[][2] = {
  { "Closed. Open() a device.", "Closed: attach a device, or set Running." },
  { ". Start() the servo.", ": set Running." },
  { ". Arm() lets force through.", ": Arm lets force through." },
  { "Open() and Start() it", "attach it again" },
  { "Open() it again", "attach it again" },
  { "Open()", "Attach" },
  { "Start()", "Running" },
  { "Arm()", "Arm" },
  { "Home()", "Home" },
  { "SetMaximumForce()", "Maximum Force" },
  { "UseToolOff() of this device", "Use Tool off for this device" },
  { "SetVolumeHaptics()", "Touch" },
  { "a program of your own may raise AttentionTime", "or raise Attention Time" },
  { "AttentionTime", "Attention Time" },
};

std::string SayAsPanel(std::string text)
{
  for (const auto& [from, to] : Words)
  {
    for (std::size_t at = text.find(from); at != std::string::npos;
         at = text.find(from, at + std::strlen(to)))
    {
      text.replace(at, std::strlen(from), to);
    }
  }
  return text;
}

} // namespace

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
  const std::string text = SayAsPanel(wrong.empty() ? device->GetStatusText() : wrong);
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
