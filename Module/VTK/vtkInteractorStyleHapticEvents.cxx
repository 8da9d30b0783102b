// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// The part of vtkInteractorStyleHaptic that listens to mouse and keys.
#include "VTK/Scene/HapticViewRay.h"
#include "vtkInteractorStyleHapticInternals.h"

#include "vtkImageData.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <cmath>
#include <string>

using namespace VolumeHaptics;

namespace
{
/// What Shift makes of a motion.
constexpr double FineFactor = 0.2;
/// What + and - make of the workspace.
constexpr double ScaleFactor = 1.25;

/// Without a window there are no such events, and VTK's own styles would crash.
bool HasWindow(vtkRenderWindowInteractor* interactor)
{
  return interactor && interactor->GetRenderWindow();
}
} // namespace

//------------------------------------------------------------------------------
double vtkInteractorStyleHaptic::GetEffectiveDepthStep()
{
  vtkVolumeHapticsFilter* const filter = this->Internals->Device->GetVolumeHaptics();
  auto* const image =
    filter ? vtkImageData::SafeDownCast(filter->GetInputDataObject(0, 0)) : nullptr;
  if (this->DepthStep > 0.0 || !image)
  {
    return this->DepthStep > 0.0 ? this->DepthStep : 1.0;
  }
  const double* const s = image->GetSpacing();
  return std::min({ std::abs(s[0]), std::abs(s[1]), std::abs(s[2]) });
}

