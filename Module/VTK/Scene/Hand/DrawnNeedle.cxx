// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Hand/DrawnNeedle.h"

#include "VTK/Base/HapticTuples.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkHapticDevice.h"
#include "vtkHapticLabelTable.h"
#include "vtkPoints.h"
#include "vtkProperty.h"
#include "vtkVolumeHapticsFilter.h"

namespace VolumeHaptics
{
namespace
{

/** Lengths in radii of the proxy. */
constexpr double ShaftRadii = 0.3;
constexpr double HubRadii = 0.9;
/** Position of the hub's start, as a fraction of the length of the shaft outside the tissue. */
constexpr double HubFraction = 0.7;
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

} // namespace

DrawnNeedle::DrawnNeedle()
{
  this->Hub->SetInputData(this->HubLine);
  this->Hub->SetNumberOfSides(16);
  this->Hub->CappingOn();
  this->HubMapper->SetInputConnection(this->Hub->GetOutputPort());
  this->HubActor->SetMapper(this->HubMapper);
  this->HubActor->GetProperty()->SetColor(0.25, 0.55, 0.85);
}

void DrawnNeedle::Update(vtkHapticDevice* device, double radius, double length)
{
  const double time = device ? device->GetState()->GetTime() : -1.0;
  if (time != this->Time || length != this->Length)
  {
    this->Time = time;
    this->Length = length;
    this->Track->Initialize();
    if (device)
    {
      device->GetState()->GetNeedleTrack(this->Track);
    }
    this->Draw(device, length);
  }
  this->Lines.SetRadius(ShaftRadii * radius);
  this->Hub->SetRadius(HubRadii * radius);
}

void DrawnNeedle::Draw(vtkHapticDevice* device, double length)
{
  vtkPolyData* const drawn = this->Lines.GetLines();
  drawn->Initialize();
  this->HubLine->Initialize();
  const vtkIdType last = this->Track->GetNumberOfPoints() - 1;
  const Vector3 whole = last > 0
    ? FromArray(this->Track->GetPoint(last)) - FromArray(this->Track->GetPoint(0))
    : Vector3{};
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
  const auto colors = ColoredTubes::NewColors();
  for (vtkIdType i = 0; i < last; ++i)
  {
    AddLine(
      points, lines, FromArray(this->Track->GetPoint(i)), FromArray(this->Track->GetPoint(i + 1)));
    const auto label = static_cast<int>(labels->GetComponent(i, 0));
    AddColor(colors, table && table->HasColor(label) ? table->GetColor(label) : Steel);
  }
  const Vector3 entry = FromArray(this->Track->GetPoint(0));
  const Vector3 back = (-length / depth) * whole;
  AddLine(points, lines, entry, entry + back);
  AddColor(colors, Steel);
  drawn->SetPoints(points);
  drawn->SetLines(lines);
  drawn->GetCellData()->SetScalars(colors);
  vtkNew<vtkPoints> hubPoints;
  vtkNew<vtkCellArray> hubLines;
  AddLine(hubPoints, hubLines, entry + HubFraction * back, entry + back);
  this->HubLine->SetPoints(hubPoints);
  this->HubLine->SetLines(hubLines);
}

void DrawnNeedle::RenderOpaque(vtkViewport* viewport)
{
  this->Lines.RenderOpaque(viewport);
  if (this->IsShown())
  {
    this->HubActor->RenderOpaqueGeometry(viewport);
  }
}

void DrawnNeedle::Release(vtkWindow* window)
{
  this->Lines.Release(window);
  this->HubActor->ReleaseGraphicsResources(window);
}

} // namespace VolumeHaptics
