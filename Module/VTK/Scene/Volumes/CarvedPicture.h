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
#include "VTK/Scene/Volumes/ReplacedInput.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"
#include "vtkTimeStamp.h"
#include "vtkType.h"
#include "vtkVolumeMapper.h"
#include "vtkWeakPointer.h"

#include <memory>
#include <utility>
#include <vector>

class vtkAlgorithmOutput;
class vtkCallbackCommand;
class vtkRenderer;
class vtkVolumeTexture;

namespace VolumeHaptics
{

/** Returns the port whose image has an array that the mapper shows; -1 if there is none. */
int FindShownPort(vtkVolumeMapper* mapper, vtkDataArray* array);
/**
 * Returns the array that a mapper shows, if it is the touched array or is shown instead of it: see
 * vtkHapticRemoval::TOUCHED_ARRAY(). Null otherwise.
 */
vtkDataArray* GetShownArray(vtkVolumeMapper* mapper, vtkDataArray* touched);

/**
 * Shows what a tool has left of an image by a copy that replaces a mapper's input: for mappers
 * whose texture can't be written to. It needs the memory of the array once more, and VTK uploads
 * or prepares all of it after each change.
 */
class CarvedCopy
{
public:
  /** Borrows the array and the bricks. */
  CarvedCopy(vtkVolumeMapper* mapper, const CarvedArray& carved, FollowedBricks& bricks)
    : Mapper(mapper)
    , Carved(carved)
    , Bricks(bricks)
  {
  }
  CarvedCopy(const CarvedCopy&) = delete;
  CarvedCopy& operator=(const CarvedCopy&) = delete;

  /**
   * Copies the image if it is new or modified, else the waiting bricks. Returns whether it changed.
   */
  bool Update();
  bool IsCopy(vtkDataObject* image) const { return this->Input.IsImage(image); }
  /** Returns the image that the copy replaces; null if there is none. */
  vtkAlgorithmOutput* GetReplaced() const { return this->Input.GetReplaced(); }

private:
  /** Replaces the input that shows the array; false if no input does. */
  bool Replace();
  void CopyImage();
  void WriteBrick(std::uint32_t brick);

  vtkWeakPointer<vtkVolumeMapper> Mapper;
  const CarvedArray& Carved;
  FollowedBricks& Bricks;
  vtkSmartPointer<vtkImageData> Image; ///< the application's image
  vtkMTimeType ImageTime = 0;          ///< time of the image when it was copied
  vtkSmartPointer<vtkImageData> Copy;
  vtkSmartPointer<vtkDataArray> Left; ///< the copy's array
  ReplacedInput Input;                ///< restores the mapper's own input at the end
  std::vector<unsigned char> Buffer;
};

/**
 * Writes removed tissue into the texture of an array that a vtkOpenGLGPUVolumeRayCastMapper draws,
 * a brick at a time.
 *
 * It observes the mapper's rendering events and works within them: there the texture exists, and
 * its OpenGL context is current. Before each rendering it sends the changed bricks. If VTK has
 * uploaded the array anew, with all tissue, it sends all bricks before anything is drawn. If VTK
 * builds its shader in the same rendering, as in a window's first one, there is no event between
 * upload and drawing; then that rendering shows all tissue, and another one is requested.
 */
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
  bool DrainFrameDue() { return std::exchange(this->IsFrameDue, false); }
  /**
   * Whether bricks can't be written to the texture: the texture is divided into blocks or does not
   * hold the array, it can't show the value of removed tissue, because this is beyond the array's
   * range, or VTK uploads it in each rendering.
   */
  bool IsImpossible() const { return this->HasFailed; }
  /**
   * Forgets the texture. Call this if the mapper shows something else; it may show the array again
   * later.
   */
  void Forget();
  /** Restores all tissue in the texture. */
  void Restore();

private:
  void HandleRendering(unsigned long event);
  void EndRendering();
  /** Detects whether VTK has uploaded another texture, or the same texture anew. */
  bool DetectUpload();
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

class CarvedPicture
{
public:
  /** @param shown the array that the mapper shows; null stands for the touched array itself */
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
  /** Returns the touched array, whose tissue the tool removes. */
  const CarvedArray& GetArray() const { return this->Touched; }
  /** Returns the shown array, which may differ from the touched one. */
  vtkDataArray* GetShown() const { return this->Carved.Array; }
  /** Whether an image is the copy that replaces the mapper's own image. */
  bool IsCopy(vtkDataObject* image) const { return this->Copy && this->Copy->IsCopy(image); }
  /** Returns the image that the copy replaces; null if there is none. */
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

/** Makes the volumes of a scene show what a tool has left of them. */
class CarvedPictures
{
public:
  /**
   * Updates the volumes that show the arrays, in all renderers of a renderer's window. Returns
   * whether a frame should be drawn. Other volumes show all of their tissue again.
   */
  bool Update(vtkRenderer* renderer, const std::vector<CarvedArray>& arrays);
  /** Makes all volumes show all of their tissue again. */
  void Clear() { this->All.clear(); }

  ///@{
  /**
   * Return the first input of a mapper, as the application has set it, and its image; null if there
   * is none.
   */
  vtkAlgorithmOutput* GetGivenInput(vtkVolumeMapper* mapper) const;
  vtkImageData* GetImage(vtkVolumeMapper* mapper) const;
  ///@}

private:
  void Collect(vtkRenderer* renderer, const CarvedArray& array,
    std::vector<std::unique_ptr<CarvedPicture>>& now);

  std::vector<std::unique_ptr<CarvedPicture>> All;
};

} // namespace VolumeHaptics

#endif
