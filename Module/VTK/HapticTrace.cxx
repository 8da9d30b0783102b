// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticTrace.h"

#include "HapticTipPath.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

namespace VolumeHaptics
{
namespace
{

void InsertVector(vtkDoubleArray* array, const Vector3& v)
{
  array->InsertNextTuple3(v.X, v.Y, v.Z);
}

} // namespace

HapticTrace::HapticTrace()
{
  this->Proxies->SetDataTypeToDouble();
  this->Time->SetName("Time");
  this->Tip->SetName("Tip");
  this->Force->SetName("Force");
  this->NormalForce->SetName("NormalForce");
  this->FrictionForce->SetName("FrictionForce");
  this->DragForce->SetName("DragForce");
  this->Normal->SetName("Normal");
  this->Value->SetName("Value");
  this->GradientMagnitude->SetName("GradientMagnitude");
  this->SurfaceValue->SetName("SurfaceValue");
  this->MediumValue->SetName("MediumValue");
  this->Stiffness->SetName("Stiffness");
  this->Friction->SetName("Friction");
  this->Viscosity->SetName("Viscosity");
  this->SurfaceStrength->SetName("SurfaceStrength");
  this->Contact->SetName("Contact");
  this->Unfinished->SetName("Unfinished");
  this->Renewed->SetName(RecordingNames::Renewed);
  this->Energy->SetName("Energy");
  for (vtkDoubleArray* vector : { this->Tip.Get(), this->Force.Get(), this->Normal.Get() })
  {
    vector->SetNumberOfComponents(3);
  }
}

HapticTrace::~HapticTrace() = default;

void HapticTrace::Reserve(vtkIdType ticks)
{
  this->Proxies->Allocate(ticks);
  for (vtkDoubleArray* array :
    { this->Time.Get(), this->Tip.Get(), this->Force.Get(), this->NormalForce.Get(),
      this->FrictionForce.Get(), this->DragForce.Get(), this->Normal.Get(), this->Value.Get(),
      this->GradientMagnitude.Get(), this->SurfaceValue.Get(), this->MediumValue.Get(),
      this->Stiffness.Get(), this->Friction.Get(), this->Viscosity.Get(),
      this->SurfaceStrength.Get(), this->Energy.Get() })
  {
    array->Allocate(ticks * array->GetNumberOfComponents());
  }
  this->Contact->Allocate(ticks);
  this->Unfinished->Allocate(ticks);
  this->Renewed->Allocate(ticks);
}

void HapticTrace::Append(const HapticModel& model, double time, const TickRecord& record)
{
  // Device axes are the world's, turned; lengths differ, forces and directions do not.
  const Affine3& toWorld = model.DeviceToWorld;
  const Vector3 proxy = toWorld(record.Proxy);
  this->Proxies->InsertNextPoint(proxy.X, proxy.Y, proxy.Z);
  this->Time->InsertNextValue(time);
  InsertVector(this->Tip, toWorld(record.Tip));
  InsertVector(this->Force, model.DeviceToWorldRotation * record.Force);
  this->NormalForce->InsertNextValue(record.NormalForce);
  this->FrictionForce->InsertNextValue(record.FrictionForce);
  this->DragForce->InsertNextValue(record.DragForce);
  InsertVector(this->Normal, model.DeviceToWorldRotation * record.Normal);
  this->Value->InsertNextValue(model.ValueAtDevice(record.Proxy));
  this->GradientMagnitude->InsertNextValue(record.GradientMagnitude);
  this->SurfaceValue->InsertNextValue(record.SurfaceValue);
  this->MediumValue->InsertNextValue(record.MediumValue);
  this->Stiffness->InsertNextValue(record.Stiffness);
  this->Friction->InsertNextValue(record.Friction);
  this->Viscosity->InsertNextValue(record.Viscosity);
  this->SurfaceStrength->InsertNextValue(record.SurfaceStrength);
  this->Contact->InsertNextValue(static_cast<unsigned char>(record.Contact));
  this->Unfinished->InsertNextValue(record.IsUnfinished ? 1 : 0);
  this->Renewed->InsertNextValue(record.IsRenewed ? 1 : 0);
  this->Energy->InsertNextValue(this->AddWork(record));
}

double HapticTrace::AddWork(const TickRecord& record)
{
  // A tip that is nowhere does nothing.
  if (this->Energy->GetNumberOfValues() > 0 && IsFinite(record.Tip) && IsFinite(this->LastTip))
  {
    this->Work += 0.5 * Dot(record.Force + this->LastForce, record.Tip - this->LastTip);
  }
  this->LastTip = record.Tip;
  this->LastForce = record.Force;
  return this->Work;
}

void HapticTrace::WriteTo(vtkPolyData* output)
{
  const vtkIdType ticks = this->Proxies->GetNumberOfPoints();
  output->SetPoints(this->Proxies);
  if (ticks > 1)
  {
    vtkNew<vtkCellArray> lines;
    lines->InsertNextCell(static_cast<int>(ticks));
    for (vtkIdType i = 0; i < ticks; ++i)
    {
      lines->InsertCellPoint(i);
    }
    output->SetLines(lines);
  }
  vtkPointData* const data = output->GetPointData();
  for (vtkDataArray* array :
    std::initializer_list<vtkDataArray*>{ this->Time, this->Tip, this->Force, this->NormalForce,
      this->FrictionForce, this->DragForce, this->Normal, this->Value, this->GradientMagnitude,
      this->SurfaceValue, this->MediumValue, this->Stiffness, this->Friction, this->Viscosity,
      this->SurfaceStrength, this->Contact, this->Unfinished, this->Renewed, this->Energy })
  {
    data->AddArray(array);
  }
}

} // namespace VolumeHaptics
