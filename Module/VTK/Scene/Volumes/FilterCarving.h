// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the tools of a filter have removed from the array that it touches.
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

/** What was removed from a volume at one time, and where that lies. */
struct RemovedTissue
{
  std::shared_ptr<TissueRemoval> Removal; ///< null: nothing
  vtkSmartPointer<vtkImageData> Volume;   ///< its place and its extent, without samples
  vtkMTimeType VolumeTime = 0;            ///< of the Volume
  int Component = 0;                      ///< that has lost tissue
  double Air = 0.0;                       ///< the value of a sample without tissue
  std::uint64_t Changes = 0;              ///< of the bricks

  bool IsSame(const RemovedTissue& other) const
  {
    return this->Removal == other.Removal && this->Volume == other.Volume &&
      this->VolumeTime == other.VolumeTime && this->Component == other.Component &&
      this->Air == other.Air && this->Changes == other.Changes;
  }
};

/**
 * The same of the whole volume, of which the samples in memory may be a region, or none; nothing
 * while all tissue remains, and of another volume, of which a model will be made.
 */
RemovedTissue FindRemoved(vtkVolumeHapticsFilter* filter);

/** Nothing is updated. False while nothing was removed from the volume that the filter has now. */
bool FindCarved(vtkVolumeHapticsFilter* filter, CarvedArray& carved);

} // namespace VolumeHaptics

#endif
