// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticRegionLink.h"

#include "HapticTimeStepLink.h"

#include "VTK/Filter/PlannerSettings.h"

#include "vtkHapticDevice.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkSMHapticRegionProxy.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkTimerLog.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <utility>

namespace VolumeHapticsLive
{
namespace
{

constexpr std::array<int, 6> Empty = { 0, -1, 0, -1, 0, -1 };
/** Shortest time (s) over which the tip's velocity is measured. */
constexpr double VelocityTime = 0.01;
/**
 * Longest delay (s) that is used. Longer delays are caused by a busy user interface, and do not
 * predict the next delay.
 */
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

bool HapticRegionLink::Update(
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
    this->Planner.ResetLatency();
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
  const int region[6], double time, vtkImageData* image)
{
  this->Problem.clear();
  const bool isPresent = time == this->ViewTime;
  const auto answer =
    this->Proxy->Fetch(this->Array, region, time, isPresent, image, this->Problem);
  if (answer != vtkSMHapticRegionProxy::FETCHED)
  {
    this->IsRefused = true;
    return answer == vtkSMHapticRegionProxy::LOST ? Answer::Lost : Answer::Refused;
  }
  return Answer::Region;
}

/** Fetches a corner to determine the position of the volume, or the first region after that. */
HapticRegionLink::Answer HapticRegionLink::FetchFirst(const int region[6], double time,
  vtkVolumeHapticsFilter* filter, vtkHapticDevice* device, HapticTimeStepLink& timeSteps)
{
  const double start = vtkTimerLog::GetUniversalTime();
  vtkNew<vtkImageData> image;
  const Answer answer = this->Fetch(region, time, image);
  if (answer != Answer::Region)
  {
    return answer;
  }
  if (!this->IsSurveyed)
  {
    this->IsSurveyed = this->Planner.SetWhole(image, this->Problem);
    this->SettingsTime = 0;
  }
  else
  {
    this->RecordLatency(start);
    image->GetExtent(this->Resident.data());
  }
  // Don't pass the corner on while a previous region is felt, because this would interrupt the
  // touch.
  if (this->Resident != Empty || !this->HasImage)
  {
    this->IsMoving ? timeSteps.Begin(image, time, filter, device)
                   : filter->SetInputDataObject(0, image);
    this->HasImage = true;
    this->HasTimeSteps = this->IsMoving;
  }
  return Answer::Region;
}

/**
 * Fetches a region at `time`. If the servo is moving from the previous time, also fetches the
 * region at that time.
 */
HapticRegionLink::Answer HapticRegionLink::FetchTimeSteps(
  const int region[6], double time, vtkHapticDevice* device, HapticTimeStepLink& timeSteps)
{
  const double start = vtkTimerLog::GetUniversalTime();
  const bool isNext = time != timeSteps.GetTime();
  const double before = isNext ? timeSteps.GetTime() : timeSteps.GetTimeBefore();
  const bool isElsewhere = !std::equal(region, region + 6, this->Resident.begin());
  const bool isBetween = !timeSteps.IsFirst() && !timeSteps.IsThere(device);
  vtkNew<vtkImageData> image;
  vtkSmartPointer<vtkImageData> last = isNext ? timeSteps.GetImage() : image.Get();
  if (isElsewhere && (isNext || isBetween))
  {
    last = vtkSmartPointer<vtkImageData>::New();
    const Answer answer = this->Fetch(region, before, last);
    if (answer == Answer::Refused)
    {
      // The server no longer has the previous time, so begin again with its current time.
      this->IsRefused = false;
      this->Proxy->SetStale(true);
      return Answer::Nothing;
    }
    if (answer != Answer::Region)
    {
      return answer;
    }
  }
  const Answer answer = this->Fetch(region, time, image);
  if (answer != Answer::Region)
  {
    return answer;
  }
  if (isElsewhere)
  {
    this->RecordLatency(start);
    image->GetExtent(this->Resident.data());
  }
  isNext ? timeSteps.Go(last, image, time, device) : timeSteps.Replace(last, image);
  return Answer::Region;
}

/**
 * Records how long a region took, including the interval between polls, because the region may have
 * been needed since the last poll.
 */
void HapticRegionLink::RecordLatency(double start)
{
  this->Planner.AddLatency(this->Interval + vtkTimerLog::GetUniversalTime() - start);
  this->HasLatency = true;
}

void HapticRegionLink::MeasureVelocity(vtkHapticDevice* device)
{
  const double time = device->GetState()->GetTime();
  const double* const tip = device->GetState()->GetTipPosition();
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
  double time, vtkVolumeHapticsFilter* filter, vtkHapticDevice* device,
  HapticTimeStepLink& timeSteps)
{
  const double now = vtkTimerLog::GetUniversalTime();
  this->Interval = std::clamp(now - this->PollTime, 0.0, LongestInterval);
  this->PollTime = now;
  if (volume)
  {
    volume->UpdatePipeline(); // otherwise, the filter's next change would not be reported
  }
  const bool wasMoving =
    std::exchange(this->IsMoving, HapticTimeStepLink::IsMoving(volume, port, filter));
  if (this->Proxy && (wasMoving != this->IsMoving || (!this->IsMoving && time != this->ViewTime)))
  {
    this->Proxy->SetStale(true);
  }
  this->ViewTime = time;
  if (!this->Update(volume, port, filter))
  {
    return volume ? Answer::Refused : Answer::Nothing;
  }
  if (!this->IsSurveyed)
  {
    this->HasTimeSteps = false;
    return this->FetchFirst(Empty.data(), time, filter, device, timeSteps);
  }
  this->MeasureVelocity(device);
  if (!device->IsRunning() || device->GetState()->GetTime() == 0.0)
  {
    return Answer::Nothing;
  }
  if (filter->GetMTime() != this->SettingsTime)
  {
    this->SettingsTime = filter->GetMTime();
    VolumeHaptics::ConfigurePlanner(this->Planner, filter);
  }
  int wanted[6];
  const bool isElsewhere = this->Planner.Plan(
    device->GetState()->GetTipPosition(), this->Velocity.data(), this->Resident.data(), wanted);
  if (!this->HasTimeSteps)
  {
    return isElsewhere ? this->FetchFirst(wanted, time, filter, device, timeSteps)
                       : Answer::Nothing;
  }
  const bool isNext = time != timeSteps.GetTime() && timeSteps.IsThere(device);
  if (!isElsewhere && (!isNext || this->Resident == Empty))
  {
    return Answer::Nothing;
  }
  return this->FetchTimeSteps(isElsewhere ? wanted : this->Resident.data(),
    isNext ? time : timeSteps.GetTime(), device, timeSteps);
}

} // namespace VolumeHapticsLive
