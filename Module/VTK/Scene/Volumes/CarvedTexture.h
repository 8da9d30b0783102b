// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Sends what a tool has removed to the texture by which a vtkOpenGLGPUVolumeRayCastMapper draws an
 * array, a brick at a time.
 *
 * It works within the mapper's renderings, whose events it observes: there the texture is at hand,
 * and its OpenGL context is the current one. Before each one it sends what has changed. If VTK has
 * uploaded the array anew, with all tissue, it sends all bricks before anything is drawn. Only if
 * VTK builds its shader in the same rendering, as in the first one in a window, there is no event
 * between the two; then that one shows all tissue, and another one is asked for.
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

  /** Whether the last rendering did not show everything, so that there has to be another one. */
  bool TakeFrameDue() { return std::exchange(this->IsFrameDue, false); }
  /**
   * Whether bricks can't be shown in this way: the texture is divided into blocks or does not hold
   * the array, it can't show the value of removed tissue, which is beyond the array's range, or VTK
   * uploads it in each rendering.
   */
  bool IsImpossible() const { return this->HasFailed; }
  /** The mapper shows something else, and later perhaps the array again. */
  void Forget();
  /** Gives all tissue back to the texture. */
  void Restore();

private:
  void FollowRendering(unsigned long event);
  void EndRendering();
  /** Notes that VTK has uploaded another texture, or the same one anew. */
  bool FindUpload();
  /** Whether the texture that was found last can be written to now. */
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
  vtkMTimeType UploadTime = 0; ///< of the texture, when all bricks were sent
  vtkTimeStamp Begin;          ///< of the rendering
  int Missed = 0;              ///< renderings in a row in which all tissue was seen
  bool IsFrameDue = false;
  bool HasFailed = false;
  std::vector<unsigned char> Buffer;
};

} // namespace VolumeHaptics

#endif
