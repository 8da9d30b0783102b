// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Interaction/SecondHand.h"

#include "vtkInteractorStyleHaptic.h"
#include "vtkRenderer.h"

namespace VolumeHaptics
{

SecondHand::SecondHand(TouchedScene& first)
  : Scene(first.Style)
  , Workspace(this->Scene, [] { return true; })
  , First(first)
  , Publisher(this->Scene)
{
}

bool SecondHand::SetDevice(vtkHapticDevice* device)
{
  if (this->Scene.Device == device)
  {
    return false;
  }
  this->Disarm();
  this->Workspace.LeaveDevice();
  this->Scene.Device = device;
  this->Workspace.Reset();
  this->Publisher.Reset();
  return true;
}

void SecondHand::Disarm()
{
  if (const vtkSmartPointer<vtkHapticDevice> device = this->Scene.Device)
  {
    device->Disarm();
  }
}

void SecondHand::FadeOut()
{
  if (const vtkSmartPointer<vtkHapticDevice> device = this->Scene.Device)
  {
    device->FadeOut();
  }
}

bool SecondHand::Update(vtkRenderer* renderer)
{
  // Keep a reference to the device, because observers of the following events may remove it.
  const vtkSmartPointer<vtkHapticDevice> device = this->Scene.Device;
  if (!device || !device->IsRunning())
  {
    return false;
  }
  const vtkSmartPointer<vtkHapticDevice> first = this->First.Device;
  const bool isSame = first && first->GetVolumeHaptics() == device->GetVolumeHaptics();
  const bool isMoving =
    device->GetPlayback()->HasTimeSteps() || (isSame && first->GetPlayback()->HasTimeSteps());
  if (device->IsArmOrdered() && isMoving)
  {
    vtkWarningWithObjectMacro(this->Scene.Style,
      "The second hand feels nothing while the volume moves, because its time would not be that of "
      "the picture. Touch a moving volume with one device.");
    this->FadeOut();
  }
  if (this->Scene.Device != device)
  {
    return false;
  }
  const bool isPlaced =
    renderer && !this->Workspace.IsClutched() && this->Workspace.Update(renderer);
  if (this->Scene.Device != device)
  {
    return false;
  }
  this->Publisher.Update(isPlaced);
  const bool isNew = device->UpdateState();
  this->Workspace.KeepClutch();
  return isNew;
}

} // namespace VolumeHaptics
