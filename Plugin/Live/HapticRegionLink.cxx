// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticRegionLink.h"

#include "vtkHapticDevice.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkSMHapticRegionProxy.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkTimerLog.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>

namespace VolumeHapticsLive
{
namespace
{

constexpr std::array<int, 6> Empty = { 0, -1, 0, -1, 0, -1 };
/** The shortest time (s) over which the tip's velocity is measured. */
constexpr double VelocityTime = 0.01;
/** If a user interface was busy for longer (s), that says nothing about the next time. */
constexpr double LongestInterval = 0.5;

} // namespace

void HapticRegionLink::Clear()
{
  this->Proxy = nullptr;
  this->Volume = nullptr;
  this->Filter = nullptr;
  this->Resident = Empty;
  this->IsSurveyed = false;
  this->HasImage = false;
  this->IsRefused = false;
  this->Problem.clear();
}

void HapticRegionLink::Forget()
{
  if (this->Proxy)
  {
    this->Proxy->SetStale(true);
  }
}

bool HapticRegionLink::Follow(
  vtkSMSourceProxy* volume, unsigned int port, vtkVolumeHapticsFilter* filter)
{
  if (volume != this->Volume || port != this->Port || filter != this->Filter || !volume)
  {
    this->Clear();
    filter->SetInputDataObject(0, nullptr);
    if (!volume)
    {
      return false;
    }
    this->Volume = volume;
    this->Port = port;
    this->Filter = filter;
    this->Planner->ResetLatency();
    this->HasLatency = false;
    vtkSmartPointer<vtkSMProxy> proxy;
    proxy.TakeReference(volume->GetSessionProxyManager()->NewProxy("misc", "HapticRegion"));
    this->Proxy = vtkSMHapticRegionProxy::SafeDownCast(proxy);
    if (!this->Proxy)
    {
      this->Problem =
        "The server does not know this plugin. Load VolumeHapticsPlugin on the server, too.";
      return false;
    }
    vtkSMPropertyHelper(this->Proxy, "Input").Set(volume, port);
    this->Proxy->UpdateVTKObjects();
  }
  volume->UpdatePipeline(); // otherwise its next change would not be reported
  const char* const name = filter->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME());
  const std::string array = name ? name : "";
  if (this->Proxy && (array != this->Array || this->Proxy->GetStale()))
  {
    this->Array = array;
    this->IsSurveyed = false;
    this->IsRefused = false;
    this->Resident = Empty;
    this->Proxy->SetStale(false);
  }
  return this->Proxy && !this->IsRefused;
}

HapticRegionLink::Answer HapticRegionLink::Fetch(
  const int region[6], vtkVolumeHapticsFilter* filter)
{
  const double start = vtkTimerLog::GetUniversalTime();
  vtkNew<vtkImageData> image;
  this->Problem.clear();
  const auto answer = this->Proxy->Fetch(this->Array, region, image, this->Problem);
  if (answer != vtkSMHapticRegionProxy::FETCHED)
  {
    this->IsRefused = true;
    return answer == vtkSMHapticRegionProxy::LOST ? Answer::Lost : Answer::Refused;
  }
  if (!this->IsSurveyed)
  {
    this->IsSurveyed = this->Planner->SetWhole(image);
    this->SettingsTime = 0;
  }
  else
  {
    // It may have been wanted ever since the last look.
    this->Planner->AddLatency(this->Interval + vtkTimerLog::GetUniversalTime() - start);
    this->HasLatency = true;
    image->GetExtent(this->Resident.data());
  }
  // While another region is felt, a corner would interrupt it.
  if (this->Resident != Empty || !this->HasImage)
  {
    filter->SetInputDataObject(0, image);
    this->HasImage = true;
  }
  return Answer::Region;
}

void HapticRegionLink::MeasureVelocity(vtkHapticDevice* device)
{
  const double time = device->GetTime();
  const double* const tip = device->GetTipPosition();
  const double elapsed = time - this->Time;
  if (elapsed >= VelocityTime || elapsed < 0.0)
  {
    for (int a = 0; a < 3; ++a)
    {
      this->Velocity[a] =
        this->Time > 0.0 && elapsed > 0.0 ? (tip[a] - this->Tip[a]) / elapsed : 0.0;
      this->Tip[a] = tip[a];
    }
    this->Time = time;
  }
}

HapticRegionLink::Answer HapticRegionLink::Poll(vtkSMSourceProxy* volume, unsigned int port,
  vtkVolumeHapticsFilter* filter, vtkHapticDevice* device)
{
  const double now = vtkTimerLog::GetUniversalTime();
  this->Interval = std::clamp(now - this->PollTime, 0.0, LongestInterval);
  this->PollTime = now;
  if (!this->Follow(volume, port, filter))
  {
    return volume ? Answer::Refused : Answer::Nothing;
  }
  if (!this->IsSurveyed)
  {
    return this->Fetch(Empty.data(), filter);
  }
  this->MeasureVelocity(device);
  if (!device->IsRunning() || device->GetTime() == 0.0)
  {
    return Answer::Nothing;
  }
  if (filter->GetMTime() != this->SettingsTime)
  {
    this->SettingsTime = filter->GetMTime();
    this->Planner->UseSettingsOf(filter);
  }
  int wanted[6];
  return this->Planner->Plan(
           device->GetTipPosition(), this->Velocity.data(), this->Resident.data(), wanted)
    ? this->Fetch(wanted, filter)
    : Answer::Nothing;
}

} // namespace VolumeHapticsLive
