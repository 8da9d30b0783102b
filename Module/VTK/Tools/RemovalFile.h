// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes and reads files of removed tissue: a .vti image of the fractions in the part of the volume
 * from which something was removed, with the volume's extent and its AirValue as field arrays.
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

/** Gives an image an extent, and the origin, spacing and direction of another image. */
void CopyGeometry(vtkImageData* from, const int extent[6], vtkImageData* to);

/** Makes an image of the fractions in an extent of a volume, with its geometry. */
void MakeTissueImage(
  const CarvedBricks* bricks, vtkImageData* geometry, const int extent[6], vtkImageData* fractions);

/** Writes a file. Returns false, with the reason and the cure in `error`, on failure. */
bool WriteRemovalFile(const CarvedBricks& bricks, double airValue, vtkImageData* geometry,
  const std::string& file, std::string& error);

/** The contents of a file of removed tissue. */
struct RemovalContent
{
  vtkNew<vtkImageData> Geometry; ///< geometry of the volume
  std::vector<BrickTissue> Fractions;
  double AirValue = 0.0;
};

/** Reads a file. Returns false, with the fault and the cure in `error`, on failure. */
bool ReadRemovalFile(const std::string& file, RemovalContent& content, std::string& error);

} // namespace VolumeHaptics

#endif
