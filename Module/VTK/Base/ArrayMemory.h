// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Allocates arrays whose size comes from data. These functions throw std::bad_alloc. VTK's own
 * arrays would end the program instead, unless VTK is built with NDEBUG; the VTK in Debian's
 * ParaView is built without it.
 */
#ifndef ArrayMemory_h
#define ArrayMemory_h

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <limits>
#include <new>

namespace VolumeHaptics
{

/** Allocates this many tuples in an array of a fixed type. The values stay uninitialised. */
inline void AllocateTuples(vtkDataArray* array, vtkIdType tuples)
{
  const vtkIdType components = array->GetNumberOfComponents();
  const vtkIdType size = array->GetDataTypeSize(); // 0 for a vtkBitArray
  if (tuples > std::numeric_limits<vtkIdType>::max() / 16 / components)
  {
    throw std::bad_alloc();
  }
  const vtkIdType values = tuples * components;
  if (values <= 0)
  {
    array->Initialize();
    return;
  }
  void* const memory =
    ::operator new(static_cast<std::size_t>(size > 0 ? values * size : (values + 7) / 8));
  array->SetVoidArray(memory, values, 0, vtkAbstractArray::VTK_DATA_ARRAY_USER_DEFINED);
  array->SetArrayFreeFunction([](void* owned) { ::operator delete(owned); });
}

/** Creates an array of a VTK type, such as VTK_FLOAT, with uninitialised values. */
inline vtkSmartPointer<vtkDataArray> NewArray(int type, int components, vtkIdType tuples)
{
  auto array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
  array->SetNumberOfComponents(components);
  AllocateTuples(array, tuples);
  return array;
}

///@{
/**
 * Copies an array as VTK's DeepCopy() does, but always stores tuple after tuple. The copy has the
 * class of the array if that class has this layout. Otherwise it has the type's default class.
 */
inline vtkSmartPointer<vtkDataArray> CopyArray(
  vtkDataArray* from, vtkSmartPointer<vtkDataArray> copy)
{
  copy->SetNumberOfComponents(from->GetNumberOfComponents());
  AllocateTuples(copy, from->GetNumberOfTuples());
  copy->DeepCopy(from);
  return copy;
}
inline vtkSmartPointer<vtkDataArray> CopyArray(vtkDataArray* from, int type)
{
  return CopyArray(from, vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type)));
}
inline vtkSmartPointer<vtkDataArray> CopyArray(vtkDataArray* from)
{
  return from->HasStandardMemoryLayout()
    ? CopyArray(from, vtk::TakeSmartPointer(from->NewInstance()))
    : CopyArray(from, from->GetDataType());
}
///@}

/**
 * Calls VTK's DeepCopy() on a data object. Throws std::bad_alloc unless there is memory for
 * `copies` copies at once; use more than one if VTK allocates memory in the next step, too.
 */
inline void CopyData(vtkDataObject* from, vtkDataObject* to, std::size_t copies = 1)
{
  const std::size_t bytes = copies * from->GetActualMemorySize() * 1024; // in KiB
  void* const room = ::operator new(bytes, std::nothrow);
  ::operator delete(room);
  if (!room)
  {
    throw std::bad_alloc();
  }
  to->DeepCopy(from);
}

/** Allocates the scalars of an image, named like those of VTK's AllocateScalars(). */
inline void AllocateScalars(vtkImageData* image, int type, int components)
{
  const auto scalars = NewArray(type, components, image->GetNumberOfPoints());
  scalars->SetName("ImageScalars");
  image->GetPointData()->SetScalars(scalars);
}

} // namespace VolumeHaptics

#endif
