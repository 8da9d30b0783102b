// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Hides the API differences between VTK 9.1 and 9.6 in one place.
 */
#ifndef vtkVolumeHapticsCompat_h
#define vtkVolumeHapticsCompat_h

#include "vtkAlgorithm.h"
#include "vtkVersionMacros.h"

// Headers that differ: since VTK 9.4, glad loads the functions of OpenGL, and vtkVector includes
// its operators.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
#define VOLUME_HAPTICS_OPENGL_HEADER "vtk_glad.h"
#define VOLUME_HAPTICS_VECTOR_HEADER "vtkVector.h"
#else
#define VOLUME_HAPTICS_OPENGL_HEADER "vtk_glew.h"
#define VOLUME_HAPTICS_VECTOR_HEADER "vtkVectorOperators.h"
#endif

namespace VolumeHaptics
{

/**
 * Returns whether the user asked a filter to stop. Since VTK 9.3, a filter also has to query the
 * filters upstream.
 */
inline bool MustAbort(vtkAlgorithm* algorithm)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  return algorithm->CheckAbort();
#else
  return algorithm->GetAbortExecute() != 0;
#endif
}

/**
 * Preserves the partial output of an aborted filter, which the pipeline would empty since VTK 9.3.
 */
inline void KeepAbortedOutput(vtkAlgorithm* algorithm)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  algorithm->SetAbortOutput(false);
#else
  (void)algorithm;
#endif
}

namespace Detail
{
/**
 * Gives access to a protected member that VTK 9.3 has no function for. VTK 9.1 lacks the member.
 */
template <typename Array>
struct Storage : Array
{
  template <typename Self = Storage>
  static auto IsSeparate(Array* array, int) -> decltype(&Self::StorageType, bool())
  {
    return array->*(&Self::StorageType) == Self::SOA;
  }
  static bool IsSeparate(Array*, long) { return true; }
};
} // namespace Detail

/**
 * Returns whether each component of a vtkSOADataArrayTemplate is now in a separate memory block.
 * Since VTK 9.2, all components share one block while the array is new, and again after the first
 * GetVoidPointer(), which a mapper calls; the array then has no pointers to components.
 */
template <typename Array>
bool HasSeparateComponents(Array* array)
{
  return Detail::Storage<Array>::IsSeparate(array, 0);
}

} // namespace VolumeHaptics

#endif
