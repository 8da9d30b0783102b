// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Copies of the samples of a region, for a picture.
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

/** Makes them on a thread of its own. All functions are for the owner. */
class FineBox
{
public:
  /**
   * Follows an image; null for none. Of a large one, every n-th sample along each axis is taken, so
   * that there are no more than wanted.
   */
  void Follow(vtkImageData* image, vtkIdType mostVoxels);
  /** The last copy that has been made, in the image's place; null if there is none. */
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

  vtkSmartPointer<vtkDataArray> Source; ///< of what is or was copied last
  vtkSmartPointer<vtkImageData> Next;   ///< the geometry of what is being copied
  vtkSmartPointer<vtkImageData> Copy;
  Key Of;    ///< what is or was copied last
  Key Shown; ///< what Copy is of
  KeyedWork<Key, Bytes> Work;
};

} // namespace VolumeHaptics

#endif
