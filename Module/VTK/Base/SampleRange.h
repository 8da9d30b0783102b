// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The range of a component of a vtkDataArray, found on any thread.
 */
#ifndef SampleRange_h
#define SampleRange_h

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

namespace VolumeHaptics
{

/**
 * The smallest and the largest finite value; the first is larger if there are none. As
 * vtkDataArray::GetFiniteRange, which keeps ranges in the array's information: here a view of the
 * same values keeps them, so that another thread may read the array meanwhile.
 */
inline void FindFiniteRange(vtkDataArray* array, int component, double range[2])
{
  const auto view = vtk::TakeSmartPointer(array->NewInstance());
  view->ShallowCopy(array);
  view->GetFiniteRange(range, component);
}

} // namespace VolumeHaptics

#endif
