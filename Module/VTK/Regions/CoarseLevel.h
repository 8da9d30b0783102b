// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A coarse image in memory that stands in for late samples of a large volume.
 */
#ifndef CoarseLevel_h
#define CoarseLevel_h

#include "Core/Field/VolumeView.h"
#include "Core/Math/Vector3.h"
#include "VTK/Regions/Formats/LargeVolume.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <string>

class vtkImageData;

namespace VolumeHaptics
{

/** Never changes, so that threads can share it. The owner releases the last reference. */
class CoarseLevel
{
public:
  /**
   * Makes the level from the first component of an image's scalars, for a volume in the same world.
   * Outside samples are filled, unless the scalars are labels. Null, with the cure in `error`, if
   * there are no scalars.
   */
  static std::shared_ptr<const CoarseLevel> Make(
    vtkImageData* image, bool areLabels, const Affine3& indexToWorld, std::string& error);

  /**
   * Fills a box of the volume, x fastest, with samples of a VTK type: trilinear between the samples
   * of the image, and as at its border beyond them; rounded for integer types.
   */
  void Fill(const BoxExtent& box, int scalarType, void* samples) const;

private:
  CoarseLevel() = default;
  template <typename T>
  void FindRow(const BoxExtent& box, int j, int k, double* values) const;

  VolumeView View;
  vtkSmartPointer<vtkDataArray> Holder;
  Affine3 FromVolume; ///< maps an index of the volume to an index of View
};

} // namespace VolumeHaptics

#endif
