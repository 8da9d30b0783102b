// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Interaction/WorkspaceControl.h"

#include "vtkCamera.h"
#include "vtkInteractorStyleHaptic.h"
#include "vtkRenderer.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <utility>

namespace VolumeHaptics
{

WorkspaceControl::WorkspaceControl(TouchedScene& scene, std::function<bool()> armsAfterClutch)
  : Scene(scene)
  , ArmsAfterClutch(std::move(armsAfterClutch))
{
}

void WorkspaceControl::LeaveDevice()
{
  const vtkSmartPointer<vtkHapticDevice> device = this->Scene.Device;
  if (std::exchange(this->IsOn, false) && device)
  {
    device->Disarm();
    device->SetClutch(false);
  }
}

bool WorkspaceControl::Follow(vtkRenderer* renderer)
{
  vtkInteractorStyleHaptic* const style = this->Scene.Style;
  vtkCamera* const camera = renderer->GetActiveCamera();
  const vtkMTimeType time = std::max(camera->GetMTime(), style->GetMTime());
  if (!style->GetWorkspaceFollowsCamera() || !this->Scene.IsReal() ||
    (this->IsPlaced && time == this->Placed))
  {
    return false;
  }
  this->Scene.Device->SetDeviceToWorld(this->Workspace.Place(camera, this->GetScale()));
  this->Placed = time;
  this->IsPlaced = true;
  return true;
}

double WorkspaceControl::GetScale() const
{
  const double scale = this->Scene.Style->GetWorkspaceScale();
  vtkVolumeHapticsFilter* const filter = this->Scene.Device->GetVolumeHaptics();
  const double natural = filter ? 1.0 / filter->GetMetersPerWorldUnit() : 1000.0;
  return scale > 0.0 ? scale : natural;
}

void WorkspaceControl::Recenter()
{
  this->Workspace.Recenter();
  this->Scene.Style->Modified();
}

void WorkspaceControl::SetClutch(bool on)
{
  vtkRenderer* const renderer = this->Scene.FindRenderer();
  if (on == this->IsOn || !this->Scene.IsReal() || !renderer)
  {
    return;
  }
  // Keep the device: observers of the following events may remove it.
  const vtkSmartPointer<vtkHapticDevice> device = this->Scene.Device;
  device->UpdateState();
  const Vector3 tip = this->Scene.GetTip();
  this->IsOn = on;
  if (on)
  {
    this->ClutchedTip = tip;
    device->SetClutch(true);
    return;
  }
  this->Workspace.Shift(renderer->GetActiveCamera(), tip, this->ClutchedTip);
  this->Scene.Style->Modified();
  this->Scene.Style->UpdateHaptics();
  if (device->ArmsAfterClutch() && !this->ArmsAfterClutch())
  {
    device->Disarm();
  }
  device->SetClutch(false);
}

void WorkspaceControl::KeepClutch()
{
  if (this->IsOn)
  {
    this->Scene.Device->SetClutch(true);
  }
}

} // namespace VolumeHaptics
