// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Interaction/TouchedScene.h"

#include "vtkImageData.h"
#include "vtkInteractorStyleHaptic.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkVolumeHapticsFilter.h"

namespace VolumeHaptics
{

vtkRenderer* TouchedScene::ChooseRenderer() const
{
  vtkRenderer* const current = this->Style->GetCurrentRenderer();
  vtkRenderer* const chosen = current ? current : this->Style->GetDefaultRenderer();
  vtkRenderWindowInteractor* const interactor = this->Style->GetInteractor();
  if (chosen || !interactor || !interactor->GetRenderWindow())
  {
    return chosen;
  }
  return interactor->GetRenderWindow()->GetRenderers()->GetFirstRenderer();
}

vtkImageData* TouchedScene::GetImage() const
{
  vtkVolumeHapticsFilter* const filter = this->Device ? this->Device->GetVolumeHaptics() : nullptr;
  return filter ? filter->GetTouchedImage() : nullptr;
}

bool TouchedScene::IsArmed() const
{
  const int status = this->Device->GetStatus();
  return status == vtkHapticDevice::ARMED || status == vtkHapticDevice::ACTIVE;
}

Vector3 TouchedScene::GetTip() const
{
  const double* const tip = this->Device->GetState()->GetTipPosition();
  return { tip[0], tip[1], tip[2] };
}

Vector3 TouchedScene::GetProxy() const
{
  const double* const proxy = this->Device->GetState()->GetProxyPosition();
  return { proxy[0], proxy[1], proxy[2] };
}

} // namespace VolumeHaptics
