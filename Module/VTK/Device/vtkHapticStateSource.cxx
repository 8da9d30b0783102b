// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticStateSource.h"

#include "VTK/Base/vtkVolumeHapticsCompat.h"
#include "VTK/Device/HapticDeviceSettings.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkHapticDevice.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include VOLUME_HAPTICS_VECTOR_HEADER

#include <algorithm>

vtkStandardNewMacro(vtkHapticStateSource);

//------------------------------------------------------------------------------
vtkHapticStateSource::vtkHapticStateSource()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkHapticStateSource::~vtkHapticStateSource() = default;

//------------------------------------------------------------------------------
void vtkHapticStateSource::SetDevice(vtkHapticDevice* device)
{
  if (this->Device != device)
  {
    this->Device = device;
    this->SeenTime = -1.0;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticDevice* vtkHapticStateSource::GetDevice()
{
  return this->Device;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkHapticStateSource::GetMTime()
{
  if (this->Device && this->Device->GetState()->GetTime() != this->SeenTime)
  {
    this->SeenTime = this->Device->GetState()->GetTime();
    this->StateTime.Modified();
  }
  return std::max(this->Superclass::GetMTime(), this->StateTime.GetMTime());
}

//------------------------------------------------------------------------------
bool vtkHapticStateSource::ReadState(ShownState& state)
{
  vtkHapticState* const latest = this->Device ? this->Device->GetState() : nullptr;
  if (!latest || latest->GetTime() == 0.0)
  {
    return false;
  }
  state.Tip = vtkVector3d(latest->GetTipPosition());
  state.Proxy = vtkVector3d(latest->GetProxyPosition());
  state.SurfacePosition = vtkVector3d(latest->GetSurfacePosition());
  state.MediumPosition = vtkVector3d(latest->GetMediumPosition());
  state.Force = vtkVector3d(latest->GetForce());
  state.ComputedForce = vtkVector3d(latest->GetComputedForce());
  state.Normal = vtkVector3d(latest->GetNormal());
  state.NormalForce = latest->GetNormalForce();
  state.FrictionForce = latest->GetFrictionForce();
  state.Contact = latest->GetContact();
  state.SurfaceValue = latest->GetSurfaceValue();
  if (latest->HasTipOrientation())
  {
    std::copy_n(latest->GetTipOrientation(), 4, state.Orientation);
  }
  return true;
}

//------------------------------------------------------------------------------
int vtkHapticStateSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  ShownState state;
  if (!this->ReadState(state))
  {
    return 1;
  }
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
  const vtkVector3d& force = this->ShowCommandedForce ? state.Force : computed;
  // Cells are numbered vertices first; the arrays have the same order.
  addVertex(TIP, tip.GetData());
  addVertex(PROXY, proxy.GetData());
  addVertex(SURFACE_POSITION, state.SurfacePosition.GetData());
  addVertex(MEDIUM_POSITION, state.MediumPosition.GetData());
  const double unit = 1.0 / this->ForceScale;
  addLine(SPRING, tip, proxy, 0.0);
  addLine(FORCE, tip, tip + unit * force, force.Norm());
  const double push = state.NormalForce;
  addLine(NORMAL_FORCE, proxy, proxy - (unit * push) * normal, push);
  const vtkVector3d tangent = computed - computed.Dot(normal) * normal;
  const double length = tangent.Norm();
  const double grip = state.FrictionForce;
  addLine(
    FRICTION_FORCE, proxy, proxy + (length > 0.0 ? unit * grip / length : 0.0) * tangent, grip);

  vtkPolyData* const output = vtkPolyData::GetData(outputs);
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
  return 1;
}

//------------------------------------------------------------------------------
void vtkHapticStateSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Device: " << this->Device.GetPointer() << "\n";
  VolumeHaptics::PrintSettings(os, indent, this, VolumeHaptics::StateSourceSettings);
}
