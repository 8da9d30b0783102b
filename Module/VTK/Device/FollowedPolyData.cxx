// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/FollowedPolyData.h"

#include "Core/Model/HapticModel.h"
#include "Core/Solvers/Primitives/FollowedShapes.h"
#include "VTK/Device/FollowedLine.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cmath>
#include <vector>

namespace VolumeHaptics
{
namespace
{

constexpr int FrontCorners = 48;
/** Radius of a front, as a fraction of the reach along lines. */
constexpr double FrontFraction = 0.25;
/** Length of a tensor, as a fraction of the reach along lines. */
constexpr double TensorFraction = 0.125;

class ShapeWriter
{
public:
  explicit ShapeWriter(const HapticModel& model)
    : Model(model)
  {
    this->Points->SetDataTypeToDouble();
    this->Normals->SetName("Normals");
    this->Normals->SetNumberOfComponents(3);
    this->Modes->SetName("Mode");
    this->Tensors->SetName("Tensors");
    this->Tensors->SetNumberOfComponents(9);
  }

  /** Adds a tensor, scaled so that its first eigenvalue becomes a length (m). */
  void AddTensor(const FollowedShape& shape, double length)
  {
    this->Places->InsertNextCell(1);
    this->Places->InsertCellPoint(this->AddPoint(shape.Centre, {}));
    const double world = length * std::cbrt(Determinant(this->Model.DeviceToWorld.Linear));
    const Matrix3 tensor = world * shape.Tensor;
    const double nine[9] = { tensor.Row[0].X, tensor.Row[0].Y, tensor.Row[0].Z, tensor.Row[1].X,
      tensor.Row[1].Y, tensor.Row[1].Z, tensor.Row[2].X, tensor.Row[2].Y, tensor.Row[2].Z };
    this->Tensors->SetTuple(this->Tensors->GetNumberOfTuples() - 1, nine);
    this->Modes->InsertNextValue(shape.Mode);
  }

  void AddLine(int mode, const std::vector<Vector3>& line)
  {
    this->Lines->InsertNextCell(static_cast<vtkIdType>(line.size()));
    for (const Vector3& place : line)
    {
      this->Lines->InsertCellPoint(this->AddPoint(place, {}));
    }
    this->Modes->InsertNextValue(mode);
  }

  void AddFront(const FollowedShape& shape, double radius)
  {
    const Vector3& n = shape.Direction;
    const Vector3 a = UnitAcross(n);
    const Vector3 b = Cross(n, a);
    constexpr double turn = 6.283185307179586 / FrontCorners;
    this->Fronts->InsertNextCell(FrontCorners);
    for (int i = 0; i < FrontCorners; ++i)
    {
      const Vector3 corner = std::cos(turn * i) * a + std::sin(turn * i) * b;
      this->Fronts->InsertCellPoint(this->AddPoint(shape.Centre + radius * corner, n));
    }
    this->Modes->InsertNextValue(shape.Mode);
  }

  void WriteTo(vtkPolyData* shapes)
  {
    shapes->Initialize();
    shapes->SetPoints(this->Points);
    shapes->SetVerts(this->Places);
    shapes->SetLines(this->Lines);
    shapes->SetPolys(this->Fronts);
    shapes->GetPointData()->SetNormals(this->Normals);
    if (this->Places->GetNumberOfCells() > 0)
    {
      shapes->GetPointData()->SetTensors(this->Tensors);
    }
    shapes->GetCellData()->AddArray(this->Modes);
  }

private:
  vtkIdType AddPoint(const Vector3& place, const Vector3& normal)
  {
    const Vector3 world = this->Model.DeviceToWorld(place);
    const Vector3 turned = this->Model.DeviceToWorldRotation * normal;
    constexpr double none[9] = {};
    this->Normals->InsertNextTuple3(turned.X, turned.Y, turned.Z);
    this->Tensors->InsertNextTuple(none);
    return this->Points->InsertNextPoint(world.X, world.Y, world.Z);
  }

  const HapticModel& Model;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkDoubleArray> Normals;
  vtkNew<vtkIntArray> Modes;
  vtkNew<vtkDoubleArray> Tensors;
  vtkNew<vtkCellArray> Places; ///< vertices of the tensors
  vtkNew<vtkCellArray> Lines;
  vtkNew<vtkCellArray> Fronts;
};

} // namespace

void WriteFollowed(
  const HapticModel& model, const Vector3& proxy, double reach, vtkPolyData* shapes)
{
  FollowedShapes modes(model);
  const std::vector<FollowedShape> found = modes.Collect(proxy);
  ShapeWriter writer(model);
  // Cells are numbered vertices first, then lines, then polygons; the array has the same order.
  const double voxel = 1.0 / model.MostVoxelsPerMeter;
  for (const FollowedShape& shape : found)
  {
    if (shape.Form == FollowedForm::Tensor)
    {
      writer.AddTensor(shape, TensorFraction * reach * voxel);
    }
  }
  for (const FollowedShape& shape : found)
  {
    if (shape.Form == FollowedForm::Line)
    {
      const std::vector<Vector3> line = TraceFollowedLine(modes, shape, voxel, reach);
      if (line.size() > 1)
      {
        writer.AddLine(shape.Mode, line);
      }
    }
  }
  for (const FollowedShape& shape : found)
  {
    if (shape.Form == FollowedForm::Front)
    {
      writer.AddFront(shape, FrontFraction * reach * voxel);
    }
  }
  writer.WriteTo(shapes);
}

} // namespace VolumeHaptics
