// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A coarse image in memory that stands in for samples of a large volume which are late.
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

/** Never changes, so that threads share it. The owner drops the last reference. */
class CoarseLevel
{
public:
  /**
   * The first component of an image's scalars, for a volume that lies in the same world; what is
   * outside is filled, unless they are labels. Null, with the cure in `error`, if there is none.
   */
  static std::shared_ptr<const CoarseLevel> Make(
    vtkImageData* image, bool areLabels, const Affine3& indexToWorld, std::string& error);

  /**
   * Fills a box of the volume, x fastest, with samples of a VTK type: trilinear between the samples
   * of the image, and beyond them as at its border; rounded if the type is of integers.
   */
  void Fill(const BoxExtent& box, int scalarType, void* samples) const;

private:
  CoarseLevel() = default;
  template <typename T>
  void FindRow(const BoxExtent& box, int j, int k, double* values) const;

  VolumeView View;
  vtkSmartPointer<vtkDataArray> Holder;
  Affine3 FromVolume; ///< from an index of the volume to one of View
};

} // namespace VolumeHaptics

#endif
