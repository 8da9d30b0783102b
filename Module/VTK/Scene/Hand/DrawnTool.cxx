// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Hand/DrawnTool.h"

#include "VTK/Base/HapticTuples.h"
#include "VTK/Scene/Hand/SceneMarker.h"
#include "VTK/Tools/ToolKind.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkHapticDevice.h"
#include "vtkHapticLabelTable.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkVolumeHapticsFilter.h"

#include <cmath>

namespace VolumeHaptics
{

vtkHapticTool* GetHeldTool(vtkHapticDevice* device)
{
  vtkVolumeHapticsFilter* const filter = device ? device->GetVolumeHaptics() : nullptr;
  return filter && device->GetUseTool() ? filter->GetTool() : nullptr;
}

bool IsTurnable(vtkHapticTool* tool)
{
  const ToolKind* const kind = FindToolKind(tool);
  return kind && kind->IsTurnable();
}

double ComputeToolReach(vtkHapticTool* tool)
{
  const ToolKind* const kind = FindToolKind(tool);
  return kind ? kind->ComputeReach(tool) : 0.0;
}

namespace
{

/** Smallest angle (degrees) between faces whose common edge is drawn sharp. */
constexpr double FeatureAngle = 40.0;
constexpr double Pi = 3.14159265358979323846;

/** Drawn turns per second of a spinning tool. Faster turns would not be visible. */
constexpr double SeenTurns = 1.7;

/**
 * Computes the rotation from the tool's axes to the world's axes; NoOrientation if the tool is not
 * felt.
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
  // The overlay pass, in which vtkHapticRepresentation draws the ghost, does not sort translucent
  // objects.
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
  // For a needle without a shape, the state may still have the orientation of the previous tool, so
  // require a mesh.
  this->Shown = this->Normals->GetNumberOfInputConnections(0) > 0;
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

//------------------------------------------------------------------------------
namespace
{

/** Lengths in radii of the proxy. */
constexpr double ShaftRadii = 0.3;
constexpr double HubRadii = 0.9;
/** Start of the hub, as a fraction of the shaft's length outside the tissue. */
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

void DrawnNeedle::Update(
  vtkHapticDevice* device, double radius, double length, const Vector3& handle)
{
  const double time = device ? device->GetState()->GetTime() : -1.0;
  if (time != this->Time || length != this->Length || Norm(handle - this->Handle) > 0.0)
  {
    this->Time = time;
    this->Length = length;
    this->Handle = handle;
    this->Track->Initialize();
    if (device)
    {
      device->GetState()->GetNeedleTrack(this->Track);
    }
    this->Draw(device, length, handle);
  }
  this->Lines.SetRadius(ShaftRadii * radius);
  this->Hub->SetRadius(HubRadii * radius);
}

void DrawnNeedle::Draw(vtkHapticDevice* device, double length, const Vector3& handle)
{
  vtkPolyData* const drawn = this->Lines.GetLines();
  drawn->Initialize();
  this->HubLine->Initialize();
  const vtkIdType last = this->Track->GetNumberOfPoints() - 1;
  const Vector3 whole = last > 0
    ? FromArray(this->Track->GetPoint(last)) - FromArray(this->Track->GetPoint(0))
    : Vector3{};
  const double depth = Norm(whole);
  const bool isInAir = !(depth > 0.0);
  const ToolKind* const kind = FindToolKind(GetHeldTool(device));
  if (isInAir && !(Norm(handle) > 0.0 && kind && kind->HasShaft()))
  {
    return;
  }
  vtkVolumeHapticsFilter* const filter = device->GetVolumeHaptics();
  vtkHapticLabelTable* const table = filter ? filter->GetLabelTable() : nullptr;
  vtkDataArray* const labels = this->Track->GetCellData()->GetArray("Label");
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  const auto colors = ColoredTubes::NewColors();
  for (vtkIdType i = 0; i < last && !isInAir; ++i)
  {
    AddLine(
      points, lines, FromArray(this->Track->GetPoint(i)), FromArray(this->Track->GetPoint(i + 1)));
    const auto label = static_cast<int>(labels->GetComponent(i, 0));
    AddColor(colors, table && table->HasColor(label) ? table->GetColor(label) : Steel);
  }
  const Vector3 entry =
    FromArray(isInAir ? device->GetState()->GetProxyPosition() : this->Track->GetPoint(0));
  const Vector3 back = isInAir ? length * handle : (-length / depth) * whole;
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
