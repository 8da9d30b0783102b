// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Hand/SceneMarker.h"

#include "VTK/Scene/Hand/StylusShape.h"

#include "vtkArrowSource.h"
#include "vtkBoundingBox.h"
#include "vtkParametricFunctionSource.h"
#include "vtkParametricTorus.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRegularPolygonSource.h"
#include "vtkSphereSource.h"

#include <cmath>

namespace VolumeHaptics
{
namespace
{

constexpr int Resolution = 24;

} // namespace

SceneMarker::SceneMarker(Shape shape, double red, double green, double blue)
{
  // All shapes have length and radius 1, along z or around the origin.
  if (shape == Sphere)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(1.0);
    sphere->SetThetaResolution(Resolution);
    sphere->SetPhiResolution(Resolution);
    this->Mapper->SetInputConnection(sphere->GetOutputPort());
  }
  else if (shape == Disc)
  {
    vtkNew<vtkRegularPolygonSource> disc; // around z
    disc->SetRadius(1.0);
    disc->SetNumberOfSides(2 * Resolution);
    disc->GeneratePolylineOff();
    this->Mapper->SetInputConnection(disc->GetOutputPort());
  }
  else if (shape == Ring)
  {
    vtkNew<vtkParametricTorus> torus; // around z
    torus->SetRingRadius(1.0);
    torus->SetCrossSectionRadius(0.06);
    vtkNew<vtkParametricFunctionSource> ring;
    ring->SetParametricFunction(torus);
    ring->SetUResolution(2 * Resolution);
    ring->SetVResolution(Resolution / 2);
    ring->GenerateTextureCoordinatesOff();
    this->Mapper->SetInputConnection(ring->GetOutputPort());
    this->Mapper->ScalarVisibilityOff();
  }
  else if (shape == Stylus)
  {
    this->Mapper->SetInputData(MakeStylusShape()); // along z, with colours of its own
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
  // Keep the shape fixed, so that frames need not update its pipeline.
  this->Mapper->Update();
  this->Mapper->StaticOn();
  this->Finish(red, green, blue);
}

SceneMarker::SceneMarker(vtkAlgorithmOutput* shape, double red, double green, double blue)
{
  this->Mapper->SetInputConnection(shape);
  this->Mapper->ScalarVisibilityOff();
  this->Finish(red, green, blue);
}

void SceneMarker::Finish(double red, double green, double blue)
{
  this->Solid->SetMapper(this->Mapper);
  this->Ghost->SetMapper(this->Mapper);
  this->Solid->SetUserTransform(this->Place);
  this->Ghost->SetUserTransform(this->Place);
  this->Solid->GetProperty()->SetAmbient(0.25);
  this->Solid->GetProperty()->SetDiffuse(0.75);
  this->Solid->GetProperty()->SetSpecular(0.3);
  this->Solid->GetProperty()->SetSpecularPower(30.0);
  this->Ghost->GetProperty()->LightingOff();
  this->Ghost->GetProperty()->SetOpacity(HiddenOpacity);
  // vtkHapticRepresentation draws it in the overlay pass, which does not sort.
  this->Ghost->ForceOpaqueOn();
  const double color[3] = { red, green, blue };
  this->SetColor(color);
}

void SceneMarker::SetColor(const double color[3])
{
  this->Solid->GetProperty()->SetColor(color[0], color[1], color[2]);
  this->Ghost->GetProperty()->SetColor(color[0], color[1], color[2]);
}

void SceneMarker::PlaceSphere(const Vector3& centre, double radius)
{
  this->Place->Identity();
  this->Place->Translate(centre.X, centre.Y, centre.Z);
  this->Place->Scale(radius, radius, radius);
}

void SceneMarker::PlaceAlong(const Vector3& from, const Vector3& to, double radius)
{
  const Vector3 line = to - from;
  const double length = Norm(line);
  if (!(length > radius))
  {
    this->Shown = false;
    return;
  }
  this->Aim(from, line);
  this->Place->Scale(radius, radius, length);
}

void SceneMarker::PlaceRing(const Vector3& centre, const Vector3& axis, double radius)
{
  this->Aim(centre, axis);
  this->Place->Scale(radius, radius, radius);
}

void SceneMarker::Aim(const Vector3& from, const Vector3& direction)
{
  constexpr double degrees = 57.29577951308232;
  this->Place->Identity();
  this->Place->Translate(from.X, from.Y, from.Z);
  this->Place->RotateZ(degrees * std::atan2(direction.Y, direction.X));
  this->Place->RotateY(degrees * std::acos(direction.Z / Norm(direction)));
}

void SceneMarker::PlaceTurned(const Vector3& point, const Quaternion& orientation, double length)
{
  const Matrix3 m = length * ToMatrix(orientation);
  const double rows[16] = { m.Row[0].X, m.Row[0].Y, m.Row[0].Z, point.X, m.Row[1].X, m.Row[1].Y,
    m.Row[1].Z, point.Y, m.Row[2].X, m.Row[2].Y, m.Row[2].Z, point.Z, 0.0, 0.0, 0.0, 1.0 };
  this->Place->SetMatrix(rows);
}

void SceneMarker::RenderOpaque(vtkViewport* viewport)
{
  if (this->Shown)
  {
    this->Solid->RenderOpaqueGeometry(viewport);
  }
}

void SceneMarker::RenderHidden(vtkViewport* viewport)
{
  if (this->Shown)
  {
    this->Ghost->RenderOpaqueGeometry(viewport);
  }
}

void SceneMarker::Release(vtkWindow* window)
{
  this->Solid->ReleaseGraphicsResources(window);
  this->Ghost->ReleaseGraphicsResources(window);
}

void SceneMarker::AddTo(vtkBoundingBox& box)
{
  if (this->Shown)
  {
    box.AddBounds(this->Solid->GetBounds());
  }
}

} // namespace VolumeHaptics
