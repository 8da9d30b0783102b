// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Limits a filter to the part of a volume to which a representation of ParaView crops it.
 */
#ifndef HapticCropLink_h
#define HapticCropLink_h

class vtkSMProxy;
class vtkVolumeHapticsFilter;

namespace VolumeHapticsLive
{

class HapticCropLink
{
public:
  /**
   * Copies the representation's properties UseCropping, CroppingOrigin and CroppingScale, as far as
   * it has them. Without a representation, or without its cropping, all is felt.
   */
  void Follow(vtkSMProxy* representation, vtkVolumeHapticsFilter* filter);

private:
  bool HasCropped = false;
};

} // namespace VolumeHapticsLive

#endif
