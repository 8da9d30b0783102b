// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Describes the parts that an application cuts away from a volume, as VTK's volume mappers do.
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
  vtkSmartPointer<vtkPlaneCollection> Planes; ///< null if there are none
  bool Cropping = false;
  double RegionPlanes[6] = { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 };
  int RegionFlags = 0x0002000; ///< default: only the region in the middle is shown
  bool HasSolidFaces = false;

  void Print(ostream& os, vtkIndent indent) const;

  /** Returns the modification time, including that of the planes, which an application may move. */
  vtkMTimeType GetMTime() const;

  /**
   * Makes the cut for a model of an image, whose points and cells may be blanked. Returns null if
   * nothing is cut away, or after a fault; `error` then has the fault and the cure.
   * @param extent the model's extent in the image's structured coordinates; index 0 of the model is
   * the extent's lower corner
   */
  std::shared_ptr<const CutAway> Make(vtkImageData* image, const int extent[6],
    const Affine3& indexToWorld, std::string& error) const;
};

} // namespace VolumeHaptics

#endif
