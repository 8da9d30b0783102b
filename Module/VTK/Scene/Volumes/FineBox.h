// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Copies of a region's samples, for display.
 */
#ifndef FineBox_h
#define FineBox_h

#include "VTK/Base/BackgroundWork.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <memory>
#include <vector>

namespace VolumeHaptics
{

/** Makes copies on a thread of its own. All functions are for the owner. */
class FineBox
{
public:
  /**
   * Follows an image; null for none. Of a large image, copies every n-th sample along each axis, up
   * to the wanted number.
   */
  void Follow(vtkImageData* image, vtkIdType mostVoxels);
  /** The last finished copy, in the image's place; null if there is none. */
  vtkImageData* GetCopy() const { return this->Copy; }

private:
  struct Key
  {
    const void* Samples = nullptr;
    vtkIdType MostVoxels = 0;
    bool operator==(const Key& other) const
    {
      return this->Samples == other.Samples && this->MostVoxels == other.MostVoxels;
    }
  };
  using Bytes = std::shared_ptr<std::vector<char>>;

  void TakeCopy(const std::vector<char>& bytes);

  vtkSmartPointer<vtkDataArray> Source; ///< source of the copy in work, or of the last one
  vtkSmartPointer<vtkImageData> Next;   ///< geometry of the copy in work
  vtkSmartPointer<vtkImageData> Copy;
  Key Of;    ///< key of the copy in work, or of the last copy
  Key Shown; ///< key of Copy
  KeyedWork<Key, Bytes> Work;
};

} // namespace VolumeHaptics

#endif
