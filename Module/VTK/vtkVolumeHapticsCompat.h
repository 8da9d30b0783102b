// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What differs between VTK 9.1 and 9.6, in one place.
 */
#ifndef vtkVolumeHapticsCompat_h
#define vtkVolumeHapticsCompat_h

#include "vtkAlgorithm.h"
#include "vtkVersionMacros.h"

namespace VolumeHaptics
{

/** Whether the user asked a filter to stop; since VTK 9.3 a filter has to look upstream, too. */
inline bool MustAbort(vtkAlgorithm* algorithm)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  return algorithm->CheckAbort();
#else
  return algorithm->GetAbortExecute() != 0;
#endif
}

} // namespace VolumeHaptics

#endif
