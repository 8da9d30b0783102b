// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Display/MeasuredShapes.h"

#include "Core/Math/Vector3.h"
#include "VTK/Base/HapticTuples.h"
#include "VTK/Scene/Hand/SceneMarker.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkHapticMeasurements.h"
#include "vtkIdList.h"
#include "vtkPoints.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

/** Radius of lines, relative to the radius of spheres. */
constexpr double LineRadius = 0.3;
/** Radius of an angle's arc, relative to its shorter leg. */
constexpr double ArcRadius = 0.3;
constexpr int ArcSteps = 32;

void Begin(vtkPolyData* data)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  data->Initialize();
  data->SetPoints(points);
  data->SetVerts(vtkNew<vtkCellArray>());
  data->SetLines(vtkNew<vtkCellArray>());
  data->SetPolys(vtkNew<vtkCellArray>());
}

vtkIdType AddPoint(vtkPolyData* data, const Vector3& p)
{
  return data->GetPoints()->InsertNextPoint(p.X, p.Y, p.Z);
}

} // namespace

MeasuredShapes::MeasuredShapes(double red, double green, double blue)
{
  this->Sphere->SetThetaResolution(20);
  this->Sphere->SetPhiResolution(14);
  this->Glyphs->SetInputData(this->Spheres.Data);
  this->Glyphs->SetSourceConnection(this->Sphere->GetOutputPort());
  this->Glyphs->ScalingOff();
  this->Glyphs->OrientOff();
  this->Tube->SetInputData(this->Tubes.Data);
  this->Tube->SetNumberOfSides(8);
  this->Tube->CappingOn();
  this->Spheres.Mapper->SetInputConnection(this->Glyphs->GetOutputPort());
  this->Tubes.Mapper->SetInputConnection(this->Tube->GetOutputPort());
  this->Patches.Mapper->SetInputData(this->Patches.Data);
  for (Part& part : this->Parts)
  {
    part.Mapper->ScalarVisibilityOff();
    part.Solid->SetMapper(part.Mapper);
    part.Solid->GetProperty()->SetColor(red, green, blue);
    part.Solid->GetProperty()->SetAmbient(0.35);
    part.Solid->GetProperty()->SetDiffuse(0.65);
    part.Ghost->SetMapper(part.Mapper);
    part.Ghost->GetProperty()->SetColor(red, green, blue);
    part.Ghost->GetProperty()->LightingOff();
    part.Ghost->GetProperty()->SetOpacity(HiddenOpacity);
    part.Ghost->ForceOpaqueOn(); // the overlay pass does not sort
    Begin(part.Data);
  }
}

MeasuredShapes::~MeasuredShapes() = default;

void MeasuredShapes::Clear(double radius)
{
  this->Radius = radius;
  this->Sphere->SetRadius(radius);
  this->Tube->SetRadius(LineRadius * radius);
  for (Part& part : this->Parts)
  {
    Begin(part.Data);
  }
}

void MeasuredShapes::Add(int kind, vtkPolyData* shape)
{
  const vtkIdType count = shape->GetNumberOfPoints();
  if (count == 0)
  {
    return;
  }
  if (kind == vtkHapticMeasurements::AREA)
  {
    this->AddPatch(shape);
    return;
  }
  const bool isPath = kind == vtkHapticMeasurements::PATH;
  for (vtkIdType i = 0; i < count; i += isPath ? std::max<vtkIdType>(count - 1, 1) : 1)
  {
    AddPoint(this->Spheres.Data, FromArray(shape->GetPoint(i)));
  }
  if (count > 1)
  {
    this->AddLine(shape);
  }
  if (kind == vtkHapticMeasurements::ANGLE && count == 3)
  {
    this->AddArc(shape);
  }
}

void MeasuredShapes::AddLine(vtkPolyData* shape)
{
  const vtkIdType last = shape->GetNumberOfPoints() - 1;
  vtkNew<vtkIdList> line;
  Vector3 before;
  for (vtkIdType i = 0; i <= last; ++i)
  {
    const Vector3 point = FromArray(shape->GetPoint(i));
    // A tube can't continue from a point to itself.
    const double least = i == last ? 0.0 : 0.5 * this->Radius;
    if (i == 0 || Norm(point - before) > least)
    {
      line->InsertNextId(AddPoint(this->Tubes.Data, point));
      before = point;
    }
  }
  if (line->GetNumberOfIds() > 1)
  {
    this->Tubes.Data->GetLines()->InsertNextCell(line);
  }
}

void MeasuredShapes::AddArc(vtkPolyData* angle)
{
  const Vector3 corner = FromArray(angle->GetPoint(1));
  const Vector3 legs[2] = { FromArray(angle->GetPoint(0)) - corner,
    FromArray(angle->GetPoint(2)) - corner };
  const double lengths[2] = { Norm(legs[0]), Norm(legs[1]) };
  const Vector3 across = Cross(Cross(legs[0], legs[1]), legs[0]); // towards the second leg
  if (!(Norm(across) > 0.0))
  {
    return; // flat, or without legs
  }
  const Vector3 x = (1.0 / lengths[0]) * legs[0];
  const Vector3 y = (1.0 / Norm(across)) * across;
  const double whole = std::atan2(Dot(legs[1], y), Dot(legs[1], x));
  const double radius = ArcRadius * std::min(lengths[0], lengths[1]);
  this->Tubes.Data->GetLines()->InsertNextCell(ArcSteps + 1);
  for (int i = 0; i <= ArcSteps; ++i)
  {
    const double turn = whole * i / ArcSteps;
    this->Tubes.Data->GetLines()->InsertCellPoint(AddPoint(
      this->Tubes.Data, corner + radius * std::cos(turn) * x + radius * std::sin(turn) * y));
  }
}

void MeasuredShapes::AddPatch(vtkPolyData* shape)
{
  const vtkIdType first = this->Patches.Data->GetNumberOfPoints();
  for (vtkIdType i = 0; i < shape->GetNumberOfPoints(); ++i)
  {
    AddPoint(this->Patches.Data, FromArray(shape->GetPoint(i)));
  }
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < shape->GetNumberOfPolys(); ++i)
  {
    shape->GetPolys()->GetCellAtId(i, corners);
    for (vtkIdType c = 0; c < corners->GetNumberOfIds(); ++c)
    {
      corners->SetId(c, first + corners->GetId(c));
    }
    this->Patches.Data->GetPolys()->InsertNextCell(corners);
  }
}

void MeasuredShapes::RenderOpaque(vtkViewport* viewport)
{
  for (Part& part : this->Parts)
  {
    if (part.Data->GetNumberOfPoints() > 0)
    {
      part.Solid->RenderOpaqueGeometry(viewport);
    }
  }
}

void MeasuredShapes::RenderHidden(vtkViewport* viewport)
{
  for (Part& part : this->Parts)
  {
    if (part.Data->GetNumberOfPoints() > 0)
    {
      part.Ghost->RenderOpaqueGeometry(viewport);
    }
  }
}

void MeasuredShapes::Release(vtkWindow* window)
{
  for (Part& part : this->Parts)
  {
    part.Solid->ReleaseGraphicsResources(window);
    part.Ghost->ReleaseGraphicsResources(window);
  }
}

void MeasuredShapes::AddTo(vtkBoundingBox& box)
{
  for (Part& part : this->Parts)
  {
    if (part.Data->GetNumberOfPoints() > 0)
    {
      box.AddBounds(part.Data->GetBounds());
    }
  }
}

} // namespace VolumeHaptics
