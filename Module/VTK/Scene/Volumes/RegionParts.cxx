// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Volumes/RegionParts.h"

namespace VolumeHaptics
{

RegionParts SplitAroundBox(const double box[6], const double eye[3], bool isDirection)
{
  RegionParts parts;
  for (int part = 0; part < 27; ++part)
  {
    const int side[3] = { part % 3 - 1, part / 3 % 3 - 1, part / 9 - 1 };
    bool isBehind = false;
    bool isBox = true;
    for (int a = 0; a < 3; ++a)
    {
      // The plane between part and box has the eye on the box's side.
      const double above = side[a] > 0 ? (isDirection ? eye[a] : eye[a] - box[2 * a + 1])
                                       : (isDirection ? -eye[a] : box[2 * a] - eye[a]);
      isBehind = isBehind || (side[a] != 0 && above <= 0.0);
      isBox = isBox && side[a] == 0;
    }
    if (!isBox)
    {
      (isBehind ? parts.Behind : parts.Before) |= 1 << part;
    }
  }
  return parts;
}

} // namespace VolumeHaptics
