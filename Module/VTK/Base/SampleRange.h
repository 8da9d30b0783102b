// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes the range of a component of a vtkDataArray on any thread.
 */
#ifndef SampleRange_h
#define SampleRange_h

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

namespace VolumeHaptics
{

/**
 * Computes the smallest and the largest finite value. Without finite values, the minimum is above
 * the maximum. vtkDataArray::GetFiniteRange would cache the range in the array's information. This
 * function therefore uses a view of the same memory, so that another thread may read the array at
 * the same time. Arrays that do not store tuple after tuple have no such view.
 */
inline void ComputeFiniteRange(vtkDataArray* array, int component, double range[2])
{
  if (!array->HasStandardMemoryLayout() || array->GetDataTypeSize() == 0) // 0 for a vtkBitArray
  {
    array->GetFiniteRange(range, component);
    return;
  }
  const auto view = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(array->GetDataType()));
  view->SetNumberOfComponents(array->GetNumberOfComponents());
  constexpr int keepsMemory = 1;
  view->SetVoidArray(array->GetVoidPointer(0), array->GetNumberOfValues(), keepsMemory);
  view->GetFiniteRange(range, component);
}

} // namespace VolumeHaptics

#endif
