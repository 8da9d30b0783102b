// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// The part of vtkSMHapticDeviceProxy that has what is touched, wherever it is.
#include "vtkSMHapticDeviceProxyInternals.h"

#include "vtkHapticProperty.h"
#include "vtkPVSession.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSession.h"
#include "vtkSMSessionProxyManager.h"

//------------------------------------------------------------------------------
bool vtkSMHapticDeviceProxy::IsLocal() const
{
  return this->Session && this->Session->HasProcessRole(vtkPVSession::DATA_SERVER);
}

//------------------------------------------------------------------------------
void vtkSMHapticDeviceProxy::FollowData()
{
  auto& d = *this->Internals;
  vtkSMProxy* const touch = vtkSMPropertyHelper(this, "Touch").GetAsProxy();
  d.Touch.Follow(touch);
  vtkVolumeHapticsFilter* const filter = d.Touch.GetFilter();
  if (!filter)
  {
    if (touch && d.Problem.empty())
    {
      d.Problem = "Touch names something that is no Volume Haptics filter. Set it to one whose "
                  "Input is the volume.";
    }
    return;
  }
  d.Errors.Catch(filter);
  unsigned int port = 0;
  vtkSMSourceProxy* const volume = d.Touch.GetInput("Input", port);
  unsigned int surfacePort = 0;
  vtkSMSourceProxy* const surface = d.Touch.GetInput("Surface", surfacePort);
  this->FollowTime(volume);
  if (this->IsLocal())
  {
    d.Image.Follow(volume, port, filter, 0);
    d.Surface.Follow(surface, surfacePort, filter, 2);
  }
  else if (this->GetInt("Running"))
  {
    this->FollowRegion(volume, port);
    if (surface && d.Problem.empty())
    {
      d.Problem = "A Surface on a server is not touched; the isosurface at IsoValue is. To touch "
                  "the Surface, open the data without a server.";
    }
  }
  vtkVolumeProperty* const seen =
    this->GetInt("FollowOpacity") ? d.Opacity.Find(volume, filter) : nullptr;
  filter->GetProperty()->SetVisibilityFrom(d.Visibility ? d.Visibility.Get() : seen);
}

//------------------------------------------------------------------------------
void vtkSMHapticDeviceProxy::FollowTime(vtkSMSourceProxy* volume)
{
  auto& d = *this->Internals;
  vtkSMProxy* const keeper = this->GetSessionProxyManager()->GetProxy("timekeeper", "TimeKeeper");
  const double time = keeper ? vtkSMPropertyHelper(keeper, "Time").GetAsDouble() : d.ViewTime;
  if (volume && time != d.ViewTime)
  {
    d.ViewTime = time;
    volume->UpdatePipeline(time);
    d.Region.Forget();
  }
}

//------------------------------------------------------------------------------
void vtkSMHapticDeviceProxy::FollowRegion(vtkSMSourceProxy* volume, unsigned int port)
{
  using VolumeHapticsLive::HapticRegionLink;

  auto& d = *this->Internals;
  d.Region.SetMaximumVoxels(vtkSMPropertyHelper(this, "MaximumRegionVoxels").GetAsIdType());
  switch (d.Region.Poll(volume, port, d.Touch.GetFilter(), d.Device))
  {
    case HapticRegionLink::Answer::Lost:
      this->LoseServer();
      break;
    case HapticRegionLink::Answer::Refused:
      d.Problem = d.Region.GetProblem();
      break;
    default:
      break;
  }
}
