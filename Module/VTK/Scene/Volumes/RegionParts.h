// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Divides the parts of a cropped volume into those before its box and those behind.
 */
#ifndef RegionParts_h
#define RegionParts_h

namespace VolumeHaptics
{

/** Flags of vtkVolumeMapper::SetCroppingRegionFlags; none includes the box itself. */
struct RegionParts
{
  int Behind = 0;
  int Before = 0;
};

/**
 * Computes the flags for a box (lower and upper bounds along x, y and z) and an eye; or the
 * direction to the eye, if it is infinitely far away.
 */
RegionParts SplitAroundBox(const double box[6], const double eye[3], bool isDirection);

} // namespace VolumeHaptics

#endif
