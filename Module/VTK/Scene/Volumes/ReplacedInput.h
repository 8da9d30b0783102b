// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * An image that replaces the input of a volume mapper for a time.
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

  /** Replaces a mapper's input, or the replacement already there, by an image. */
  void Put(vtkVolumeMapper* mapper, int port, vtkImageData* image);
  /** Restores the mapper's own input, unless the application has set another one. */
  void GiveBack();
  /** Whether the mapper shows the image. */
  bool IsShown() const;
  bool IsShownBy(vtkVolumeMapper* mapper) const
  {
    return mapper == this->Mapper && this->IsShown();
  }
  bool IsImage(vtkDataObject* image) const { return image && image == this->Image; }
  /** Updates the replaced input, which the mapper no longer updates. Null if there is none. */
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
  vtkSmartPointer<vtkAlgorithm> Before; ///< the mapper's input; its connection keeps no producer
  int BeforePort = 0;
};

} // namespace VolumeHaptics

#endif
