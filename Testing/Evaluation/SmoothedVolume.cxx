// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SmoothedVolume.h"

#include "VTK/Filter/HapticBaker.h"

#include "Methods.h"

#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"

using namespace VolumeHaptics;

namespace evaluation
{

SmoothedVolume::SmoothedVolume(vtkImageData* image)
  : Image(image)
{
  vtkNew<vtkVolumeHapticsFilter> filter;
  filter->SetInputDataObject(0, image);
  this->Model = filter->GetBaker().Bake(1000.0, {}, nullptr);
}

double SmoothedVolume::Value(const Vector3& world) const
{
  const Vector3 index = this->Model ? this->Model->DeviceToIndex(0.001 * world) : Vector3{};
  const bool isInside = this->Model && this->Model->Baked->Field.IsInside(index);
  return isInside ? this->Model->Baked->Field.Gradient(index).Value : 0.0;
}

Vector3 SmoothedVolume::Gradient(const Vector3& world) const
{
  const Vector3 index = this->Model ? this->Model->DeviceToIndex(0.001 * world) : Vector3{};
  const bool isInside = this->Model && this->Model->Baked->Field.IsInside(index);
  // Device space is the world in metres, with the same axes. The gradient is per world unit.
  return isInside
    ? this->Model->GradientToDevice * this->Model->Baked->Field.Gradient(index).Gradient
    : Vector3{};
}

double SmoothedVolume::RawValue(const Vector3& world) const
{
  return this->Model ? this->Model->ValueAtDevice(0.001 * world) : 0.0;
}

Field SmoothedVolume::Off(double level) const
{
  return [level, self = *this](const Vector3& world)
  { return (self.Value(world) - level) / Norm(self.Gradient(world)); };
}

Field SmoothedVolume::RawOff(double level) const
{
  return [level, self = *this](const Vector3& world)
  { return (self.RawValue(world) - level) / Norm(self.Gradient(world)); };
}

vtkSmartPointer<vtkPolyData> SmoothedVolume::ComputeSurface(double level) const
{
  // Work in index coordinates, because filters of VTK 9.1 do not support image directions.
  vtkNew<vtkImageData> samples;
  int n[3];
  this->Image->GetDimensions(n);
  samples->SetDimensions(n);
  samples->AllocateScalars(VTK_FLOAT, 1);
  auto* to = static_cast<float*>(samples->GetScalarPointer());
  for (int k = 0; k < n[2]; ++k)
  {
    for (int j = 0; j < n[1]; ++j)
    {
      for (int i = 0; i < n[0]; ++i)
      {
        const Vector3 index = { 1.0 * i, 1.0 * j, 1.0 * k };
        *to++ = static_cast<float>(this->Model->Baked->Field.Gradient(index).Value);
      }
    }
  }
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(samples);
  edges->SetValue(0, level);
  edges->ComputeNormalsOn();
  edges->ComputeScalarsOff();
  vtkNew<vtkTransform> toWorld;
  toWorld->SetMatrix(this->Image->GetIndexToPhysicalMatrix());
  const int* const extent = this->Image->GetExtent();
  toWorld->Translate(extent[0], extent[2], extent[4]);
  vtkNew<vtkTransformPolyDataFilter> placed;
  placed->SetTransform(toWorld);
  placed->SetInputConnection(edges->GetOutputPort());
  placed->Update();
  return placed->GetOutput();
}

} // namespace evaluation
