// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Gives access to the mappers inside a vtkSmartVolumeMapper.
 */
#ifndef SmartMapperParts_h
#define SmartMapperParts_h

#include "vtkSmartVolumeMapper.h"

class vtkFixedPointVolumeRayCastMapper;
class vtkGPUVolumeRayCastMapper;

namespace VolumeHaptics
{

/** Subclass that only gives access to protected members of vtkSmartVolumeMapper. */
struct SmartMapperParts : vtkSmartVolumeMapper
{
  static vtkFixedPointVolumeRayCastMapper* GetCPUMapper(vtkSmartVolumeMapper* mapper)
  {
    return mapper->*(&SmartMapperParts::RayCastMapper);
  }
  static vtkGPUVolumeRayCastMapper* GetGPUMapper(vtkSmartVolumeMapper* mapper)
  {
    return mapper->*(&SmartMapperParts::GPUMapper);
  }
  static bool DrawsFewerVoxels(vtkSmartVolumeMapper* mapper)
  {
    return mapper->*(&SmartMapperParts::LowResGPUNecessary) != 0;
  }
};

} // namespace VolumeHaptics

#endif
