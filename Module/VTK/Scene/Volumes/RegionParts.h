// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which parts of a cropped volume lie before its box, and which behind.
 */
#ifndef RegionParts_h
#define RegionParts_h

namespace VolumeHaptics
{

/** Flags of vtkVolumeMapper::SetCroppingRegionFlags; none has the box itself. */
struct RegionParts
{
  int Behind = 0;
  int Before = 0;
};

/**
 * For a box (lower and upper bounds along x, y and z) and an eye; or, if it is infinitely far away,
 * the direction to it.
 */
RegionParts SplitAroundBox(const double box[6], const double eye[3], bool isDirection);

} // namespace VolumeHaptics

#endif
