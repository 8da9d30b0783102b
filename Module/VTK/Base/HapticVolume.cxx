// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Base/HapticVolume.h"

#include "VTK/Base/vtkVolumeHapticsCompat.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkSOADataArrayTemplate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace VolumeHaptics
{
namespace
{

template <typename T>
constexpr ScalarType ScalarTypeOf()
{
  if constexpr (std::is_floating_point_v<T>)
  {
    return sizeof(T) == 4 ? ScalarType::Float32 : ScalarType::Float64;
  }
  else if constexpr (sizeof(T) == 1)
  {
    return std::is_signed_v<T> ? ScalarType::Int8 : ScalarType::UInt8;
  }
  else if constexpr (sizeof(T) == 2)
  {
    return std::is_signed_v<T> ? ScalarType::Int16 : ScalarType::UInt16;
  }
  else if constexpr (sizeof(T) == 4)
  {
    return std::is_signed_v<T> ? ScalarType::Int32 : ScalarType::UInt32;
  }
  else
  {
    return std::is_signed_v<T> ? ScalarType::Int64 : ScalarType::UInt64;
  }
}

/**
 * Finds the address of a component's first value and the step between tuples. Returns false for
 * unsupported memory layouts.
 */
template <typename T>
bool LocateComponent(
  vtkDataArray* scalars, int component, VolumeView& view, vtkSmartPointer<vtkDataArray>& holder)
{
  using SeparateComponents = vtkSOADataArrayTemplate<T>;
  view.Type = ScalarTypeOf<T>();
  holder = scalars;
  auto* const separate = SeparateComponents::FastDownCast(scalars);
  if (separate && HasSeparateComponents(separate))
  {
    // Rendering may convert the array's memory to another layout at any time. The holder is a
    // separate array that shares the memory and keeps it valid for the servo.
    holder = vtkSmartPointer<vtkDataArray>::Take(scalars->NewInstance());
    auto* const soa = SeparateComponents::FastDownCast(holder);
    // VTK 9.6 copies nothing into a new array, whose components share one block, so separate them
    // first.
    soa->SetNumberOfComponents(scalars->GetNumberOfComponents());
    soa->SetArray(0, nullptr, 0, false, true);
    soa->ShallowCopy(scalars);
    view.Data = soa->GetComponentArrayPointer(component);
    view.Stride[0] = 1;
    return true;
  }
  // An array whose components share one block keeps that layout; do not copy it, because VTK 9.3
  // crashes.
  if (!separate && !scalars->HasStandardMemoryLayout())
  {
    return false;
  }
  const T* const first = static_cast<const T*>(holder->GetVoidPointer(0));
  view.Data = first ? first + component : nullptr;
  view.Stride[0] = scalars->GetNumberOfComponents();
  return true;
}

/** Returns the first finite value among the eight corners of the volume; 0 if there is none. */
double FirstFiniteCorner(vtkDataArray* scalars, int component, const VolumeView& view)
{
  const std::int64_t* const n = view.Dimensions;
  for (int corner = 0; corner < 8; ++corner)
  {
    const std::int64_t i = (corner & 1) ? n[0] - 1 : 0;
    const std::int64_t j = (corner & 2) ? n[1] - 1 : 0;
    const std::int64_t k = (corner & 4) ? n[2] - 1 : 0;
    const double value = scalars->GetComponent(i + n[0] * (j + n[1] * k), component);
    if (std::isfinite(value))
    {
      return value;
    }
  }
  return 0.0;
}

/**
 * Makes a view of the scalars. `kernelRadius` (voxels) appears in the cure of an error. `holder`
 * must outlive the view: it is the array, or an array that shares its memory.
 */
bool MakeVolumeView(vtkImageData* image, vtkDataArray* scalars, int component, int kernelRadius,
  VolumeView& view, vtkSmartPointer<vtkDataArray>& holder, std::string& error)
{
  std::ostringstream message;
  int dimensions[3];
  image->GetDimensions(dimensions);
  const vtkIdType points = image->GetNumberOfPoints();
  const int components = scalars->GetNumberOfComponents();
  const int needed = PointsNeeded(kernelRadius);
  if (points == 0)
  {
    message
      << "The input image is empty: its extent holds no points. Update its source, or give it "
         "dimensions of at least "
      << needed << " x " << needed << " x " << needed << ", as a KernelRadius of " << kernelRadius
      << " needs.";
  }
  else if (dimensions[0] < 2 || dimensions[1] < 2 || dimensions[2] < 2)
  {
    message << "The input image is " << dimensions[0] << " x " << dimensions[1] << " x "
            << dimensions[2]
            << " points: one voxel thin, which has no gradient across it. Give it a volume of at "
               "least "
            << needed << " points along every axis, as a KernelRadius of " << kernelRadius
            << " needs" << (kernelRadius > 1 ? " (3 are enough with SetKernelRadius(1))." : ".");
  }
  else if (scalars->GetNumberOfTuples() != points)
  {
    message << "The " << DescribeArray(scalars) << " of the input image has "
            << scalars->GetNumberOfTuples() << " tuples for " << points
            << " points. Use point scalars with one tuple a point.";
  }
  else if (component >= components)
  {
    message << "The " << DescribeArray(scalars) << " of the input image has " << components
            << " component(s), but the property asks for component " << component
            << ". Lower vtkHapticProperty::SetComponent (it counts from 0).";
  }
  else
  {
    const bool located = LocateSamples(scalars, component, dimensions, view, holder);
    if (located && !view.Data)
    {
      message << "The " << DescribeArray(scalars)
              << " of the input image has no memory for component " << component << " of its "
              << components
              << ". Give it values for all components, for example with SetArray, or ask for "
                 "another one with vtkHapticProperty::SetComponent (it counts from 0).";
      error = message.str();
      return false;
    }
    if (located)
    {
      view.BorderValue = FirstFiniteCorner(scalars, component, view);
      return true;
    }
    message
      << "The " << DescribeArray(scalars) << " of the input image has the scalar type "
      << scalars->GetDataTypeAsString() << " in a " << scalars->GetClassName()
      << ", which is an unsupported scalar type. Copy it into an array of numbers, for example "
         "with vtkFloatArray::DeepCopy(), and make that the active scalars.";
  }
  error = message.str();
  return false;
}

/** Changes the view of a region so that it is addressed by the indices of the whole volume. */
void PlaceInWhole(vtkImageData* image, const WholeFacts& facts, VolumeView& view)
{
  const int* const extent = image->GetExtent();
  for (int a = 0; a < 3; ++a)
  {
    view.First[a] = std::int64_t{ extent[2 * a] } - facts.Extent[2 * a];
    view.Whole[a] = std::int64_t{ facts.Extent[2 * a + 1] } - facts.Extent[2 * a] + 1;
  }
  view.BorderValue = facts.BorderValue;
}

} // namespace

std::string DescribeArray(vtkDataArray* scalars)
{
  const char* const name = scalars->GetName();
  return std::string("array \"") + (name ? name : "(unnamed)") + "\"";
}

bool LocateSamples(vtkDataArray* scalars, int component, const int dimensions[3], VolumeView& view,
  vtkSmartPointer<vtkDataArray>& holder)
{
  bool located = false;
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(located = LocateComponent<VTK_TT>(scalars, component, view, holder));
    default:
      break;
  }
  for (int a = 0; a < 3; ++a)
  {
    view.Dimensions[a] = dimensions[a];
  }
  view.Stride[1] = view.Stride[0] * dimensions[0];
  view.Stride[2] = view.Stride[1] * dimensions[1];
  return located;
}

