// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Hand/FollowedScene.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkHapticDevice.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

constexpr double FrontOpacity = 0.4;
constexpr double TensorOpacity = 0.75;
/** Radius of lines, and smallest length of tensors, in radii of the proxy. */
constexpr double LineRadii = 0.22;
constexpr double TensorRadii = 10.0;

} // namespace

FollowedScene::FollowedScene(const Color* colors, std::size_t count)
  : Colors(colors)
  , ColorCount(count)
{
  this->DiscMapper->SetInputData(this->Discs);
  // Colour the points, because VTK 9.1 loses cell colours of polygons with many corners.
  this->DiscMapper->SetScalarModeToUsePointData();
  this->DiscMapper->SetColorModeToDirectScalars();
  // The overlay pass, in which vtkHapticRepresentation draws the fronts, does not sort translucent
  // objects.
  this->Fronts->ForceOpaqueOn();
  this->Fronts->SetMapper(this->DiscMapper);
  this->Fronts->GetProperty()->LightingOff();
  this->Fronts->GetProperty()->SetOpacity(FrontOpacity);
  vtkNew<vtkSphereSource> sphere; // of diameter 1
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(16);
  this->Ellipsoids->SetInputData(this->Tensors);
  this->Ellipsoids->SetSourceConnection(sphere->GetOutputPort());
  this->Ellipsoids->ColorGlyphsOff();
  // Orient the normals outwards: for left-handed eigenvectors, VTK turns glyphs inside out.
  this->Outward->SetInputConnection(this->Ellipsoids->GetOutputPort());
  this->Outward->AutoOrientNormalsOn();
  this->Outward->SplittingOff();
  this->EllipsoidMapper->SetInputConnection(this->Outward->GetOutputPort());
  this->EllipsoidMapper->ScalarVisibilityOff();
  this->EllipsoidActor->SetMapper(this->EllipsoidMapper);
  this->EllipsoidActor->ForceOpaqueOn();
  this->EllipsoidActor->GetProperty()->SetOpacity(TensorOpacity);
  this->EllipsoidActor->GetProperty()->BackfaceCullingOn();
  this->EllipsoidActor->GetProperty()->SetAmbient(0.5);
  this->EllipsoidActor->GetProperty()->SetDiffuse(0.6);
}

FollowedScene::~FollowedScene() = default;

void FollowedScene::Update(vtkHapticDevice* device, double reach, double radius)
{
  const double* const proxy = device ? device->GetState()->GetProxyPosition() : this->Proxy;
  const double time = device ? device->GetState()->GetTime() : -1.0;
  if (time != this->Time || reach != this->Reach || !std::equal(proxy, proxy + 3, this->Proxy))
  {
    this->Time = time;
    this->Reach = reach;
    std::copy_n(proxy, 3, this->Proxy);
    this->Shapes->Initialize();
    if (device)
    {
      device->GetState()->GetFollowed(this->Shapes, reach);
    }
    this->Draw();
  }
  this->Lines.SetRadius(LineRadii * radius);
  this->ScaleTensors(radius);
}

void FollowedScene::ScaleTensors(double radius)
{
  vtkDataArray* const tensors = this->Tensors->GetPointData()->GetTensors();
  double longest = 0.0;
  for (vtkIdType i = 0; tensors && i < tensors->GetNumberOfTuples(); ++i)
  {
    double nine[9];
    tensors->GetTuple(i, nine);
    // The norm is 1 to 1.7 times the largest eigenvalue.
    longest = std::max(longest, vtkMath::Norm(nine, 9));
  }
  this->Ellipsoids->SetScaleFactor(
    longest > 0.0 ? std::max(1.0, TensorRadii * radius / longest) : 1.0);
}

void FollowedScene::Draw()
{
  vtkDataArray* const modes = this->Shapes->GetCellData()->GetArray("Mode");
  const auto lineColors = ColoredTubes::NewColors();
  const auto discColors = ColoredTubes::NewColors(); // colours of points, for the discs
  discColors->SetNumberOfTuples(this->Shapes->GetNumberOfPoints());
  discColors->Fill(0.0);
  vtkNew<vtkCellArray> lines;
  const vtkIdType count = this->Shapes->GetNumberOfCells();
  const vtkIdType first = this->Shapes->GetNumberOfVerts();
  for (vtkIdType cell = first; modes && cell < count; ++cell)
  {
    const auto mode = static_cast<std::size_t>(modes->GetComponent(cell, 0)) % this->ColorCount;
    const bool isFront = cell >= first + this->Shapes->GetNumberOfLines();
    vtkNew<vtkIdList> points;
    this->Shapes->GetCellPoints(cell, points);
    if (isFront)
    {
      for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
      {
        discColors->SetTypedTuple(points->GetId(i), this->Colors[mode]);
      }
      points->InsertNextId(points->GetId(0));
    }
    lines->InsertNextCell(points);
    lineColors->InsertNextTypedTuple(this->Colors[mode]);
  }
  vtkPolyData* const drawn = this->Lines.GetLines();
  drawn->Initialize();
  drawn->SetPoints(this->Shapes->GetPoints());
  drawn->SetLines(lines);
  drawn->GetCellData()->SetScalars(lineColors);
  this->Discs->Initialize();
  this->Discs->SetPoints(this->Shapes->GetPoints());
  this->Discs->SetPolys(this->Shapes->GetPolys());
  this->Discs->GetPointData()->SetScalars(discColors);
  this->DrawTensors();
}

void FollowedScene::DrawTensors()
{
  vtkDataArray* const modes = this->Shapes->GetCellData()->GetArray("Mode");
  vtkDataArray* const all = this->Shapes->GetPointData()->GetTensors();
  vtkNew<vtkPoints> places;
  const auto tensors = all ? vtkSmartPointer<vtkDataArray>::Take(all->NewInstance()) : nullptr;
  this->Tensors->Initialize();
  for (vtkIdType cell = 0; modes && tensors && cell < this->Shapes->GetNumberOfVerts(); ++cell)
  {
    vtkNew<vtkIdList> points;
    this->Shapes->GetCellPoints(cell, points);
    places->InsertNextPoint(this->Shapes->GetPoint(points->GetId(0)));
    tensors->SetNumberOfComponents(all->GetNumberOfComponents());
    tensors->InsertNextTuple(all->GetTuple(points->GetId(0)));
    const auto mode = static_cast<std::size_t>(modes->GetComponent(cell, 0)) % this->ColorCount;
    const Color& color = this->Colors[mode];
    this->EllipsoidActor->GetProperty()->SetColor(
      color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
  }
  this->Tensors->SetPoints(places);
  this->Tensors->GetPointData()->SetTensors(tensors);
}

void FollowedScene::RenderFronts(vtkViewport* viewport)
{
  // Draw the ellipsoid first: a front through its centre would otherwise hide half of it.
  if (this->Tensors->GetNumberOfPoints() > 0)
  {
    this->EllipsoidActor->RenderOpaqueGeometry(viewport);
  }
  if (this->Shapes->GetNumberOfPolys() > 0)
  {
    this->Fronts->RenderOpaqueGeometry(viewport);
  }
}

void FollowedScene::Release(vtkWindow* window)
{
  this->Lines.Release(window);
  this->Fronts->ReleaseGraphicsResources(window);
  this->EllipsoidActor->ReleaseGraphicsResources(window);
}

void FollowedScene::AddTo(vtkBoundingBox& box)
{
  this->Lines.AddTo(box);
  if (this->Tensors->GetNumberOfPoints() > 0)
  {
    box.AddBounds(this->EllipsoidMapper->GetBounds());
  }
}

} // namespace VolumeHaptics
