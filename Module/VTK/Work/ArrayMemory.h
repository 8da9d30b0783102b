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
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

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

/** A copy as VTK's DeepCopy() makes it, with tuple after tuple in memory. */
inline vtkSmartPointer<vtkDataArray> CopyArray(vtkDataArray* from, int type)
{
  const auto copy = NewArray(type, from->GetNumberOfComponents(), from->GetNumberOfTuples());
  copy->DeepCopy(from);
  return copy;
}
/** The same, of the class of the array if that keeps tuple after tuple. */
inline vtkSmartPointer<vtkDataArray> CopyArray(vtkDataArray* from)
{
  if (!from->HasStandardMemoryLayout())
  {
    return CopyArray(from, from->GetDataType());
  }
  const auto copy = vtk::TakeSmartPointer(from->NewInstance());
  copy->SetNumberOfComponents(from->GetNumberOfComponents());
  AllocateTuples(copy, from->GetNumberOfTuples());
  copy->DeepCopy(from);
  return copy;
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
