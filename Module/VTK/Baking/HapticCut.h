// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What an application cuts away of a volume, as a volume mapper of VTK does.
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
  vtkSmartPointer<vtkPlaneCollection> Planes; ///< null: none
  bool Cropping = false;
  double RegionPlanes[6] = { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 };
  int RegionFlags = 0x0002000; ///< the region in the middle
  bool HasSolidFaces = false;

  void Print(ostream& os, vtkIndent indent) const;

  /** Includes the planes, which an application may move. */
  vtkMTimeType GetMTime() const;

  /**
   * The cut for a model of an image, of which points and cells may be blanked. Null if nothing is
   * cut away; or if something is wrong with it, which `error` then tells, with the cure.
   * @param extent that of index 0 of the model, and of its last one
   */
  std::shared_ptr<const CutAway> Make(vtkImageData* image, const int extent[6],
    const Affine3& indexToWorld, std::string& error) const;
};

} // namespace VolumeHaptics

#endif
