// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The frame of a moving volume that is shown, as an image.
 */
#ifndef FrameImage_h
#define FrameImage_h

#include "VTK/Baking/HapticFrames.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"

namespace VolumeHaptics
{

class FrameImage
{
public:
  /**
   * Makes an image of a frame's array, with the shape of another image. The samples are copied only
   * if the frames are components of one array with several components. Returns the last image again
   * if the frame is unchanged.
   */
  vtkImageData* Show(const HapticFrame& frame, bool isComponent, vtkImageData* shape);
  void Clear();
  /** Returns the array of the frame; null without one. */
  vtkDataArray* GetArray() const { return this->Array; }

private:
  vtkSmartPointer<vtkImageData> Image;
  vtkSmartPointer<vtkDataArray> Array; ///< array that is shown
  vtkMTimeType Changed = 0;            ///< change time of Array
  int Component = 0;
};

} // namespace VolumeHaptics

#endif
