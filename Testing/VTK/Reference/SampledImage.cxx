// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SampledImage.h"

#include <vtkDataArray.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>

namespace reference
{
Vec3 Geometry::World(const Vec3& index) const
{
  const Vec3 scaled = { { this->spacing[0] * index[0], this->spacing[1] * index[1],
    this->spacing[2] * index[2] } };
  return this->origin + this->direction * scaled;
}

Vec3 Geometry::Centre() const
{
  return this->World({ { 0.5 * (this->extent[0] + this->extent[1]),
    0.5 * (this->extent[2] + this->extent[3]), 0.5 * (this->extent[4] + this->extent[5]) } });
}

Geometry Cube(double half, double spacing)
{
  const int n = int(std::ceil(half / spacing));
  Geometry geometry;
  geometry.spacing = { { spacing, spacing, spacing } };
  for (int axis = 0; axis < 3; ++axis)
  {
    geometry.extent[2 * axis] = -n;
    geometry.extent[2 * axis + 1] = n;
  }
  return geometry;
}

Geometry Moved(const Geometry& geometry, const Mat3& rotation, const Vec3& translation)
{
  Geometry moved = geometry;
  moved.origin = rotation * geometry.origin + translation;
  for (int axis = 0; axis < 3; ++axis)
  {
    moved.direction.column[axis] = rotation * geometry.direction.column[axis];
  }
  return moved;
}

vtkSmartPointer<vtkImageData> MakeImage(const Geometry& geometry)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  int extent[6];
  std::copy(geometry.extent, geometry.extent + 6, extent);
  image->SetExtent(extent);
  image->SetSpacing(geometry.spacing.c);
  image->SetOrigin(geometry.origin.c);
  vtkNew<vtkMatrix3x3> direction;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int row = 0; row < 3; ++row)
    {
      direction->SetElement(row, axis, geometry.direction.column[axis][row]);
    }
  }
  image->SetDirectionMatrix(direction);
  return image;
}

void Fill(vtkDataArray* array, int component, const Geometry& geometry, const Field& field)
{
  const int* e = geometry.extent;
  const int type = array->GetDataType();
  const bool real = type == VTK_DOUBLE || type == VTK_FLOAT;
  vtkIdType id = 0;
  for (int k = e[4]; k <= e[5]; ++k)
  {
    for (int j = e[2]; j <= e[3]; ++j)
    {
      for (int i = e[0]; i <= e[1]; ++i)
      {
        const double value = field(geometry.World({ { double(i), double(j), double(k) } }));
        const double nearest =
          std::clamp(std::round(value), array->GetDataTypeMin(), array->GetDataTypeMax());
        array->SetComponent(id++, component, real ? value : nearest);
      }
    }
  }
}

vtkSmartPointer<vtkImageData> Sample(const Geometry& geometry, const Field& field, int scalarType)
{
  vtkSmartPointer<vtkImageData> image = MakeImage(geometry);
  image->AllocateScalars(scalarType, 1);
  Fill(image->GetPointData()->GetScalars(), 0, geometry, field);
  return image;
}
} // namespace reference
