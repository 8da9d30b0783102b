// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Files of the tissue that was removed: a .vti image of shares, of the part of the volume from
 * which something was removed, with the volume's extent as a field array.
 */
#ifndef RemovalFile_h
#define RemovalFile_h

#include "Core/Carving/ShareSnapshot.h"

#include <string>
#include <vector>

class vtkImageData;

namespace VolumeHaptics
{

/** Makes an image of the shares in an extent of a volume, with its geometry. */
void MakeShareImage(
  const CarvedBricks* bricks, vtkImageData* geometry, const int extent[6], vtkImageData* shares);

/** False, with the reason and the cure in `error`, if the file can't be written. */
bool WriteRemovalFile(
  const CarvedBricks& bricks, vtkImageData* geometry, const std::string& file, std::string& error);

/**
 * Reads the shares, and the geometry of their volume. False, with what is wrong with the file and
 * the cure in `error`, if it can't be read.
 */
bool ReadRemovalFile(const std::string& file, vtkImageData* geometry,
  std::vector<BrickShares>& shares, std::string& error);

} // namespace VolumeHaptics

#endif
