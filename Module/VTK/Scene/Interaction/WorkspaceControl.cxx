// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Interaction/WorkspaceControl.h"

#include "vtkCamera.h"
#include "vtkInteractorStyleHaptic.h"
#include "vtkMath.h"
#include "vtkRenderer.h"
#include "vtkTransform.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <utility>

namespace VolumeHaptics
{

Matrix3 CameraAxes(vtkCamera* camera)
{
  const double* const n = camera->GetViewPlaneNormal();
  const double* const u = camera->GetViewUp();
  const Vector3 back{ n[0], n[1], n[2] };
  // Compute an orthogonal view-up vector, because a camera accepts any vector that is not parallel
  // to its line of sight.
  const Vector3 right = Cross({ u[0], u[1], u[2] }, back);
  const Vector3 unit = (1.0 / Norm(right)) * right;
  Matrix3 axes;
  axes.Row[0] = unit;
  axes.Row[1] = Cross(back, unit);
  axes.Row[2] = back;
  return axes;
}

bool TurnView(vtkRenderer* renderer, const Vector3& rate, double seconds, bool resetsClippingRange)
{
  constexpr double longest = 0.1;
  const double angle = Norm(rate) * std::clamp(seconds, 0.0, longest);
  if (angle == 0.0)
  {
    return false;
  }
  vtkCamera* const camera = renderer->GetActiveCamera();
  const double* const focus = camera->GetFocalPoint();
  const Vector3 axis = Transpose(CameraAxes(camera)) * rate;
  vtkNew<vtkTransform> turn;
  turn->Translate(focus);
  turn->RotateWXYZ(-vtkMath::DegreesFromRadians(angle), axis.X, axis.Y, axis.Z);
  turn->Translate(-focus[0], -focus[1], -focus[2]);
  camera->ApplyTransform(turn);
  camera->OrthogonalizeViewUp();
  if (resetsClippingRange)
  {
    renderer->ResetCameraClippingRange();
  }
  return true;
}

vtkMatrix4x4* HapticWorkspace::Place(vtkCamera* camera, double scale)
{
  const Matrix3 axes = CameraAxes(camera);
  const double* const focus = camera->GetFocalPoint();
  const Vector3 shift = Transpose(axes) * this->Offset;
  const double origin[3] = { focus[0] + shift.X, focus[1] + shift.Y, focus[2] + shift.Z };
  const Matrix3 columns = Transpose(axes);
  for (int row = 0; row < 3; ++row)
  {
    const Vector3& r = columns.Row[row];
    this->DeviceToWorld->SetElement(row, 0, scale * r.X);
    this->DeviceToWorld->SetElement(row, 1, scale * r.Y);
    this->DeviceToWorld->SetElement(row, 2, scale * r.Z);
    this->DeviceToWorld->SetElement(row, 3, origin[row]);
  }
  return this->DeviceToWorld;
}

void HapticWorkspace::Shift(vtkCamera* camera, const Vector3& from, const Vector3& to)
{
  this->Offset += CameraAxes(camera) * (to - from);
}

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

bool WorkspaceControl::Update(vtkRenderer* renderer)
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
  vtkRenderer* const renderer = this->Scene.ChooseRenderer();
  if (on == this->IsOn || !this->Scene.IsReal() || !renderer)
  {
    return;
  }
  // Keep a reference to the device, because observers of the following events may remove it.
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
