// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Hand/SceneMarker.h"

#include "Core/Math/Vector3.h"

#include "vtkArrowSource.h"
#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkParametricFunctionSource.h"
#include "vtkParametricTorus.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRegularPolygonSource.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

namespace VolumeHaptics
{
namespace
{

///@{
/** Distances from the point along z, and radii, of a stylus with length 1. */
constexpr double ConeEnd = 0.16;
constexpr double HandleRadius = 0.032;
constexpr double HandleEnd = 1.0 - HandleRadius; ///< closed by a dome
constexpr double ButtonMiddle = 0.28;
constexpr double ButtonLength = 0.13;
constexpr double ButtonWidth = 0.034;
constexpr double ButtonHeight = 0.016; ///< height above and below the handle's surface
///@}

constexpr unsigned char Metal[3] = { 214, 218, 224 };
constexpr unsigned char Handle[3] = { 96, 116, 150 };
constexpr unsigned char Button[3] = { 240, 242, 245 };

constexpr double Turn = 6.283185307179586; ///< rad
constexpr int Around = 48;

class Surface
{
public:
  Surface()
  {
    this->Normals->SetNumberOfComponents(3);
    this->Colors->SetNumberOfComponents(3);
  }

  /**
   * Adds a grid over u and v in [0, 1]. `place` computes the position for u and v, and a normal of
   * any length. The surface faces outwards if u, v and the normal are right-handed.
   */
  template <typename Place>
  void Add(int alongU, int alongV, const unsigned char color[3], Place&& place)
  {
    const vtkIdType first = this->Points->GetNumberOfPoints();
    for (int i = 0; i <= alongU; ++i)
    {
      for (int j = 0; j <= alongV; ++j)
      {
        Vector3 x;
        Vector3 n;
        place(static_cast<double>(i) / alongU, static_cast<double>(j) / alongV, x, n);
        n = (1.0 / Norm(n)) * n;
        this->Points->InsertNextPoint(x.X, x.Y, x.Z);
        this->Normals->InsertNextTuple3(n.X, n.Y, n.Z);
        this->Colors->InsertNextTypedTuple(color);
      }
    }
    const auto at = [&](int i, int j) { return first + i * (alongV + 1) + j; };
    for (int i = 0; i < alongU; ++i)
    {
      for (int j = 0; j < alongV; ++j)
      {
        const vtkIdType cell[4] = { at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) };
        this->Cells->InsertNextCell(4, cell);
      }
    }
  }

  vtkSmartPointer<vtkPolyData> Finish()
  {
    auto shape = vtkSmartPointer<vtkPolyData>::New();
    shape->SetPoints(this->Points);
    shape->SetPolys(this->Cells);
    shape->GetPointData()->SetNormals(this->Normals);
    shape->GetPointData()->SetScalars(this->Colors);
    return shape;
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Cells;
  vtkNew<vtkFloatArray> Normals;
  vtkNew<vtkUnsignedCharArray> Colors;
};

/**
 * Makes the surface of a stylus: a metal point, a handle and a button. The mesh has length 1, with
 * its point at the origin, its handle along +z and its button on the side of +y (DeviceBackend.h).
 * It has normals, and colours as point scalars.
 */
vtkSmartPointer<vtkPolyData> MakeStylusShape()
{
  Surface surface;
  const auto direction = [](double u) {
    return Vector3{ std::cos(Turn * u), std::sin(Turn * u), 0.0 };
  };
  const Vector3 axis{ 0.0, 0.0, 1.0 };
  surface.Add(Around, 1, Metal,
    [&](double u, double v, Vector3& x, Vector3& n)
    {
      x = v * (ConeEnd * axis + HandleRadius * direction(u));
      n = ConeEnd * direction(u) - HandleRadius * axis;
    });
  surface.Add(Around, 1, Handle,
    [&](double u, double v, Vector3& x, Vector3& n)
    {
      x = (ConeEnd + v * (HandleEnd - ConeEnd)) * axis + HandleRadius * direction(u);
      n = direction(u);
    });
  surface.Add(Around, Around / 4, Handle,
    [&](double u, double v, Vector3& x, Vector3& n)
    {
      n = std::cos(0.25 * Turn * v) * direction(u) + std::sin(0.25 * Turn * v) * axis;
      x = HandleEnd * axis + HandleRadius * n;
    });
  // The button is half an ellipsoid that protrudes from the handle.
  surface.Add(Around, Around / 4, Button,
    [&](double u, double v, Vector3& x, Vector3& n)
    {
      const double level = std::cos(0.25 * Turn * v);
      const double side = level * std::sin(Turn * u);
      const double along = level * std::cos(Turn * u);
      const double up = std::sin(0.25 * Turn * v);
      x = { 0.5 * ButtonWidth * side, HandleRadius - ButtonHeight + 2.0 * ButtonHeight * up,
        ButtonMiddle + 0.5 * ButtonLength * along };
      n = { side / ButtonWidth, 0.25 * up / ButtonHeight, along / ButtonLength };
    });
  return surface.Finish();
}

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
    this->Mapper->SetInputData(MakeStylusShape()); // along z, with its own colours
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
  // Mark the shape as static, so that frames need not update its pipeline.
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
  // The overlay pass, in which vtkHapticRepresentation draws the ghost, does not sort translucent
  // objects.
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
