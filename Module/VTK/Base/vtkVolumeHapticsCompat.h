// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Hides the differences between VTK 9.1 and 9.6, in one place.
 */
#ifndef vtkVolumeHapticsCompat_h
#define vtkVolumeHapticsCompat_h

#include "vtkAlgorithm.h"
#include "vtkVersionMacros.h"

#include <type_traits>
#include <utility>

// For #include: since VTK 9.4 glad loads the functions of OpenGL, and vtkVector includes its
// operators.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
#define VOLUME_HAPTICS_OPENGL_HEADER "vtk_glad.h"
#define VOLUME_HAPTICS_VECTOR_HEADER "vtkVector.h"
#else
#define VOLUME_HAPTICS_OPENGL_HEADER "vtk_glew.h"
#define VOLUME_HAPTICS_VECTOR_HEADER "vtkVectorOperators.h"
#endif

namespace VolumeHaptics
{

/** Whether the user asked a filter to stop; since VTK 9.3 a filter has to ask upstream, too. */
inline bool MustAbort(vtkAlgorithm* algorithm)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  return algorithm->CheckAbort();
#else
  return algorithm->GetAbortExecute() != 0;
#endif
}

/** Keeps what a filter has made until it aborted; since VTK 9.3 the pipeline empties its output. */
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
template <typename Array, typename = void>
struct KeepsSeparate : std::true_type
{
  static bool Ask(Array*) { return true; }
};
template <typename Array>
struct KeepsSeparate<Array, std::void_t<decltype(std::declval<Array&>().GetStorageType())>>
{
  static bool Ask(Array* array) { return array->GetStorageType() == Array::SOA; }
};
} // namespace Detail

/**
 * Whether a vtkSOADataArrayTemplate has each component in a memory block of its own now. In VTK
 * 9.6, all components are in one block while the array is new, and again after the first
 * GetVoidPointer(), which a mapper calls; then there are no pointers to components.
 */
template <typename Array>
bool HasSeparateComponents(Array* array)
{
  return Detail::KeepsSeparate<Array>::Ask(array);
}

} // namespace VolumeHaptics

#endif
