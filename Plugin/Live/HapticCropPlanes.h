// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes the planes to which a ParaView representation crops a volume.
 */
#ifndef HapticCropPlanes_h
#define HapticCropPlanes_h

namespace VolumeHapticsLive
{

/** The box to which a representation's scale and shift refer. */
enum class CropBase
{
  Bounds,     ///< the bounds: up to ParaView 5.12
  WholeExtent ///< the whole extent, whatever the image's origin and spacing: from 5.13 on
};

/** Returns the box to which a representation's scale and shift refer in a version of ParaView. */
constexpr CropBase ChooseCropBase(int major, int minor)
{
  return major > 5 || (major == 5 && minor >= 13) ? CropBase::WholeExtent : CropBase::Bounds;
}

/**
 * Computes the planes in the coordinates of the data, like
 * vtkImageVolumeRepresentation::UpdateMapperParameters(), which passes them to its mapper.
 */
inline void ComputeCropPlanes(CropBase base, const double bounds[6], const int wholeExtent[6],
  const double origin[3], const double scale[3], double planes[6])
{
  for (int i = 0; i < 6; ++i)
  {
    const double scaled = base == CropBase::Bounds ? bounds[i] : wholeExtent[i];
    planes[i] = origin[i / 2] + scaled * scale[i / 2];
  }
}

} // namespace VolumeHapticsLive

#endif