//------------------------------------------------------------------------------
bool vtkInteractorStyleHaptic::LeadsTip()
{
  auto& d = *this->Internals;
  return this->TouchMode && this->State == VTKIS_NONE && d.IsVirtual() && d.Device->IsRunning() &&
    this->GetHapticRenderer();
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::MoveInDepth(double steps)
{
  auto& d = *this->Internals;
  const double fine = this->Interactor->GetShiftKey() ? FineFactor : 1.0;
  const double way = fine * steps * this->GetEffectiveDepthStep();
  d.LeadTo(d.Lead + way * LineOfSight(this->GetHapticRenderer(), d.Lead));
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::OnMouseMove()
{
  if (!HasWindow(this->Interactor))
  {
    return;
  }
  auto& d = *this->Internals;
  const int* const now = this->Interactor->GetEventPosition();
  const int* const before = this->Interactor->GetLastEventPosition();
  if (this->State == VTKIS_NONE && d.Editor && d.Editor->MouseMove(now[0], now[1]))
  {
    this->Draw(true);
    return;
  }
  if (!this->LeadsTip())
  {
    // The superclass asks the window of the renderer for its size: a renderer that was taken out of
    // it meanwhile, or that the application has named, may have none.
    this->FindPokedRenderer(now[0], now[1]);
    if (this->CurrentRenderer && this->CurrentRenderer->GetRenderWindow())
    {
      this->Superclass::OnMouseMove();
    }
    return;
  }
  if (this->Interactor->GetControlKey())
  {
    this->MoveInDepth(0.25 * (now[1] - before[1]));
    return;
  }
  vtkRenderer* const renderer = this->GetHapticRenderer();
  const double fine = this->Interactor->GetShiftKey() ? FineFactor : 1.0;
  const Vector3 way = UnderPointer(renderer, now, d.Lead) - UnderPointer(renderer, before, d.Lead);
  d.LeadTo(d.Lead + fine * way);
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::OnLeftButtonDown()
{
  if (!HasWindow(this->Interactor))
  {
    return;
  }
  auto& d = *this->Internals;
  const int* const at = this->Interactor->GetEventPosition();
  if (d.Editor && d.Editor->ButtonPress(vtkHapticFunctionEditor::LEFT_BUTTON, at[0], at[1]))
  {
    d.EditorHasMouse = true;
  }
  else if (this->LeadsTip())
  {
    d.Device->SetVirtualButtons(1);
  }
  else
  {
    this->Superclass::OnLeftButtonDown();
  }
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::OnLeftButtonUp()
{
  if (!HasWindow(this->Interactor))
  {
    return;
  }
  auto& d = *this->Internals;
  const int* const at = this->Interactor->GetEventPosition();
  if (d.EditorHasMouse)
  {
    d.EditorHasMouse = false;
    if (d.Editor) // else it was taken away meanwhile
    {
      d.Editor->ButtonRelease(vtkHapticFunctionEditor::LEFT_BUTTON, at[0], at[1]);
      this->Draw(true);
    }
  }
  else if (this->LeadsTip())
  {
    d.Device->SetVirtualButtons(0);
  }
  else
  {
    this->Superclass::OnLeftButtonUp();
  }
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::OnLeftButtonDoubleClick()
{
  if (!HasWindow(this->Interactor))
  {
    return;
  }
  auto& d = *this->Internals;
  const int* const at = this->Interactor->GetEventPosition();
  if (d.Editor && d.Editor->DoubleClick(vtkHapticFunctionEditor::LEFT_BUTTON, at[0], at[1]))
  {
    this->Draw(true);
    return;
  }
  this->Superclass::OnLeftButtonDoubleClick();
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::OnRightButtonDown()
{
  if (!HasWindow(this->Interactor))
  {
    return;
  }
  // One can look around without letting go of what is touched.
  this->TouchMode ? this->Superclass::OnLeftButtonDown() : this->Superclass::OnRightButtonDown();
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::OnRightButtonUp()
{
  if (!HasWindow(this->Interactor))
  {
    return;
  }
  // What was begun is ended, whatever the mode is by now.
  this->State == VTKIS_DOLLY ? this->Superclass::OnRightButtonUp()
                             : this->Superclass::OnLeftButtonUp();
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::OnMouseWheelForward()
{
  if (!HasWindow(this->Interactor))
  {
    return;
  }
  this->LeadsTip() && !this->Interactor->GetControlKey() ? this->MoveInDepth(1.0)
                                                         : this->Superclass::OnMouseWheelForward();
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::OnMouseWheelBackward()
{
  if (!HasWindow(this->Interactor))
  {
    return;
  }
  this->LeadsTip() && !this->Interactor->GetControlKey() ? this->MoveInDepth(-1.0)
                                                         : this->Superclass::OnMouseWheelBackward();
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::OnKeyPress()
{
  if (!HasWindow(this->Interactor))
  {
    return;
  }
  auto& d = *this->Internals;
  const char* const symbol = this->Interactor->GetKeySym();
  const std::string key = symbol ? symbol : "";
  const auto toggle = [](auto* prop, auto get, auto set)
  {
    if (prop)
    {
      (prop->*set)(!(prop->*get)());
    }
  };
  if (key == "t")
  {
    this->SetTouchMode(!this->TouchMode);
  }
  else if (key == "Escape")
  {
    this->SetTouchMode(false);
    if (d.Device)
    {
      d.Device->Disarm();
      // A window that loses the focus never hears that the key was let go of.
      this->SetClutch(false);
    }
  }
  else if (key == "a" && d.Device)
  {
    this->Clutch || d.IsArmed() ? d.Device->Disarm() : d.Device->Arm();
  }
  else if (key == "c")
  {
    this->RecenterWorkspace();
  }
  else if (key == "k")
  {
    this->SetClutch(true);
  }
  else if ((key == "plus" || key == "KP_Add" || key == "minus" || key == "KP_Subtract") && d.Device)
  {
    const bool larger = key == "plus" || key == "KP_Add";
    this->SetWorkspaceScale(this->GetEffectiveScale() * (larger ? ScaleFactor : 1.0 / ScaleFactor));
  }
  else if (key == "Home" && d.Device)
  {
    d.Device->Home();
  }
  else if (key == "m" && d.Device)
  {
    this->NextMethod();
  }
  else if (key == "h")
  {
    toggle(d.Display.GetPointer(), &vtkHapticHeadUpDisplay::GetTextVisibility,
      &vtkHapticHeadUpDisplay::SetTextVisibility);
  }
  else if (key == "g")
  {
    toggle(d.Display.GetPointer(), &vtkHapticHeadUpDisplay::GetPlotVisibility,
      &vtkHapticHeadUpDisplay::SetPlotVisibility);
  }
  else if (key == "v")
  {
    toggle(d.Editor.GetPointer(), &vtkProp::GetVisibility, &vtkProp::SetVisibility);
  }
  else if (key == "n" && d.Editor)
  {
    d.Editor->NextFunction();
  }
  else
  {
    this->Superclass::OnKeyPress();
    return;
  }
  this->Draw(true);
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::OnKeyRelease()
{
  if (!HasWindow(this->Interactor))
  {
    return;
  }
  const char* const symbol = this->Interactor->GetKeySym();
  if (symbol && std::string(symbol) == "k")
  {
    this->SetClutch(false);
    return;
  }
  this->Superclass::OnKeyRelease();
}

//------------------------------------------------------------------------------
void vtkInteractorStyleHaptic::OnChar()
{
  if (!HasWindow(this->Interactor))
  {
    return;
  }
  // In the touch mode the superclass' f would fly the camera away from the hand; its m starts an
  // animation.
  const char key = this->Interactor->GetKeyCode();
  if (!(this->TouchMode && key == 'f') && key != 'm')
  {
    this->Superclass::OnChar();
  }
}
