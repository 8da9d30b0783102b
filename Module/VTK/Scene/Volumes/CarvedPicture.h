// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Makes a volume mapper show the tissue that a tool has left.
 *
 * For vtkOpenGLGPUVolumeRayCastMapper, even inside a vtkSmartVolumeMapper, only the changed bricks
 * are written into its texture. For any other mapper, a copy of the image replaces its input. The
 * application's image is never changed. At the end the mapper shows all tissue again.
 *
 * VTK still computes some results from all tissue of the image: the range of values, and the
 * contours from which vtkGPUVolumeRayCastMapper::UseDepthPass starts its rays.
 */
#ifndef CarvedPicture_h
#define CarvedPicture_h

#include "VTK/Scene/Volumes/CarvedArray.h"

#include "vtkAlgorithm.h"
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
class vtkDataObject;
class vtkRenderer;
class vtkVolumeTexture;

namespace VolumeHaptics
{

class ReplacedInput
{
public:
  ReplacedInput() = default;
  ~ReplacedInput() { this->GiveBack(); }
  ReplacedInput(const ReplacedInput&) = delete;
  ReplacedInput& operator=(const ReplacedInput&) = delete;

  /** Replaces a mapper's input with an image. May be called again with another image. */
  void Put(vtkVolumeMapper* mapper, int port, vtkImageData* image);
  /** Restores the mapper's own input, unless the application has set another input. */
  void GiveBack();
  /** Returns whether the mapper shows the replacement. */
  bool IsShown() const;
  bool IsShownBy(vtkVolumeMapper* mapper) const
  {
    return mapper == this->Mapper && this->IsShown();
  }
  bool IsImage(vtkDataObject* image) const { return image && image == this->Image; }
  /**
   * Updates the replaced input, which the mapper no longer does, and returns its image; null if
   * there is none.
   */
  vtkImageData* UpdateReplaced() const;
  /** Returns the original input; null if none was replaced. */
  vtkAlgorithmOutput* GetReplaced() const
  {
    return this->Before ? this->Before->GetOutputPort(this->BeforePort) : nullptr;
  }

private:
  vtkWeakPointer<vtkVolumeMapper> Mapper;
  int Port = 0; ///< input port of the mapper
  vtkSmartPointer<vtkImageData> Image;
  /** Producer of the original input, owned here because a connection does not own it. */
  vtkSmartPointer<vtkAlgorithm> Before;
  int BeforePort = 0;
};

/** Returns the mapper's port whose image has the shown array; -1 if the array is not shown. */
int FindShownPort(vtkVolumeMapper* mapper, vtkDataArray* array);
/**
 * Returns the array that a mapper shows if it is the touched array or stands in for it: see
 * vtkHapticRemoval::TOUCHED_ARRAY(). Otherwise returns null.
 */
vtkDataArray* GetShownArray(vtkVolumeMapper* mapper, vtkDataArray* touched);

/**
 * Shows the remaining tissue of an image with a copy that replaces a mapper's input. It is for
 * mappers whose texture can't be changed: the copy needs as much memory as the array, and VTK
 * uploads or prepares the whole array after each change.
 */
class CarvedCopy
{
public:
  /** Makes the copy. `carved` and `bricks` must outlive this object. */
  CarvedCopy(vtkVolumeMapper* mapper, const CarvedArray& carved, FollowedBricks& bricks)
    : Mapper(mapper)
    , Carved(carved)
    , Bricks(bricks)
  {
  }
  CarvedCopy(const CarvedCopy&) = delete;
  CarvedCopy& operator=(const CarvedCopy&) = delete;

  /**
   * Copies the whole image if it is new or modified, otherwise only the collected bricks. Returns
   * whether the copy changed.
   */
  bool Update();
  bool IsCopy(vtkDataObject* image) const { return this->Input.IsImage(image); }
  /** Returns the input that the copy replaces; null if there is none. */
  vtkAlgorithmOutput* GetReplaced() const { return this->Input.GetReplaced(); }

private:
  /** Replaces the input that shows the array. Returns false if no input does. */
  bool Replace();
  void CopyImage();
  void WriteBrick(std::uint32_t brick);

