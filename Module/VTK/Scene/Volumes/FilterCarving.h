// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The tissue that the tools of a filter have removed from the touched array.
 */
#ifndef FilterCarving_h
#define FilterCarving_h

#include "VTK/Scene/Volumes/CarvedArray.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstdint>
#include <memory>

class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{

/** The tissue removed from a volume at one time, and its place. */
struct RemovedTissue
{
  std::shared_ptr<TissueRemoval> Removal; ///< null: nothing
  vtkSmartPointer<vtkImageData> Volume;   ///< place and extent of the volume, without samples
  vtkMTimeType VolumeTime = 0;            ///< time of Volume
  int Component = 0;                      ///< the component that has lost tissue
  double Air = 0.0;                       ///< value of a sample without tissue
  std::uint64_t Changes = 0;              ///< number of the bricks' changes

  bool IsSame(const RemovedTissue& other) const
  {
    return this->Removal == other.Removal && this->Volume == other.Volume &&
      this->VolumeTime == other.VolumeTime && this->Component == other.Component &&
      this->Air == other.Air && this->Changes == other.Changes;
  }
};

/**
 * The removed tissue of the whole volume; the samples in memory may be a region of it, or none.
 * Empty while all tissue remains, and for a new volume without a model.
 */
RemovedTissue FindRemoved(vtkVolumeHapticsFilter* filter);

/** Whether tissue was removed from the filter's present volume. Updates nothing. */
bool FindCarved(vtkVolumeHapticsFilter* filter, CarvedArray& carved);

} // namespace VolumeHaptics

#endif
