// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Base/WindowDock.h"

#include "VTK/Scene/Base/DockLayout.h"

namespace VolumeHaptics
{

void WindowDock::Place(
  vtkRenderWindow* window, DockEdge edge, double share, const std::vector<vtkRenderer*>& strip)
{
  if (this->Layout && this->Layout->GetWindow() != window)
  {
    this->GiveBack();
  }
  if (!this->Layout)
  {
    this->Layout = DockLayout::Of(window);
  }
  this->Layout->Place(this, edge, share, strip);
}

void WindowDock::GiveBack()
{
  if (this->Layout)
  {
    this->Layout->Remove(this);
    this->Layout = nullptr;
  }
}

} // namespace VolumeHaptics
