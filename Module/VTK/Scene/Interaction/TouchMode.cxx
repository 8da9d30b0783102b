// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Interaction/TouchMode.h"

#include "VTK/Base/HapticTuples.h"
#include "VTK/Base/HapticVolume.h"
#include "VTK/Device/HapticLongWork.h"
#include "VTK/Filter/HapticBaker.h"
#include "VTK/Scene/Base/HapticViewRay.h"
#include "VTK/Scene/Frames/HapticWindowWatch.h"
#include "VTK/Scene/Hand/DrawnTool.h"
#include "VTK/Scene/Interaction/WorkspaceControl.h"

#include "vtkCamera.h"
#include "vtkInteractorObserver.h"
#include "vtkInteractorStyleHaptic.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace VolumeHaptics
{
namespace
{

/** Returns a position in the window (pixels). */
std::array<double, 2> FindInWindow(vtkRenderer* renderer, const Vector3& position)
{
  double display[3];
  vtkInteractorObserver::ComputeWorldToDisplay(
    renderer, position.X, position.Y, position.Z, display);
  return { display[0], display[1] };
}

/**
 * Returns a position in the camera's view, independently of the part of the window that shows the
 * view.
 */
std::array<double, 2> FindInView(vtkRenderer* renderer, const Vector3& position)
{
  double at[4] = { position.X, position.Y, position.Z, 1.0 };
  renderer->GetActiveCamera()
    ->GetCompositeProjectionTransformMatrix(1.0, -1.0, 1.0)
    ->MultiplyPoint(at, at);
  return { at[0] / at[3], at[1] / at[3] };
}

} // namespace

void TouchMode::Set(bool on)
{
  if (!on)
  {
    this->IsBeginning = false;
  }
  if (on == this->IsTouching)
  {
    return;
  }
  if (on)
  {
    this->Begin(nullptr);
    return;
  }
  this->IsTouching = false;
  this->ReleaseButton();
  this->Window.Look();
  if (this->Scene.Device && this->Scene.Device->IsArmOrdered())
  {
    // Disarm unless already disarmed, so that a fading force continues to fade.
    this->Scene.Device->Disarm();
  }
  this->Scene.Style->SetHoldClicks(0);
  this->Scene.Style->Modified();
}

void TouchMode::Begin(const Vector3* at)
{
  if (this->BeforeBegin)
  {
    this->BeforeBegin();
  }
  vtkRenderWindowInteractor* const interactor = this->Scene.Style->GetInteractor();
  if (!this->Scene.Device || !this->Scene.Device->IsRunning())
  {
    vtkErrorWithObjectMacro(this->Scene.Style,
      "There is nothing to touch with: call SetDevice() with a device that is open and started.");
    return;
  }
  if (!interactor)
  {
    vtkErrorWithObjectMacro(this->Scene.Style,
      "The touch mode needs a window, but this style has no interactor: pass the style "
      "to SetInteractorStyle() of the window's interactor.");
    return;
  }
  if (this->Window.IsClosed())
  {
    vtkErrorWithObjectMacro(this->Scene.Style,
      "The touch mode needs a window, but it was closed: Render() it to open it again.");
    return;
  }
  if (!this->Scene.Hidden.empty())
  {
    vtkWarningWithObjectMacro(this->Scene.Style, << this->Scene.Hidden);
    return;
  }
  // Observers of the long work may end the loop, disarm, or remove the device or the interactor.
  // Each of these cancels the start, and nothing is armed. Keep references to the objects until
  // then.
  const vtkSmartPointer<vtkInteractorStyleHaptic> style = this->Scene.Style;
  const vtkSmartPointer<vtkHapticDevice> device = this->Scene.Device;
  const vtkSmartPointer<vtkRenderer> renderer = this->Scene.ChooseRenderer();
  const bool leadsTip = this->Scene.IsVirtual() && renderer;
  Vector3 start;
  const std::array<int, 2> pointer = this->FindPointer();
  this->IsBeginning = true;
  if (leadsTip && at)
  {
    start = *at;
  }
  else if (leadsTip)
  {
    const double* const focus = renderer->GetActiveCamera()->GetFocalPoint();
    start = UnderPointer(renderer, pointer.data(), { focus[0], focus[1], focus[2] });
    if (this->BeforeLanding)
    {
      this->BeforeLanding(renderer, start);
    }
    if (const vtkSmartPointer<vtkVolumeHapticsFilter> filter = device->GetVolumeHaptics())
    {
      // If the mesh is made in the background, the work takes no time here.
      BakePreparation& baking = filter->GetBaker().GetPreparation();
      const LongWork work(device, MeshingWork, baking.Prepare() ? 0.0 : baking.EstimateTime());
      if (this->IsBeginning && FindFirstContact(renderer, start, filter, start))
      {
        start = start - ComputeToolReach(filter->GetTool()) * LineOfSight(renderer, start);
      }
    }
  }
  this->Window.Look();
  if (!std::exchange(this->IsBeginning, false))
  {
    return;
  }
  if (leadsTip)
  {
    device->GetVirtualHand()->Place(start.X, start.Y, start.Z);
    this->LeadTo(start);
    this->IsNew = !at;
    this->From = pointer;
  }
  this->IsTouching = true;
  if (!this->Workspace.IsClutched())
  {
    device->Arm();
  }
  style->Modified();
}

bool TouchMode::LeadsTip() const
{
  return this->IsTouching && this->Scene.Style->GetState() == VTKIS_NONE &&
    this->Scene.IsVirtual() && this->Scene.Device->IsRunning() && this->Scene.ChooseRenderer();
}

void TouchMode::PressButton()
{
  this->IsPressed = true;
  this->Scene.Device->GetVirtualHand()->SetButtons(1);
}

bool TouchMode::ReleaseButton()
{
  if (!std::exchange(this->IsPressed, false))
  {
    return false;
  }
  if (this->Scene.Device && this->Scene.IsVirtual())
  {
    this->Scene.Device->GetVirtualHand()->SetButtons(0);
  }
  return true;
}

double TouchMode::GetDepthStep() const
{
  const double wanted = this->Scene.Style->GetDepthStep();
  vtkImageData* const image = this->Scene.GetImage();
  const double least = image ? SmallestSpacing(image) : 1.0;
  return wanted > 0.0 ? wanted : least;
}

double TouchMode::GetFineness() const
{
  constexpr double fine = 0.2; // factor with Shift
  return this->Scene.Style->GetInteractor()->GetShiftKey() ? fine : 1.0;
}

void TouchMode::LeadTo(const Vector3& world)
{
  vtkRenderer* const renderer = this->Scene.ChooseRenderer();
  this->Lead = world;
  this->InWindow = FindInWindow(renderer, world);
  this->InView = FindInView(renderer, world);
  this->Scene.Device->GetVirtualHand()->SetPosition(world.X, world.Y, world.Z);
}

std::array<int, 2> TouchMode::FindPointer() const
{
  const int* const at = this->Scene.Style->GetInteractor()->GetEventPosition();
  return { at[0], at[1] };
}

void TouchMode::RecordMotion()
{
  this->From = this->IsNew ? this->From : this->To;
  this->To = this->FindPointer();
}

std::array<int, 2> TouchMode::TakeMotion()
{
  this->IsNew = false;
  this->To = this->FindPointer();
  return std::exchange(this->From, this->To);
}

void TouchMode::MoveInDepth(double steps)
{
  const double length = this->GetFineness() * steps * this->GetDepthStep();
  // Start from the hand's position, so that a press does not move the hand sideways, even if the
  // picture has changed.
  this->LeadTo(this->Lead + length * LineOfSight(this->Scene.ChooseRenderer(), this->Lead));
}

void TouchMode::MoveInPlane(const std::array<int, 2>& from, const std::array<int, 2>& to)
{
  vtkRenderer* const renderer = this->Scene.ChooseRenderer();
  const Vector3 motion =
    UnderPointer(renderer, to.data(), this->Lead) - UnderPointer(renderer, from.data(), this->Lead);
  const Vector3 target = this->FindStart(renderer) + this->GetFineness() * motion;
  const bool follows = this->Scene.Style->GetTipFollowsSurface() && this->HasSurfaces();
  this->LeadTo(follows ? this->ProjectOnSurface(renderer, target) : target);
}

Vector3 TouchMode::FindStart(vtkRenderer* renderer) const
{
  constexpr double same = 1e-6; // largest change of the position in the view (in halves of its
                                // height) that counts as none
  const std::array<double, 2> now = FindInView(renderer, this->Lead);
  // If the camera has moved, start from the hand's present position.
  return std::hypot(now[0] - this->InView[0], now[1] - this->InView[1]) < same
    ? UnderPointer(renderer, this->InWindow.data(), this->Lead)
    : this->Lead;
}

void TouchMode::KeepInWindow(const std::function<void()>& zoom)
{
  const vtkSmartPointer<vtkRenderer> renderer = this->Scene.ChooseRenderer();
  const std::array<double, 2> before = FindInWindow(renderer, this->Lead);
  zoom();
  if (!this->LeadsTip())
  {
    return; // an observer of the zoom has ended the touch mode
  }
  vtkCamera* const camera = renderer->GetActiveCamera();
  const Vector3 shift = this->Lead - UnderPointer(renderer, before.data(), this->Lead);
  const Vector3 position = FromArray(camera->GetPosition()) + shift;
  const Vector3 focus = FromArray(camera->GetFocalPoint()) + shift;
  camera->SetPosition(position.X, position.Y, position.Z);
  camera->SetFocalPoint(focus.X, focus.Y, focus.Z);
  if (this->Scene.Style->GetAutoAdjustCameraClippingRange())
  {
    renderer->ResetCameraClippingRange();
  }
}

bool TouchMode::IsOutOfView() const
{
  vtkRenderer* const renderer = this->Scene.ChooseRenderer();
  if (!this->LeadsTip() || !renderer->GetRenderWindow())
  {
    return false;
  }
  const std::array<double, 2> at = FindInWindow(renderer, this->Lead);
  return !renderer->IsInViewport(static_cast<int>(at[0]), static_cast<int>(at[1]));
}

double TouchMode::GetTravelTime() const
{
  vtkVolumeHapticsFilter* const filter = this->Scene.Device->GetVolumeHaptics();
  // Metres of hand motion per world unit.
  const double meters = filter ? filter->GetMetersPerWorldUnit() : 0.0;
  return meters * Norm(this->Lead - this->Scene.GetTip()) / vtkHapticVirtualHand::GetSpeed();
}

bool TouchMode::HasSurfaces() const
{
  vtkVolumeHapticsFilter* const filter = this->Scene.Device->GetVolumeHaptics();
  return filter && filter->GetMethod() != vtkVolumeHapticsFilter::FORCE_FIELD &&
    filter->GetMethod() != vtkVolumeHapticsFilter::PRIMITIVES;
}

Vector3 TouchMode::ProjectOnSurface(vtkRenderer* renderer, const Vector3& target) const
{
  /// Steepest slope on which the tip follows a touched surface; a steeper one counts as an edge.
  constexpr double steepest = 2.0;
  /// Largest height (voxels) from which the hand returns to the surface.
  constexpr double highest = 10.0;
  vtkVolumeHapticsFilter* const filter = this->Scene.Device->GetVolumeHaptics();
  Vector3 before;
  Vector3 after;
  const bool isOver = FindFirstContact(renderer, this->Lead, filter, before);
  if (!FindFirstContact(renderer, target, filter, after))
  {
    return target;
  }
  const double depth = Dot(this->Lead - before, LineOfSight(renderer, this->Lead));
  const Vector3 sight = LineOfSight(renderer, target);
  const double voxel = SmallestSpacing(filter->GetTouchedImage());
  if (this->Scene.Device->GetState()->GetContact() == 0)
  {
    const double reach = ComputeToolReach(filter->GetTool());
    const bool isNear = isOver && depth > -highest * voxel - reach;
    return after + (isNear ? depth : -reach) * sight;
  }
  const double change = Dot(after - target, sight) + depth;
  const bool isEdge = std::abs(change) > steepest * Norm(target - this->Lead) + voxel;
  return isOver && !isEdge ? target + change * sight : target;
}

} // namespace VolumeHaptics
