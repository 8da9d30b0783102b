// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Interaction/ToolTurn.h"

#include "VTK/Base/HapticTuples.h"
#include "VTK/Scene/Hand/HeldTool.h"

#include "vtkCamera.h"
#include "vtkInteractorStyleHaptic.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkTimerLog.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

constexpr double RadiansPerPixel = 0.01;
constexpr double RadiansPerStep = 0.1; ///< for a step of the wheel
constexpr double FineShare = 0.2;      ///< with Shift
constexpr double SameMotion = 0.5;     ///< s, the longest time between two events of one motion

} // namespace

bool ToolTurn::HasTool() const
{
  vtkHapticDevice* const device = this->Scene.Device;
  return device && device->IsRunning() && !device->IsTipOrientationMeasured() &&
    IsTurnable(FindHeldTool(device)) && this->Scene.FindRenderer();
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
  // The tool follows slower than the mouse, and its state is late: continue from the ordered
  // orientation. Between two motions, the program may have turned the tool.
  const double time = vtkTimerLog::GetUniversalTime();
  const bool isKnown = time - this->Turned < SameMotion && placement == this->Placement;
  this->Placement = placement;
  this->Turned = time;
  if (isKnown)
  {
    return this->Wish;
  }
  const double* const held =
    device->HasTipOrientation() ? device->GetTipOrientation() : device->GetToolOrientation();
  const Quaternion q{ held[0], held[1], held[2], held[3] };
  return IsIdentical(q, NoOrientation) ? Quaternion{} : q;
}

void ToolTurn::TurnBy(const Vector3& angles)
{
  vtkCamera* const camera = this->Scene.FindRenderer()->GetActiveCamera();
  const bool isFine = this->Scene.Style->GetInteractor()->GetShiftKey() != 0;
  const Vector3 back = -FromArray(camera->GetDirectionOfProjection());
  const Vector3 across = Cross(FromArray(camera->GetViewUp()), back);
  const Vector3 right = (1.0 / Norm(across)) * across;
  const Vector3 axis = angles.X * right + angles.Y * Cross(back, right) + angles.Z * back;
  const Vector3 half = (isFine ? 0.5 * FineShare : 0.5) * axis;
  const Quaternion turned = Quaternion{ 1.0, half.X, half.Y, half.Z } * this->FindStart();
  this->Wish = (1.0 / std::sqrt(SquaredNorm(turned))) * turned;
  this->Scene.Device->SetTipOrientation(this->Wish.W, this->Wish.X, this->Wish.Y, this->Wish.Z);
}

} // namespace VolumeHaptics
