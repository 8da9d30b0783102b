// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Hand/DrawnTool.h"

#include "VTK/Scene/Hand/HeldTool.h"
#include "VTK/Scene/Hand/SceneMarker.h"
#include "VTK/Tools/ToolKind.h"

#include "vtkBoundingBox.h"
#include "vtkHapticDevice.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

#include <cmath>

namespace VolumeHaptics
{
namespace
{

/** Edges with at least this angle (degrees) between faces are drawn sharp. */
constexpr double FeatureAngle = 40.0;
constexpr double Pi = 3.14159265358979323846;

/** Turns per second at which a spinning tool is drawn. The eye could not see faster turns. */
constexpr double SeenTurns = 1.7;

/**
 * Computes the rotation from the tool's axes to the world's; NoOrientation if the tool is not felt.
 */
Quaternion ComputeTurn(
  vtkHapticDevice* device, const ToolKind& kind, bool hasShape, const Quaternion& leaning)
{
  const double* const wxyz = device->GetState()->GetToolOrientation();
  const Quaternion felt{ wxyz[0], wxyz[1], wxyz[2], wxyz[3] };
  if (!kind.TurnsWithStylus() || (hasShape && IsIdentical(felt, NoOrientation)))
  {
    return felt;
  }
  const double* const wanted = device->GetState()->GetTipOrientation();
  const bool isLeaning =
    !device->GetState()->HasTipOrientation() && !IsIdentical(leaning, NoOrientation);
  const Quaternion held =
    isLeaning ? leaning : Quaternion{ wanted[0], wanted[1], wanted[2], wanted[3] };
  const double half =
    device->GetState()->IsSpinning() ? Pi * SeenTurns * device->GetState()->GetTime() : 0.0;
  return held * Quaternion{ std::cos(half), 0.0, 0.0, std::sin(half) };
}

} // namespace

DrawnTool::DrawnTool()
{
  this->Normals->SetFeatureAngle(FeatureAngle);
  this->Mapper->SetInputConnection(this->Normals->GetOutputPort());
  this->Mapper->ScalarVisibilityOff();
  for (vtkActor* const actor : { this->Solid.Get(), this->Ghost.Get() })
  {
    actor->SetMapper(this->Mapper);
    actor->SetUserMatrix(this->Pose);
    actor->GetProperty()->SetColor(0.75, 0.79, 0.84);
  }
  this->Solid->GetProperty()->SetAmbient(0.2);
  this->Solid->GetProperty()->SetDiffuse(0.7);
  this->Solid->GetProperty()->SetSpecular(0.4);
  this->Solid->GetProperty()->SetSpecularPower(30.0);
  this->Ghost->GetProperty()->LightingOff();
  this->Ghost->GetProperty()->SetOpacity(HiddenOpacity);
  // This is drawn in the overlay pass (by vtkHapticRepresentation), which does not sort.
  this->Ghost->ForceOpaqueOn();
}

void DrawnTool::Update(vtkHapticDevice* device, const Quaternion& leaning)
{
  vtkHapticTool* const tool = GetHeldTool(device);
  const ToolKind* const kind = FindToolKind(tool);
  const Quaternion q =
    kind ? ComputeTurn(device, *kind, kind->ComputeReach(tool) > 0.0, leaning) : NoOrientation;
  this->Shown = !IsIdentical(q, NoOrientation);
  if (!this->Shown)
  {
    return;
  }
  if (this->Tool != tool || this->ToolTime != tool->GetMTime())
  {
    this->Tool = tool;
    this->ToolTime = tool->GetMTime();
    this->Normals->SetInputData(kind->MakeShape(tool));
  }
  const Matrix3 rotation = ToMatrix(q);
  const double* const at = device->GetState()->GetProxyPosition();
  for (int row = 0; row < 3; ++row)
  {
    const Vector3& r = rotation.Row[row];
    this->Pose->SetElement(row, 0, r.X);
    this->Pose->SetElement(row, 1, r.Y);
    this->Pose->SetElement(row, 2, r.Z);
    this->Pose->SetElement(row, 3, at[row]);
  }
}

void DrawnTool::RenderOpaque(vtkViewport* viewport)
{
  if (this->Shown)
  {
    this->Solid->RenderOpaqueGeometry(viewport);
  }
}

void DrawnTool::RenderHidden(vtkViewport* viewport)
{
  if (this->Shown)
  {
    this->Ghost->RenderOpaqueGeometry(viewport);
  }
}

void DrawnTool::Release(vtkWindow* window)
{
  this->Solid->ReleaseGraphicsResources(window);
  this->Ghost->ReleaseGraphicsResources(window);
}

void DrawnTool::AddTo(vtkBoundingBox& box)
{
  if (this->Shown)
  {
    box.AddBounds(this->Solid->GetBounds());
  }
}

} // namespace VolumeHaptics
