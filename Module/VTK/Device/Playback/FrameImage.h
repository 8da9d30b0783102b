// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The frame of a volume that moves which is to be shown, as an image.
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
   * An image of a frame's array, of the shape of another one. The samples are not copied, unless
   * they are one of several components that are the frames. The same image as the last time if the
   * frame is the same.
   */
  vtkImageData* Show(const HapticFrame& frame, bool isComponent, vtkImageData* shape);
  void Clear();
  /** The array of the frame; null without one. */
  vtkDataArray* GetArray() const { return this->Array; }

private:
  vtkSmartPointer<vtkImageData> Image;
  vtkSmartPointer<vtkDataArray> Array; ///< that is shown
  vtkMTimeType Changed = 0;            ///< of Array
  int Component = 0;
};

} // namespace VolumeHaptics

#endif
