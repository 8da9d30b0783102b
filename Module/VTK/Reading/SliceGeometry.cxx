// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Reading/SliceGeometry.h"

#include "VTK/Base/ArrayMemory.h"
#include "VTK/Reading/InputError.h"

#include "vtkDataArray.h"
#include "vtkImageReslice.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <type_traits>

namespace
{
/// Returns column c of the direction matrix, normalised.
void GetAxis(vtkImageData* image, int c, double axis[3])
{
  const double* const stored = image->GetDirectionMatrix()->GetData();
  for (int row = 0; row < 3; ++row)
  {
    axis[row] = image->GetSpacing()[c] < 0.0 ? -stored[3 * row + c] : stored[3 * row + c];
  }
  vtkMath::Normalize(axis);
}

template <typename Value>
void Blend(const Value* a, const Value* b, double weight, vtkIdType count, Value* to)
{
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double value =
      (1.0 - weight) * static_cast<double>(a[i]) + weight * static_cast<double>(b[i]);
    to[i] = static_cast<Value>(std::is_integral<Value>::value ? std::round(value) : value);
  }
}

/// Clamps values to a range.
template <typename Value>
void Clamp(Value* values, vtkIdType count, const double range[2])
{
  const auto low = static_cast<Value>(range[0]), high = static_cast<Value>(range[1]);
  std::transform(
    values, values + count, values, [&](Value value) { return std::clamp(value, low, high); });
}
} // namespace

