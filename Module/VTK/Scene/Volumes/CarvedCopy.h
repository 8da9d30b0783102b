// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Shows what a tool has left of an image by a copy that replaces a mapper's input: for mappers
 * whose texture can't be written to. It needs the memory of the array once more, and VTK uploads or
 * prepares all of it after each change.
 */
#ifndef CarvedCopy_h
#define CarvedCopy_h

#include "VTK/Scene/Volumes/CarvedArray.h"
#include "VTK/Scene/Volumes/FollowedBricks.h"
#include "VTK/Scene/Volumes/ReplacedInput.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkVolumeMapper.h"
#include "vtkWeakPointer.h"

class vtkAlgorithmOutput;

namespace VolumeHaptics
{

/** The port whose image has an array that the mapper shows; -1 if there is none. */
int FindShownPort(vtkVolumeMapper* mapper, vtkDataArray* array);
/**
 * The array that a mapper shows, if it is the touched array or is shown instead of it: see
 * vtkHapticRemoval::TOUCHED_ARRAY(). Null otherwise.
 */
vtkDataArray* FindShownArray(vtkVolumeMapper* mapper, vtkDataArray* touched);

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
  /** The image that the copy replaces; null if there is none. */
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

} // namespace VolumeHaptics

#endif
