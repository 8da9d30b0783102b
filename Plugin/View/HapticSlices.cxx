// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticSlices.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyIterator.h"
#include "vtkSMSession.h"
#include "vtkSMViewProxy.h"
#include "vtkTimerLog.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace VolumeHaptics
{
namespace
{

constexpr double ShortestPause = 0.05; // s
constexpr double PauseShare = 4.0;     // multiples of the time that drawing took

std::vector<vtkSMViewProxy*> FindSliceViews(vtkSMSession* session)
{
  std::vector<vtkSMViewProxy*> views;
  vtkNew<vtkSMProxyIterator> proxies;
  proxies->SetSession(session);
  proxies->SetModeToOneGroup();
  for (proxies->Begin("views"); !proxies->IsAtEnd(); proxies->Next())
  {
    auto* const view = vtkSMViewProxy::SafeDownCast(proxies->GetProxy());
    if (view && std::strcmp(view->GetXMLName(), "OrthographicSliceView") == 0)
    {
      views.push_back(view);
    }
  }
  return views;
}

} // namespace

void HapticSlices::Follow(
  vtkSMSession* session, vtkVolumeHapticsFilter* filter, const double tip[3])
{
  const double now = vtkTimerLog::GetUniversalTime();
  if (std::equal(tip, tip + 3, this->Last) || now < this->NextTime)
  {
    return;
  }
  const bool isFirst = !this->IsKnown;
  std::copy(tip, tip + 3, this->Last);
  this->IsKnown = true;
  if (isFirst)
  {
    return; // a device's first position is no motion
  }
  double position[3];
  std::copy(tip, tip + 3, position);
  if (vtkImageData* const image = filter ? filter->GetTouchedImage() : nullptr)
  {
    const double* const bounds = image->GetBounds();
    for (int axis = 0; axis < 3; ++axis)
    {
      position[axis] = std::min(std::max(position[axis], bounds[2 * axis]), bounds[2 * axis + 1]);
    }
  }
  for (vtkSMViewProxy* const view : FindSliceViews(session))
  {
    vtkSMPropertyHelper(view, "SlicePosition").Set(position, 3);
    view->UpdateVTKObjects();
    if (vtkSMPropertyHelper(view, "EnableRenderOnInteraction", true).GetAsInt() == 1)
    {
      view->StillRender();
    }
  }
  const double end = vtkTimerLog::GetUniversalTime();
  this->NextTime = end + std::max(ShortestPause, PauseShare * (end - now));
}

} // namespace VolumeHaptics
