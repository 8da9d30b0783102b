// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Describes how an application cuts a volume, by clipping planes and cropping regions like those of
 * VTK's volume mappers.
 */
#ifndef HapticCut_h
#define HapticCut_h

#include "Core/Math/Vector3.h"

#include "vtkPlaneCollection.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <string>

class vtkImageData;

namespace VolumeHaptics
{
class CutAway;

struct HapticCut
{
  vtkSmartPointer<vtkPlaneCollection> Planes; ///< null without clipping planes
  bool Cropping = false;
  double RegionPlanes[6] = { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 };
  int RegionFlags = 0x0002000; ///< bit mask of the visible regions; default: only the middle one
  bool HasSolidFaces = false;

  void Print(ostream& os, vtkIndent indent) const;

  /**
   * Returns the latest modification time of the cut and its planes, which an application may move.
   */
  vtkMTimeType GetMTime() const;

  /**
   * Makes the cut for a model of an image. Blanked points and cells of the image are cut away, too.
   * Returns null if nothing is cut away. After a fault, also returns null, with the fault and the
   * cure in `error`.
   * @param extent the model's extent in the image's structured coordinates; index 0 of the model is
   * the extent's lower corner
   */
  std::shared_ptr<const CutAway> Make(vtkImageData* image, const int extent[6],
    const Affine3& indexToWorld, std::string& error) const;
};

} // namespace VolumeHaptics

#endif
