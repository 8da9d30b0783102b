// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Interaction/SceneMouse.h"

#include "VTK/Base/HapticTuples.h"
#include "VTK/Scene/Hand/DrawnTool.h"
#include "VTK/Scene/Interaction/TouchMode.h"

#include "vtkCamera.h"
#include "vtkInteractorStyleHaptic.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkTimerLog.h"

#include <algorithm>
#include <utility>

namespace VolumeHaptics
{
namespace
{

constexpr double RadiansPerPixel = 0.01;
constexpr double RadiansPerStep = 0.1; ///< rad per step of the wheel
constexpr double FineFraction = 0.2;   ///< factor on turns with Shift
constexpr double SameMotion = 0.5;     ///< s: longest pause within one motion

} // namespace

int SliceMouse::Find(int x, int y) const
{
  vtkHapticSliceView* const slices = this->Scene.Slices;
  vtkRenderWindowInteractor* const interactor = this->Scene.Style->GetInteractor();
  // During a drag that began in the scene, the mouse counts as outside all slices.
  return slices && slices->GetRenderWindow() == interactor->GetRenderWindow() &&
      this->Scene.Style->GetState() == VTKIS_NONE
    ? slices->FindSlice(x, y)
    : -1;
}

bool SliceMouse::Press(int x, int y, bool isRight)
{
  const int slice = this->Find(x, y);
  if (slice < 0)
  {
    return false;
  }
  if (this->Dragged != Drag::None)
  {
    return true; // during a drag, the other button has no effect
  }
  const bool isLook = isRight || this->Scene.Style->GetInteractor()->GetShiftKey() != 0;
  this->Dragged = isLook ? Drag::WindowLevel : Drag::Position;
  this->IsRight = isRight;
  this->Slice = slice;
  this->From[0] = x;
  this->From[1] = y;
  this->Scene.Slices->GetShownWindowLevel(this->Before);
  if (!isLook)
  {
    this->GoTo(x, y);
    const int hold = this->Scene.Style->GetHoldClicks();
    this->Scene.Style->SetHoldClicks(hold == 2 ? 1 : hold); // keep the hand in this place
  }
  return true;
}

bool SliceMouse::Release(bool isRight)
{
  if (this->Dragged == Drag::None || this->IsRight != isRight)
  {
    return false;
  }
  this->Dragged = Drag::None;
  return true;
}

bool SliceMouse::Move(int x, int y)
{
  if (!this->Scene.Slices)
  {
    this->Dragged = Drag::None;
    return false;
  }
  if (this->Dragged == Drag::Position)
  {
    this->GoTo(x, y);
    return true;
  }
  if (this->Dragged == Drag::WindowLevel)
  {
    this->SetWindowLevel(x, y);
    return true;
  }
  return this->Find(x, y) >= 0;
}

bool SliceMouse::TurnWheel(double steps, int x, int y)
{
  const int slice = this->Find(x, y);
  if (slice < 0)
  {
    return false;
  }
  double position[3];
  this->Scene.Slices->GetPosition(position);
  if (this->Touch.LeadsTip())
  {
    // Continue from the target of the tip, since the tip may still be on its way.
    const Vector3& lead = this->Touch.GetLead();
    position[0] = lead.X;
    position[1] = lead.Y;
    position[2] = lead.Z;
  }
  if (this->Scene.Slices->MoveAcross(slice, this->Touch.GetFineness() * steps, position))
  {
    this->GoTo(position);
  }
  return true;
}

bool SliceMouse::DrainChange()
{
  return std::exchange(this->HasChanged, false);
}

void SliceMouse::GoTo(int x, int y)
{
  double position[3];
  if (!this->Scene.Slices->FindPosition(this->Slice, x, y, position))
  {
    return;
  }
  const bool canBegin =
    this->Scene.IsVirtual() && this->Scene.Device->IsRunning() && !this->Touch.IsOn();
  if (canBegin)
  {
    this->Touch.BeginAt({ position[0], position[1], position[2] });
  }
  this->GoTo(position);
}

void SliceMouse::GoTo(const double position[3])
{
  if (this->Touch.LeadsTip())
  {
    if (this->Scene.Style->GetHoldClicks() != 1) // a held hand stays in place
    {
      this->Touch.LeadTo({ position[0], position[1], position[2] });
    }
    return;
  }
  // Check again: an observer of the start of the touch mode may have removed the slices.
  if (this->Scene.Slices)
  {
    this->Scene.Slices->SetPosition(position);
    this->HasChanged = true;
  }
}

void SliceMouse::SetWindowLevel(int x, int y)
{
  // A motion over the slice's whole width changes the window by four times its value, as in
  // vtkInteractorStyleImage.
  constexpr double speed = 4.0;
  constexpr double least = 0.01; // smallest factor on the window
  vtkRenderer* const renderer = this->Scene.Slices->GetRenderer(this->Slice);
  const int* const size = renderer->GetSize();
  const double across = speed * (x - this->From[0]) / std::max(1, size[0]);
  const double upwards = speed * (y - this->From[1]) / std::max(1, size[1]);
  const double window = this->Before[0];
  this->Scene.Slices->SetColorWindow(window * std::max(least, 1.0 + across));
  this->Scene.Slices->SetColorLevel(this->Before[1] + upwards * window);
  this->HasChanged = true;
}

bool ToolTurn::HasTool() const
{
  vtkHapticDevice* const device = this->Scene.Device;
  return device && device->IsRunning() && !device->GetState()->IsTipOrientationMeasured() &&
    IsTurnable(GetHeldTool(device)) && this->Scene.ChooseRenderer();
}

bool ToolTurn::IsOn() const
{
  return this->Scene.Style->GetInteractor()->GetAltKey() != 0 && this->HasTool();
}

void ToolTurn::Roll(const int from[2], const int to[2])
{
  const double right = RadiansPerPixel * (from[1] - to[1]);
  const double up = RadiansPerPixel * (to[0] - from[0]);
  this->TurnBy({ right, up, 0.0 });
}

void ToolTurn::Twist(double steps)
{
  this->TurnBy({ 0.0, 0.0, RadiansPerStep * steps });
}

Quaternion ToolTurn::FindStart()
{
  vtkHapticDevice* const device = this->Scene.Device;
  std::array<double, 16> placement{};
  if (vtkMatrix4x4* const matrix = device->GetDeviceToWorld())
  {
    std::copy_n(matrix->GetData(), placement.size(), placement.begin());
  }
  // Within a motion, continue from the last ordered orientation, because the tool turns more slowly
  // than the mouse and its state is delayed. After a pause, start from the state, because the
  // program may have turned the tool.
  const double time = vtkTimerLog::GetUniversalTime();
  const bool isKnown = time - this->Turned < SameMotion && placement == this->Placement;
  this->Placement = placement;
  this->Turned = time;
  if (isKnown)
  {
    return this->Wish;
  }
  const double* const held = device->GetState()->HasTipOrientation()
    ? device->GetState()->GetTipOrientation()
    : device->GetState()->GetToolOrientation();
  const Quaternion q{ held[0], held[1], held[2], held[3] };
  return IsIdentical(q, NoOrientation) ? Quaternion{} : q;
}

void ToolTurn::TurnBy(const Vector3& angles)
{
  vtkCamera* const camera = this->Scene.ChooseRenderer()->GetActiveCamera();
  const bool isFine = this->Scene.Style->GetInteractor()->GetShiftKey() != 0;
  const Vector3 back = -FromArray(camera->GetDirectionOfProjection());
  const Vector3 across = Cross(FromArray(camera->GetViewUp()), back);
  const Vector3 right = (1.0 / Norm(across)) * across;
  const Vector3 axis = angles.X * right + angles.Y * Cross(back, right) + angles.Z * back;
  const Vector3 half = (isFine ? 0.5 * FineFraction : 0.5) * axis;
  const Quaternion turned = Quaternion{ 1.0, half.X, half.Y, half.Z } * this->FindStart();
  this->Wish = (1.0 / std::sqrt(SquaredNorm(turned))) * turned;
  this->Scene.Device->GetVirtualHand()->SetToolOrientation(
    this->Wish.W, this->Wish.X, this->Wish.Y, this->Wish.Z);
}

} // namespace VolumeHaptics
