// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lets a volume mapper show what a tool has left of the array that it shows.
 *
 * vtkOpenGLGPUVolumeRayCastMapper, also within a vtkSmartVolumeMapper, gets only the changed bricks
 * of its texture. For any other mapper, a copy of the image replaces its input. The
 * application's image is never written to. At the end the mapper shows all tissue again.
 *
 * Results that VTK computes from the image itself remain those of all tissue: the range of values,
 * and the contours with which vtkGPUVolumeRayCastMapper::UseDepthPass begins its rays.
 */
#ifndef CarvedPicture_h
#define CarvedPicture_h

#include "VTK/Scene/Volumes/CarvedArray.h"
#include "VTK/Scene/Volumes/CarvedCopy.h"
#include "VTK/Scene/Volumes/CarvedTexture.h"
#include "VTK/Scene/Volumes/FollowedBricks.h"

#include "vtkVolumeMapper.h"
#include "vtkWeakPointer.h"

#include <memory>

namespace VolumeHaptics
{

class CarvedPicture
{
public:
  /** @param shown the array that the mapper shows; null for the touched one itself */
  CarvedPicture(vtkVolumeMapper* mapper, CarvedArray touched, vtkDataArray* shown = nullptr);
  ~CarvedPicture();
  CarvedPicture(const CarvedPicture&) = delete;
  CarvedPicture& operator=(const CarvedPicture&) = delete;

  /**
   * Collects the changed bricks, before a frame is drawn. Returns whether the mapper has something
   * new to show, so that a frame should be drawn. Does nothing while no tissue is removed.
   */
  bool Update();
  vtkVolumeMapper* GetMapper() const { return this->Mapper; }
  /** The touched array, whose tissue the tool removes. */
  const CarvedArray& GetArray() const { return this->Touched; }
  /** The shown array, which may differ from the touched one. */
  vtkDataArray* GetShown() const { return this->Carved.Array; }
  /** Whether an image is the copy that replaces the mapper's own image. */
  bool IsCopy(vtkDataObject* image) const { return this->Copy && this->Copy->IsCopy(image); }
  /** The image that the copy replaces; null if there is none. */
  vtkAlgorithmOutput* GetReplaced() const
  {
    return this->Copy ? this->Copy->GetReplaced() : nullptr;
  }
  /** Whether the mapper's texture is written to; false if there is none, or if a copy is shown. */
  bool HasTexture() const { return this->Texture != nullptr; }

private:
  vtkWeakPointer<vtkVolumeMapper> Mapper;
  const CarvedArray Touched;
  const CarvedArray Carved; ///< the shown array
  FollowedBricks Bricks;
  std::unique_ptr<CarvedTexture> Texture;
  std::unique_ptr<CarvedCopy> Copy;
};

} // namespace VolumeHaptics

#endif
