// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * An image that temporarily replaces the input of a volume mapper.
 */
#ifndef ReplacedInput_h
#define ReplacedInput_h

#include "vtkAlgorithm.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkVolumeMapper.h"
#include "vtkWeakPointer.h"

class vtkAlgorithmOutput;
class vtkDataObject;

namespace VolumeHaptics
{

class ReplacedInput
{
public:
  ReplacedInput() = default;
  ~ReplacedInput() { this->GiveBack(); }
  ReplacedInput(const ReplacedInput&) = delete;
  ReplacedInput& operator=(const ReplacedInput&) = delete;

  /** Replaces a mapper's input by an image, also if another image replaces it already. */
  void Put(vtkVolumeMapper* mapper, int port, vtkImageData* image);
  /** Restores the mapper's own input, unless the application has set another input. */
  void GiveBack();
  /** Whether the mapper shows the image. */
  bool IsShown() const;
  bool IsShownBy(vtkVolumeMapper* mapper) const
  {
    return mapper == this->Mapper && this->IsShown();
  }
  bool IsImage(vtkDataObject* image) const { return image && image == this->Image; }
  /**
   * Updates the replaced input, because the mapper no longer updates it. Returns its image; null if
   * there is none.
   */
  vtkImageData* UpdateReplaced() const;
  /** Returns the replaced input; null if there is none. */
  vtkAlgorithmOutput* GetReplaced() const
  {
    return this->Before ? this->Before->GetOutputPort(this->BeforePort) : nullptr;
  }

private:
  vtkWeakPointer<vtkVolumeMapper> Mapper;
  int Port = 0; ///< port of the mapper
  vtkSmartPointer<vtkImageData> Image;
  /** producer of the mapper's input; kept alive here, because a connection does not keep it */
  vtkSmartPointer<vtkAlgorithm> Before;
  int BeforePort = 0;
};

} // namespace VolumeHaptics

#endif
