// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads vectors and quaternions from data arrays and writes them to arrays.
 */
#ifndef HapticTuples_h
#define HapticTuples_h

#include "Core/Math/Quaternion.h"
#include "Core/Math/Vector3.h"

#include "vtkDataArray.h"

namespace VolumeHaptics
{

inline Vector3 FromArray(const double* v)
{
  return { v[0], v[1], v[2] };
}

/** Reads three consecutive components of a tuple, starting at component `first`. */
inline Vector3 ReadVector(vtkDataArray* array, vtkIdType tuple, int first = 0)
{
  return { array->GetComponent(tuple, first), array->GetComponent(tuple, first + 1),
    array->GetComponent(tuple, first + 2) };
}

/** Reads the four components of a tuple: w, x, y, z. */
inline Quaternion ReadQuaternion(vtkDataArray* array, vtkIdType tuple)
{
  return { array->GetComponent(tuple, 0), array->GetComponent(tuple, 1),
    array->GetComponent(tuple, 2), array->GetComponent(tuple, 3) };
}

inline void ToArray(const Vector3& from, double to[3])
{
  to[0] = from.X;
  to[1] = from.Y;
  to[2] = from.Z;
}

inline void ToArray(const Quaternion& from, double to[4])
{
  to[0] = from.W;
  to[1] = from.X;
  to[2] = from.Y;
  to[3] = from.Z;
}

} // namespace VolumeHaptics

#endif