bool MakeIndexToWorld(
  vtkImageData* image, const int extent[6], const char* name, Affine3& map, std::string& error)
{
  const double* const spacing = image->GetSpacing();
  const double* const origin = image->GetOrigin();
  const double* const direction = image->GetDirectionMatrix()->GetData();
  for (int i = 0; i < 3; ++i)
  {
    map.Linear.Row[i] = { direction[3 * i] * spacing[0], direction[3 * i + 1] * spacing[1],
      direction[3 * i + 2] * spacing[2] };
  }
  const Vector3 first{ static_cast<double>(extent[0]), static_cast<double>(extent[2]),
    static_cast<double>(extent[4]) };
  map.Offset = Vector3{ origin[0], origin[1], origin[2] } + map.Linear * first;

  std::ostringstream message;
  const Matrix3 d{ { { direction[0], direction[1], direction[2] },
    { direction[3], direction[4], direction[5] }, { direction[6], direction[7], direction[8] } } };
  const Matrix3 columns = Transpose(d);
  const double size = Norm(columns.Row[0]) * Norm(columns.Row[1]) * Norm(columns.Row[2]);
  constexpr double singular = 1e-9;
  if (!IsFinite({ spacing[0], spacing[1], spacing[2] }) || spacing[0] == 0.0 || spacing[1] == 0.0 ||
    spacing[2] == 0.0)
  {
    message << "The spacing of the " << name << " is (" << spacing[0] << ", " << spacing[1] << ", "
            << spacing[2]
            << "): it must be finite and not zero. Set the distance between voxels with "
               "vtkImageData::SetSpacing.";
  }
  else if (!IsFinite({ origin[0], origin[1], origin[2] }))
  {
    message << "The origin of the " << name << " is (" << origin[0] << ", " << origin[1] << ", "
            << origin[2] << "): it must be finite. Set it with vtkImageData::SetOrigin.";
  }
  else if (!(std::abs(Determinant(d)) > singular * size))
  {
    message << "The direction matrix of the " << name << " is singular (determinant "
            << Determinant(d)
            << "): its axes do not span space. Set three independent axes with "
               "vtkImageData::SetDirectionMatrix.";
  }
  else
  {
    return true;
  }
  error = message.str();
  return false;
}

bool ReadVolume(vtkImageData* image, vtkDataArray* scalars, int component, int kernelRadius,
  HapticVolume& volume, std::string& error)
{
  WholeFacts& whole = volume.Whole;
  if (!MakeVolumeView(image, scalars, component, kernelRadius, volume.View, volume.Holder, error) ||
    !ReadWholeFacts(image, component, whole, error) ||
    !MakeIndexToWorld(image, whole.IsThere ? whole.Extent : image->GetExtent(), "input image",
      volume.IndexToWorld, error))
  {
    return false;
  }
  if (whole.IsThere)
  {
    PlaceInWhole(image, whole, volume.View);
  }
  return true;
}

double SmallestSpacing(vtkImageData* image)
{
  const double* const s = image->GetSpacing();
  return std::min({ std::abs(s[0]), std::abs(s[1]), std::abs(s[2]) });
}

} // namespace VolumeHaptics
