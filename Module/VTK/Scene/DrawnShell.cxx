// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/DrawnShell.h"

#include "Core/Math/Quaternion.h"
#include "VTK/Scene/SceneMarker.h"

#include "vtkBoundingBox.h"
#include "vtkHapticDevice.h"
#include "vtkHapticPointShell.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkVolumeHapticsFilter.h"

namespace VolumeHaptics
{
namespace
{

/** Degrees; edges of a tool that are sharper are drawn as edges. */
constexpr double FeatureAngle = 40.0;

vtkPolyData* FindMesh(vtkHapticDevice* device)
{
  vtkVolumeHapticsFilter* const filter = device ? device->GetVolumeHaptics() : nullptr;
  auto* const tool = vtkHapticPointShell::SafeDownCast(filter ? filter->GetTool() : nullptr);
  return tool ? tool->GetMesh() : nullptr;
}

} // namespace

DrawnShell::DrawnShell()
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
  // vtkHapticRepresentation draws it in the overlay pass, which does not sort.
  this->Ghost->ForceOpaqueOn();
}

void DrawnShell::Update(vtkHapticDevice* device)
{
  vtkPolyData* const mesh = FindMesh(device);
  const double* const wxyz = mesh ? device->GetToolOrientation() : nullptr;
  const Quaternion q = wxyz ? Quaternion{ wxyz[0], wxyz[1], wxyz[2], wxyz[3] } : NoOrientation;
  this->Shown = !IsIdentical(q, NoOrientation);
  if (!this->Shown)
  {
    return;
  }
  if (this->Normals->GetInput() != mesh)
  {
    this->Normals->SetInputData(mesh);
  }
  const Matrix3 rotation = ToMatrix(q);
  const double* const at = device->GetProxyPosition();
  for (int row = 0; row < 3; ++row)
  {
    const Vector3& r = rotation.Row[row];
    this->Pose->SetElement(row, 0, r.X);
    this->Pose->SetElement(row, 1, r.Y);
    this->Pose->SetElement(row, 2, r.Z);
    this->Pose->SetElement(row, 3, at[row]);
  }
}

void DrawnShell::RenderOpaque(vtkViewport* viewport)
{
  if (this->Shown)
  {
    this->Solid->RenderOpaqueGeometry(viewport);
  }
}

void DrawnShell::RenderHidden(vtkViewport* viewport)
{
  if (this->Shown)
  {
    this->Ghost->RenderOpaqueGeometry(viewport);
  }
}

void DrawnShell::Release(vtkWindow* window)
{
  this->Solid->ReleaseGraphicsResources(window);
  this->Ghost->ReleaseGraphicsResources(window);
}

void DrawnShell::AddTo(vtkBoundingBox& box)
{
  if (this->Shown)
  {
    box.AddBounds(this->Solid->GetBounds());
  }
}

} // namespace VolumeHaptics
