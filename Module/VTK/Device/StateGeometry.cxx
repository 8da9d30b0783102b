// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/StateGeometry.h"

#include "VTK/Base/vtkVolumeHapticsCompat.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkHapticState.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include VOLUME_HAPTICS_VECTOR_HEADER

#include <utility>

namespace VolumeHaptics
{

void WriteStateGeometry(
  const ShownState& state, double forceScale, bool isCommanded, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIntArray> parts;
  parts->SetName("Part");
  vtkNew<vtkDoubleArray> newtons;
  newtons->SetName("Newtons");
  const auto describe = [&](int part, double force)
  {
    parts->InsertNextValue(part);
    newtons->InsertNextValue(force);
  };
  const auto addVertex = [&](int part, const double position[3])
  {
    vertices->InsertNextCell(1);
    vertices->InsertCellPoint(points->InsertNextPoint(position));
    describe(part, 0.0);
  };
  const auto addLine = [&](int part, const vtkVector3d& from, const vtkVector3d& to, double force)
  {
    lines->InsertNextCell(2);
    lines->InsertCellPoint(points->InsertNextPoint(from.GetData()));
    lines->InsertCellPoint(points->InsertNextPoint(to.GetData()));
    describe(part, force);
  };

  const vtkVector3d& tip = state.Tip;
  const vtkVector3d& proxy = state.Proxy;
  const vtkVector3d& computed = state.ComputedForce;
  const vtkVector3d& normal = state.Normal;
  const vtkVector3d& force = isCommanded ? state.Force : computed;
  // Cells are numbered vertices first; the arrays have the same order.
  addVertex(vtkHapticState::TIP, tip.GetData());
  addVertex(vtkHapticState::PROXY, proxy.GetData());
  addVertex(vtkHapticState::SURFACE_POSITION, state.SurfacePosition.GetData());
  addVertex(vtkHapticState::MEDIUM_POSITION, state.MediumPosition.GetData());
  const double unit = 1.0 / forceScale;
  addLine(vtkHapticState::SPRING, tip, proxy, 0.0);
  addLine(vtkHapticState::FORCE, tip, tip + unit * force, force.Norm());
  const double push = state.NormalForce;
  addLine(vtkHapticState::NORMAL_FORCE, proxy, proxy - (unit * push) * normal, push);
  const vtkVector3d tangent = computed - computed.Dot(normal) * normal;
  const double length = tangent.Norm();
  const double grip = state.FrictionForce;
  addLine(vtkHapticState::FRICTION_FORCE, proxy,
    proxy + (length > 0.0 ? unit * grip / length : 0.0) * tangent, grip);

  output->Initialize();
  output->SetPoints(points);
  output->SetVerts(vertices);
  output->SetLines(lines);
  output->GetCellData()->AddArray(parts);
  output->GetCellData()->AddArray(newtons);
  const std::pair<const char*, double> fields[] = { { "Contact", state.Contact },
    { "SurfaceValue", state.SurfaceValue } };
  for (const auto& [name, value] : fields)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->InsertNextValue(value);
    output->GetFieldData()->AddArray(array);
  }
  vtkNew<vtkDoubleArray> orientation;
  orientation->SetName("Orientation");
  orientation->SetNumberOfComponents(4);
  orientation->InsertNextTypedTuple(state.Orientation);
  output->GetFieldData()->AddArray(orientation);
}

} // namespace VolumeHaptics
