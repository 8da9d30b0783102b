// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lets a volume mapper show what a tool has left of the array that it shows.
 *
 * vtkOpenGLGPUVolumeRayCastMapper, also within a vtkSmartVolumeMapper, gets only the changed bricks
 * of its texture. Any other mapper gets a copy of the image in the place of its input. The
 * application's image is never written to. At the end the mapper shows all tissue again.
 *
 * What VTK computes from the image itself stays that of the whole one: the range of its values, and
 * the contours with which vtkGPUVolumeRayCastMapper::UseDepthPass begins its rays.
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
   * Follows the bricks, before a frame is drawn; whether the mapper has something new to show, so
   * that one should be drawn. Nothing is changed as long as no tissue was removed.
   */
  bool Update();
  vtkVolumeMapper* GetMapper() const { return this->Mapper; }
  /** The touched array, of which the tool has removed tissue. */
  const CarvedArray& GetArray() const { return this->Touched; }
  /** The array that is shown, which may be another one. */
  vtkDataArray* GetShown() const { return this->Carved.Array; }
  /** Whether an image is the copy that the mapper shows in the place of its own. */
  bool IsCopy(vtkDataObject* image) const { return this->Copy && this->Copy->IsCopy(image); }
  /** What the copy replaces; null if there is none. */
  vtkAlgorithmOutput* GetReplaced() const
  {
    return this->Copy ? this->Copy->GetReplaced() : nullptr;
  }
  /** Whether the mapper's texture is written to; false if there is none, or a copy is shown. */
  bool HasTexture() const { return this->Texture != nullptr; }

private:
  vtkWeakPointer<vtkVolumeMapper> Mapper;
  const CarvedArray Touched;
  const CarvedArray Carved; ///< the array that is shown
  FollowedBricks Bricks;
  std::unique_ptr<CarvedTexture> Texture;
  std::unique_ptr<CarvedCopy> Copy;
};

} // namespace VolumeHaptics

#endif
