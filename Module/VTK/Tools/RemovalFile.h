// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes and reads files of removed tissue. Such a file is a .vti image of the fractions in the
 * part of the volume that has lost tissue. The volume's extent and AirValue are field arrays.
 */
#ifndef RemovalFile_h
#define RemovalFile_h

#include "Core/Carving/TissueSnapshot.h"

#include "vtkImageData.h"
#include "vtkNew.h"

#include <string>
#include <vector>

namespace VolumeHaptics
{

/**
 * Sets the extent of an image, and copies the origin, spacing and direction of another image to it.
 */
void CopyGeometry(vtkImageData* from, const int extent[6], vtkImageData* to);

/** Makes an image of the fractions in an extent of a volume, with the volume's geometry. */
void MakeTissueImage(
  const CarvedBricks* bricks, vtkImageData* geometry, const int extent[6], vtkImageData* fractions);

/** Writes a file. On failure, returns false, with the reason and the cure in `error`. */
bool WriteRemovalFile(const CarvedBricks& bricks, double airValue, vtkImageData* geometry,
  const std::string& file, std::string& error);

/** Contents of a file of removed tissue. */
struct RemovalContent
{
  vtkNew<vtkImageData> Geometry; ///< geometry of the volume
  std::vector<BrickTissue> Fractions;
  double AirValue = 0.0;
};

/** Reads a file. On failure, returns false, with the fault and the cure in `error`. */
bool ReadRemovalFile(const std::string& file, RemovalContent& content, std::string& error);

} // namespace VolumeHaptics

#endif
