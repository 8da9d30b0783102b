// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Memory for arrays whose size comes from data. If there is none, VTK's own arrays end the program,
 * but in builds of VTK with NDEBUG; Debian's ParaView has another one. These throw std::bad_alloc.
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
#include <cstdlib>
#include <limits>
#include <new>

namespace VolumeHaptics
{

/** Gives an array of a fixed type room for so many tuples, whose values are arbitrary. */
inline void AllocateTuples(vtkDataArray* array, vtkIdType tuples)
{
  const vtkIdType components = array->GetNumberOfComponents();
  const vtkIdType size = array->GetDataTypeSize(); // 0 for bits
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
    std::malloc(static_cast<std::size_t>(size > 0 ? values * size : (values + 7) / 8));
  if (!memory)
  {
    throw std::bad_alloc();
  }
  array->SetVoidArray(memory, values, 0, vtkAbstractArray::VTK_DATA_ARRAY_FREE);
}

/** An array with a type of VTK's. */
inline vtkSmartPointer<vtkDataArray> NewArray(int type, int components, vtkIdType tuples)
{
  auto array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
  array->SetNumberOfComponents(components);
  AllocateTuples(array, tuples);
  return array;
}

///@{
/**
 * A copy as VTK's DeepCopy() makes it, with tuple after tuple in memory: of the class of the array
 * if that keeps them so, or of a type.
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
 * VTK's DeepCopy() of whole data, which is not begun unless there is memory for so many copies at
 * once: what is made of the copy next takes memory of VTK's own, too.
 */
inline void CopyData(vtkDataObject* from, vtkDataObject* to, std::size_t copies = 1)
{
  const std::size_t bytes = copies * from->GetActualMemorySize() * 1024; // it counts in KiB
  void* const room = ::operator new(bytes, std::nothrow);
  ::operator delete(room);
  if (!room)
  {
    throw std::bad_alloc();
  }
  to->DeepCopy(from);
}

/** The scalars of an image, with the name that VTK's AllocateScalars() gives them. */
inline void AllocateScalars(vtkImageData* image, int type, int components)
{
  const auto scalars = NewArray(type, components, image->GetNumberOfPoints());
  scalars->SetName("ImageScalars");
  image->GetPointData()->SetScalars(scalars);
}

} // namespace VolumeHaptics

#endif