  vtkWeakPointer<vtkVolumeMapper> Mapper;
  const CarvedArray& Carved;
  FollowedBricks& Bricks;
  vtkSmartPointer<vtkImageData> Image; ///< image of the application
  vtkMTimeType ImageTime = 0;          ///< modification time of the image when it was copied
  vtkSmartPointer<vtkImageData> Copy;
  vtkSmartPointer<vtkDataArray> Left; ///< array in the copy with the remaining tissue
  ReplacedInput Input;                ///< restores the mapper's own input when destroyed
  std::vector<unsigned char> Buffer;
};

/**
 * Writes removed tissue into the texture of an array that a vtkOpenGLGPUVolumeRayCastMapper draws,
 * a brick at a time.
 *
 * It runs during the mapper's rendering events, when the texture exists and its OpenGL context is
 * current. Before each rendering it sends the changed bricks. If VTK has uploaded the array again,
 * with all tissue, it sends all bricks before anything is drawn. If VTK builds its shader in the
 * same rendering, however, as in a window's first one, there is no event between upload and
 * drawing. That rendering shows all tissue, and another one is requested.
 */
class CarvedTexture
{
public:
  /** Attaches to a mapper. `carved` and `bricks` must outlive this object. */
  CarvedTexture(
    vtkOpenGLGPUVolumeRayCastMapper* mapper, const CarvedArray& carved, FollowedBricks& bricks);
  /** Leaves the texture as it is; call Restore() before if necessary. */
  ~CarvedTexture();
  CarvedTexture(const CarvedTexture&) = delete;
  CarvedTexture& operator=(const CarvedTexture&) = delete;

  /**
   * Returns whether the last rendering did not show all changes, so that another one is needed, and
   * resets this.
   */
  bool DrainFrameDue() { return std::exchange(this->IsFrameDue, false); }
  /**
   * Returns whether bricks can't be written to the texture: because it is divided into blocks, does
   * not contain the array, or can't show the value of removed tissue, which is outside the array's
   * range; or because VTK uploads it in each rendering.
   */
  bool IsImpossible() const { return this->HasFailed; }
  /**
   * Stops using the texture. Call this if the mapper shows another array; it may show this array
   * again later.
   */
  void Forget();
  /** Writes all tissue back into the texture. */
  void Restore();

private:
  void HandleRendering(unsigned long event);
  void EndRendering();
  /** Detects whether VTK has uploaded another texture or the same one again. */
  bool DetectUpload();
  /** Returns whether the last texture can be written to now. */
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
  vtkMTimeType UploadTime = 0; ///< upload time of the texture when all bricks were sent
  vtkTimeStamp Begin;          ///< start of the current rendering
  int Missed = 0;              ///< consecutive renderings that showed all tissue
  bool IsFrameDue = false;
  bool HasFailed = false;
  std::vector<unsigned char> Buffer;
};

class CarvedPicture
{
public:
  /** @param shown array that the mapper shows; null if it shows the touched array itself */
  CarvedPicture(vtkVolumeMapper* mapper, CarvedArray touched, vtkDataArray* shown = nullptr);
  ~CarvedPicture();
  CarvedPicture(const CarvedPicture&) = delete;
  CarvedPicture& operator=(const CarvedPicture&) = delete;

  /**
   * Collects the changed bricks. Call this before each frame. Returns whether the mapper has
   * anything new to show, so that a frame is due. Does nothing while no tissue is removed.
   */
  bool Update();
  vtkVolumeMapper* GetMapper() const { return this->Mapper; }
  /** Returns the touched array, whose tissue the tool removes. */
  const CarvedArray& GetArray() const { return this->Touched; }
  /** Returns the shown array, which may differ from the touched one. */
  vtkDataArray* GetShown() const { return this->Carved.Array; }
  /** Returns whether an image is the copy that replaces the mapper's own image. */
  bool IsCopy(vtkDataObject* image) const { return this->Copy && this->Copy->IsCopy(image); }
  /** Returns the input that a copy replaces; null if no copy is shown. */
  vtkAlgorithmOutput* GetReplaced() const
  {
    return this->Copy ? this->Copy->GetReplaced() : nullptr;
  }
  /**
   * Returns whether bricks are written to the mapper's texture; false without a texture, or if a
   * copy is shown.
   */
  bool HasTexture() const { return this->Texture != nullptr; }

private:
  vtkWeakPointer<vtkVolumeMapper> Mapper;
  const CarvedArray Touched;
  const CarvedArray Carved; ///< array that is shown
  FollowedBricks Bricks;
  std::unique_ptr<CarvedTexture> Texture;
  std::unique_ptr<CarvedCopy> Copy;
};

/** Makes the volumes of a scene show only the remaining tissue. */
class CarvedPictures
{
public:
  /**
   * Updates the volumes that show the arrays, in all renderers of a renderer's window. Volumes that
   * no longer show them get all of their tissue back. Returns whether a frame is due.
   */
  bool Update(vtkRenderer* renderer, const std::vector<CarvedArray>& arrays);
  /** Makes all volumes show all tissue again. */
  void Clear() { this->All.clear(); }

  ///@{
  /**
   * Return a mapper's first input as the application has set it, or the image of that input; null
   * without an input.
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
