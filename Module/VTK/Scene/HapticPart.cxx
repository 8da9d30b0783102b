// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/HapticPart.h"

#include "vtkArrowSource.h"
#include "vtkBoundingBox.h"
#include "vtkCylinderSource.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

#include <cmath>

namespace VolumeHaptics
{
namespace
{

/** How strongly what is hidden shines through. */
constexpr double GhostOpacity = 0.35;
constexpr int Resolution = 24;

} // namespace

HapticPart::HapticPart(Shape shape, double red, double green, double blue)
{
  // All shapes have the length and the radius of one along z or around the origin.
  if (shape == Sphere)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(1.0);
    sphere->SetThetaResolution(Resolution);
    sphere->SetPhiResolution(Resolution);
    this->Mapper->SetInputConnection(sphere->GetOutputPort());
  }
  else if (shape == Rod)
  {
    vtkNew<vtkCylinderSource> rod; // along y, about the origin
    rod->SetRadius(1.0);
    rod->SetHeight(1.0);
    rod->SetCenter(0.0, 0.5, 0.0);
    rod->SetResolution(Resolution);
    this->Mapper->SetInputConnection(rod->GetOutputPort());
    this->Solid->RotateX(90.0);
    this->Ghost->RotateX(90.0);
  }
  else
  {
    vtkNew<vtkArrowSource> arrow; // along x
    arrow->SetTipLength(0.3);
    arrow->SetTipRadius(2.4);
    arrow->SetShaftRadius(1.0);
    arrow->SetTipResolution(Resolution);
    arrow->SetShaftResolution(Resolution);
    this->Mapper->SetInputConnection(arrow->GetOutputPort());
    this->Solid->RotateY(-90.0);
    this->Ghost->RotateY(-90.0);
  }
  this->Solid->SetMapper(this->Mapper);
  this->Ghost->SetMapper(this->Mapper);
  this->Solid->SetUserTransform(this->Place);
  this->Ghost->SetUserTransform(this->Place);
  this->Solid->GetProperty()->SetAmbient(0.25);
  this->Solid->GetProperty()->SetDiffuse(0.75);
  this->Solid->GetProperty()->SetSpecular(0.3);
  this->Solid->GetProperty()->SetSpecularPower(30.0);
  this->Ghost->GetProperty()->LightingOff();
  this->Ghost->GetProperty()->SetOpacity(GhostOpacity);
  // In the overlay nothing is sorted any more: the part decides by itself when it is drawn.
  this->Ghost->ForceOpaqueOn();
  const double color[3] = { red, green, blue };
  this->SetColor(color);
}

void HapticPart::SetColor(const double color[3])
{
  this->Solid->GetProperty()->SetColor(color[0], color[1], color[2]);
  this->Ghost->GetProperty()->SetColor(color[0], color[1], color[2]);
}

void HapticPart::PlaceSphere(const Vector3& centre, double radius)
{
  this->Place->Identity();
  this->Place->Translate(centre.X, centre.Y, centre.Z);
  this->Place->Scale(radius, radius, radius);
}

void HapticPart::PlaceAlong(const Vector3& from, const Vector3& to, double radius)
{
  const Vector3 way = to - from;
  const double length = Norm(way);
  if (!(length > radius))
  {
    this->Shown = false;
    return;
  }
  constexpr double degrees = 57.29577951308232;
  const double turn = degrees * std::atan2(way.Y, way.X);
  const double tilt = degrees * std::acos(way.Z / length);
  this->Place->Identity();
  this->Place->Translate(from.X, from.Y, from.Z);
  this->Place->RotateZ(turn);
  this->Place->RotateY(tilt);
  this->Place->Scale(radius, radius, length);
}

void HapticPart::RenderOpaque(vtkViewport* viewport)
{
  if (this->Shown)
  {
    this->Solid->RenderOpaqueGeometry(viewport);
  }
}

void HapticPart::RenderHidden(vtkViewport* viewport)
{
  if (this->Shown)
  {
    this->Ghost->RenderOpaqueGeometry(viewport);
  }
}

void HapticPart::Release(vtkWindow* window)
{
  this->Solid->ReleaseGraphicsResources(window);
  this->Ghost->ReleaseGraphicsResources(window);
}

void HapticPart::AddTo(vtkBoundingBox& box)
{
  if (this->Shown)
  {
    box.AddBounds(this->Solid->GetBounds());
  }
}

} // namespace VolumeHaptics
