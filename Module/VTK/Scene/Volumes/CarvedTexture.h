// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes removed tissue into the texture of an array that a vtkOpenGLGPUVolumeRayCastMapper
 * draws, a brick at a time.
 *
 * It observes the mapper's rendering events and works within them: there the texture exists, and
 * its OpenGL context is current. Before each rendering it sends the changed bricks. If VTK has
 * uploaded the array anew, with all tissue, it sends all bricks before anything is drawn. If VTK
 * builds its shader in the same rendering, as in a window's first one, there is no event between
 * upload and drawing; then that rendering shows all tissue, and another one is requested.
 */
#ifndef CarvedTexture_h
#define CarvedTexture_h

#include "VTK/Scene/Volumes/CarvedArray.h"
#include "VTK/Scene/Volumes/FollowedBricks.h"

#include "vtkNew.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkTextureObject.h"
#include "vtkTimeStamp.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <utility>
#include <vector>

class vtkCallbackCommand;
class vtkVolumeTexture;

namespace VolumeHaptics
{

class CarvedTexture
{
public:
  /** Borrows the array and the bricks. */
  CarvedTexture(
    vtkOpenGLGPUVolumeRayCastMapper* mapper, const CarvedArray& carved, FollowedBricks& bricks);
  /** Leaves the texture as it is. */
  ~CarvedTexture();
  CarvedTexture(const CarvedTexture&) = delete;
  CarvedTexture& operator=(const CarvedTexture&) = delete;

  /** Whether the last rendering did not show everything, so that another one is needed. */
  bool TakeFrameDue() { return std::exchange(this->IsFrameDue, false); }
  /**
   * Whether bricks can't be written to the texture: the texture is divided into blocks or does not
   * hold the array, it can't show the value of removed tissue, because this is beyond the array's
   * range, or VTK uploads it in each rendering.
   */
  bool IsImpossible() const { return this->HasFailed; }
  /** Call if the mapper shows something else; it may show the array again later. */
  void Forget();
  /** Restores all tissue in the texture. */
  void Restore();

private:
  void FollowRendering(unsigned long event);
  void EndRendering();
  /** Detects that VTK has uploaded another texture, or the same one anew. */
  bool FindUpload();
  /** Whether the last texture can be written to now. */
  bool IsAtHand() const;
  template <typename Take>
  void Send(BrickContent content, Take&& take);
  void SendBrick(vtkVolumeTexture* volume, BrickContent content, std::uint32_t brick);
  vtkVolumeTexture* FindVolume() const;

  vtkWeakPointer<vtkOpenGLGPUVolumeRayCastMapper> Mapper;
  const CarvedArray& Carved;
  FollowedBricks& Bricks;
  vtkNew<vtkCallbackCommand> Observer;
  vtkWeakPointer<vtkTextureObject> Texture;
  vtkMTimeType UploadTime = 0; ///< time of the texture when all bricks were sent
  vtkTimeStamp Begin;          ///< begin of the rendering
  int Missed = 0;              ///< number of renderings in a row that showed all tissue
  bool IsFrameDue = false;
  bool HasFailed = false;
  std::vector<unsigned char> Buffer;
};

} // namespace VolumeHaptics

#endif
