// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Identifies the source of a filter's time steps. While it is unchanged, samples that were read can
 * be kept: only settings have changed.
 */
#ifndef FrameOrigin_h
#define FrameOrigin_h

#include "VTK/Device/Playback/HapticChangeTime.h"

#include "vtkType.h"
#include "vtkVolumeHapticsFilter.h"

#include <string>

namespace VolumeHaptics
{

struct FrameOrigin
{
  const void* Connection = nullptr; ///< connection to the source; not dereferenced
  vtkMTimeType Time = 0;            ///< last change of the source, or of what it reads
  std::string Displacements;        ///< name of the displacements' array

  bool operator==(const FrameOrigin& other) const
  {
    return this->Connection == other.Connection && this->Time == other.Time &&
      this->Displacements == other.Displacements;
  }
};

inline FrameOrigin FindOrigin(vtkVolumeHapticsFilter* filter)
{
  return { filter->GetInputConnection(0, 0), FindPipelineTime(filter->GetInputAlgorithm(0, 0)),
    filter->GetDisplacementArrayName() };
}

} // namespace VolumeHaptics

#endif
