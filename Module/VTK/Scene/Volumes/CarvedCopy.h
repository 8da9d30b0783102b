// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Shows what a tool has left of an image by a copy in the place of a mapper's input: for mappers
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

/** The port at which a mapper gets an image of which it shows an array; -1 if there is none. */
int FindShownPort(vtkVolumeMapper* mapper, vtkDataArray* array);
/**
 * The array that a mapper shows if it is the touched one, or is shown instead of it: see
 * vtkHapticRemoval::TOUCHED_ARRAY(). Null if it shows neither.
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

  /** Copies the image if it is new or modified, else the bricks that wait; whether it changed. */
  bool Update();
  bool IsCopy(vtkDataObject* image) const { return this->Input.IsImage(image); }
  /** What the copy replaces; null if there is none. */
  vtkAlgorithmOutput* GetReplaced() const { return this->Input.GetReplaced(); }

private:
  /** Takes the place of the input that shows the array; false if none does. */
  bool Replace();
  void CopyImage();
  void WriteBrick(std::uint32_t brick);

  vtkWeakPointer<vtkVolumeMapper> Mapper;
  const CarvedArray& Carved;
  FollowedBricks& Bricks;
  vtkSmartPointer<vtkImageData> Image; ///< that the application shows
  vtkMTimeType ImageTime = 0;          ///< of the image, when it was copied
  vtkSmartPointer<vtkImageData> Copy;
  vtkSmartPointer<vtkDataArray> Left; ///< the copy's array
  ReplacedInput Input;                ///< which gives the mapper its own back at the end
  std::vector<unsigned char> Buffer;
};

} // namespace VolumeHaptics

#endif
