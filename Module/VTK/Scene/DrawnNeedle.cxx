// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/DrawnNeedle.h"

#include "Core/Math/Vector3.h"
#include "VTK/Scene/SceneMarker.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkHapticDevice.h"
#include "vtkHapticLabelTable.h"
#include "vtkPoints.h"
#include "vtkProperty.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolumeHapticsFilter.h"

namespace VolumeHaptics
{
namespace
{

/** In radii of the proxy. */
constexpr double ShaftRadii = 0.3;
constexpr double HubRadii = 0.9;
/** Of the shaft outside, in parts of its length: where the hub begins. */
constexpr double HubShare = 0.7;
const double Steel[3] = { 0.8, 0.82, 0.85 };

void AddLine(vtkPoints* points, vtkCellArray* lines, const Vector3& from, const Vector3& to)
{
  const vtkIdType ends[] = { points->InsertNextPoint(from.X, from.Y, from.Z),
    points->InsertNextPoint(to.X, to.Y, to.Z) };
  lines->InsertNextCell(2, ends);
}

void AddColor(vtkUnsignedCharArray* colors, const double* rgb)
{
  colors->InsertNextTuple3(255.0 * rgb[0], 255.0 * rgb[1], 255.0 * rgb[2]);
}

Vector3 PointOf(vtkPolyData* data, vtkIdType i)
{
  const double* const x = data->GetPoint(i);
  return { x[0], x[1], x[2] };
}

} // namespace

DrawnNeedle::DrawnNeedle()
{
  this->Tubes->SetInputData(this->Lines);
  this->Tubes->SetNumberOfSides(12);
  this->Tubes->CappingOn();
  this->Hub->SetInputData(this->HubLine);
  this->Hub->SetNumberOfSides(16);
  this->Hub->CappingOn();
  this->LineMapper->SetInputConnection(this->Tubes->GetOutputPort());
  this->LineMapper->SetScalarModeToUseCellData();
  this->LineMapper->SetColorModeToDirectScalars();
  this->HubMapper->SetInputConnection(this->Hub->GetOutputPort());
  this->Solid->SetMapper(this->LineMapper);
  this->Solid->GetProperty()->SetAmbient(0.3);
  this->Solid->GetProperty()->SetDiffuse(0.7);
  this->HubActor->SetMapper(this->HubMapper);
  this->HubActor->GetProperty()->SetColor(0.25, 0.55, 0.85);
  // vtkHapticRepresentation draws it in the overlay pass, which does not sort.
  this->Ghost->SetMapper(this->LineMapper);
  this->Ghost->GetProperty()->LightingOff();
  this->Ghost->GetProperty()->SetOpacity(HiddenOpacity);
  this->Ghost->ForceOpaqueOn();
}

DrawnNeedle::~DrawnNeedle() = default;

void DrawnNeedle::Update(vtkHapticDevice* device, double radius, double length)
{
  const double time = device ? device->GetTime() : -1.0;
  if (time != this->Time || length != this->Length)
  {
    this->Time = time;
    this->Length = length;
    this->Track->Initialize();
    if (device)
    {
      device->GetNeedleTrack(this->Track);
    }
    this->Draw(device, length);
  }
  this->Tubes->SetRadius(ShaftRadii * radius);
  this->Hub->SetRadius(HubRadii * radius);
}

void DrawnNeedle::Draw(vtkHapticDevice* device, double length)
{
  this->Lines->Initialize();
  this->HubLine->Initialize();
  const vtkIdType last = this->Track->GetNumberOfPoints() - 1;
  const Vector3 whole = last > 0 ? PointOf(this->Track, last) - PointOf(this->Track, 0) : Vector3{};
  const double depth = Norm(whole);
  if (!(depth > 0.0))
  {
    return;
  }
  vtkVolumeHapticsFilter* const filter = device->GetVolumeHaptics();
  vtkHapticLabelTable* const table = filter ? filter->GetLabelTable() : nullptr;
  vtkDataArray* const labels = this->Track->GetCellData()->GetArray("Label");
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Colors");
  colors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < last; ++i)
  {
    AddLine(points, lines, PointOf(this->Track, i), PointOf(this->Track, i + 1));
    const auto label = static_cast<int>(labels->GetComponent(i, 0));
    AddColor(colors, table && table->HasColor(label) ? table->GetColor(label) : Steel);
  }
  const Vector3 entry = PointOf(this->Track, 0);
  const Vector3 back = (-length / depth) * whole;
  AddLine(points, lines, entry, entry + back);
  AddColor(colors, Steel);
  this->Lines->SetPoints(points);
  this->Lines->SetLines(lines);
  this->Lines->GetCellData()->SetScalars(colors);
  vtkNew<vtkPoints> hubPoints;
  vtkNew<vtkCellArray> hubLines;
  AddLine(hubPoints, hubLines, entry + HubShare * back, entry + back);
  this->HubLine->SetPoints(hubPoints);
  this->HubLine->SetLines(hubLines);
}

void DrawnNeedle::RenderOpaque(vtkViewport* viewport)
{
  if (this->IsShown())
  {
    this->Solid->RenderOpaqueGeometry(viewport);
    this->HubActor->RenderOpaqueGeometry(viewport);
  }
}

void DrawnNeedle::RenderHidden(vtkViewport* viewport)
{
  if (this->IsShown())
  {
    this->Ghost->RenderOpaqueGeometry(viewport);
  }
}

void DrawnNeedle::Release(vtkWindow* window)
{
  this->Solid->ReleaseGraphicsResources(window);
  this->Ghost->ReleaseGraphicsResources(window);
  this->HubActor->ReleaseGraphicsResources(window);
}

void DrawnNeedle::AddTo(vtkBoundingBox& box)
{
  if (this->IsShown())
  {
    box.AddBounds(this->Lines->GetBounds());
  }
}

} // namespace VolumeHaptics