namespace Explore
{
vtkSmartPointer<vtkImageData> SpaceSlicesEvenly(
  vtkImageData* image, const std::vector<double>& along)
{
  double step = along.back() - along.front();
  for (std::size_t i = 1; i < along.size(); ++i)
  {
    step = std::min(step, along[i] - along[i - 1]);
  }
  // Keep the last slice at its position: the step becomes smaller by less than the length divided
  // by the number of steps.
  const double length = along.back() - along.front();
  const int count = static_cast<int>(std::ceil(length / step - 1e-3)) + 1;
  step = length / (count - 1);
  int size[3];
  image->GetDimensions(size);
  auto even = vtkSmartPointer<vtkImageData>::New();
  even->SetDimensions(size[0], size[1], count);
  even->SetOrigin(image->GetOrigin());
  even->SetDirectionMatrix(image->GetDirectionMatrix());
  const double* const spacing = image->GetSpacing();
  even->SetSpacing(spacing[0], spacing[1], step);
  vtkDataArray* const from = image->GetPointData()->GetScalars();
  const int components = from->GetNumberOfComponents();
  VolumeHaptics::AllocateScalars(even, from->GetDataType(), components);
  vtkDataArray* const to = even->GetPointData()->GetScalars();
  to->SetName(from->GetName());
  const vtkIdType slice = vtkIdType{ size[0] } * size[1] * components;
  std::size_t before = 0;
  for (int k = 0; k < count; ++k)
  {
    const double at = along.front() + k * step;
    while (before + 2 < along.size() && along[before + 1] <= at)
    {
      ++before;
    }
    const double weight =
      std::clamp((at - along[before]) / (along[before + 1] - along[before]), 0.0, 1.0);
    const auto first = static_cast<vtkIdType>(before) * slice;
    switch (from->GetDataType())
    {
      vtkTemplateMacro(Blend(static_cast<VTK_TT*>(from->GetVoidPointer(first)),
        static_cast<VTK_TT*>(from->GetVoidPointer(first + slice)), weight, slice,
        static_cast<VTK_TT*>(to->GetVoidPointer(k * slice))));
    }
  }
  return even;
}

double MeasureShear(vtkImageData* image)
{
  double x[3], y[3], z[3], normal[3];
  GetAxis(image, 0, x);
  GetAxis(image, 1, y);
  GetAxis(image, 2, z);
  vtkMath::Cross(x, y, normal);
  vtkMath::Normalize(normal);
  const double across = std::asin(std::min(1.0, std::abs(vtkMath::Dot(x, y))));
  const double along = std::acos(std::min(1.0, std::abs(vtkMath::Dot(normal, z))));
  return vtkMath::DegreesFromRadians(std::max(across, along));
}

std::string StraightenIfSheared(vtkSmartPointer<vtkImageData>& image, bool areLabels)
{
  constexpr double smallest = 0.1; // degrees; equals 0.2 mm in 100 mm
  const double shear = MeasureShear(image);
  if (!(shear > smallest))
  {
    return {};
  }
  std::ostringstream note;
  note << "its axes are sheared by " << std::round(10.0 * shear) / 10.0
       << " degrees, as by a tilted gantry: resampled on straight axes";
  const vtkSmartPointer<vtkImageData> straight = StraightenAxes(image, areLabels);
  if (!straight)
  {
    throw InputError("The volume", "has a direction matrix whose axes are nearly in one plane",
      "correct it in the file's header");
  }
  image = straight;
  return note.str();
}

vtkSmartPointer<vtkImageData> StraightenAxes(vtkImageData* image, bool areLabels)
{
  double axes[3][3];
  double z[3];
  GetAxis(image, 0, axes[0]);
  GetAxis(image, 1, axes[1]);
  GetAxis(image, 2, z);
  vtkMath::Cross(axes[0], axes[1], axes[2]);
  vtkMath::Normalize(axes[2]);
  const bool isMirrored = vtkMath::Dot(axes[2], z) < 0.0;
  vtkMath::Cross(axes[2], axes[0], axes[1]);
  if (isMirrored)
  {
    vtkMath::MultiplyScalar(axes[2], -1.0);
  }
  double spacing[3];
  for (int a = 0; a < 3; ++a)
  {
    spacing[a] = std::abs(image->GetSpacing()[a]);
  }
  double second[3];
  GetAxis(image, 1, second);
  spacing[1] *= std::abs(vtkMath::Dot(second, axes[1]));
  spacing[2] *= std::abs(vtkMath::Dot(z, axes[2]));

  // Compute the bounding box of all corners, along the new axes.
  int extent[6];
  image->GetExtent(extent);
  double low[3] = { VTK_DOUBLE_MAX, VTK_DOUBLE_MAX, VTK_DOUBLE_MAX };
  double high[3] = { -VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };
  for (int corner = 0; corner < 8; ++corner)
  {
    double point[3];
    image->TransformContinuousIndexToPhysicalPoint(
      extent[corner & 1], extent[2 + (corner >> 1 & 1)], extent[4 + (corner >> 2)], point);
    for (int a = 0; a < 3; ++a)
    {
      const double place = vtkMath::Dot(point, axes[a]);
      low[a] = std::min(low[a], place);
      high[a] = std::max(high[a], place);
    }
  }
  double voxels = 1.0;
  for (int a = 0; a < 3; ++a)
  {
    voxels *= std::ceil((high[a] - low[a]) / spacing[a]) + 1.0;
  }
  constexpr double most = 8.0;
  if (!(voxels <= most * static_cast<double>(image->GetNumberOfPoints())))
  {
    return nullptr;
  }
  auto straight = vtkSmartPointer<vtkImageData>::New();
  int size[3];
  double direction[9];
  double origin[3] = { 0.0, 0.0, 0.0 };
  for (int a = 0; a < 3; ++a)
  {
    size[a] = static_cast<int>(std::ceil((high[a] - low[a]) / spacing[a] - 1e-3)) + 1;
    for (int row = 0; row < 3; ++row)
    {
      direction[3 * row + a] = axes[a][row];
      origin[row] += low[a] * axes[a][row];
    }
  }
  straight->SetDimensions(size);
  straight->SetSpacing(spacing);
  straight->SetOrigin(origin);
  straight->SetDirectionMatrix(direction);

  // Map indices of the new image to indices of the old one, because VTK's reslicing ignores
  // directions.
  vtkNew<vtkMatrix4x4> map;
  vtkMatrix4x4::Multiply4x4(
    image->GetPhysicalToIndexMatrix(), straight->GetIndexToPhysicalMatrix(), map);
  vtkNew<vtkImageData> plain;
  plain->SetExtent(extent);
  plain->GetPointData()->SetScalars(image->GetPointData()->GetScalars());
  double range[2];
  image->GetPointData()->GetScalars()->GetFiniteRange(range, -1);
  vtkNew<vtkImageReslice> reslice;
  reslice->SetInputData(plain);
  reslice->SetResliceAxes(map);
  reslice->SetOutputSpacing(1.0, 1.0, 1.0);
  reslice->SetOutputOrigin(0.0, 0.0, 0.0);
  reslice->SetOutputExtent(0, size[0] - 1, 0, size[1] - 1, 0, size[2] - 1);
  reslice->SetBackgroundLevel(range[0]);
  areLabels ? reslice->SetInterpolationModeToNearestNeighbor()
            : reslice->SetInterpolationModeToCubic();
  reslice->Update();
  vtkDataArray* const scalars = reslice->GetOutput()->GetPointData()->GetScalars();
  scalars->SetName(image->GetPointData()->GetScalars()->GetName());
  if (scalars->GetNumberOfComponents() == 1) // clamp, because cubic interpolation overshoots
  {
    switch (scalars->GetDataType())
    {
      vtkTemplateMacro(Clamp(
        static_cast<VTK_TT*>(scalars->GetVoidPointer(0)), scalars->GetNumberOfTuples(), range));
    }
  }
  straight->GetPointData()->SetScalars(scalars);
  return straight;
}
} // namespace Explore
