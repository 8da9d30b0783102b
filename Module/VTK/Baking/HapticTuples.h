// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads vectors from arrays.
 */
#ifndef HapticTuples_h
#define HapticTuples_h

#include "Core/Math/Vector3.h"

#include "vtkDataArray.h"

namespace VolumeHaptics
{

inline Vector3 FromArray(const double* v)
{
  return { v[0], v[1], v[2] };
}

/** Three components of a tuple, beginning with the component `first`. */
inline Vector3 ReadVector(vtkDataArray* array, vtkIdType tuple, int first = 0)
{
  return { array->GetComponent(tuple, first), array->GetComponent(tuple, first + 1),
    array->GetComponent(tuple, first + 2) };
}

} // namespace VolumeHaptics

#endif
