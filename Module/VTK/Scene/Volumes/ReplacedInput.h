// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * An image in the place of the input of a volume mapper, which gets its own back.
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

  /** Shows an image in the place of a mapper's input, or of the image that is there already. */
  void Put(vtkVolumeMapper* mapper, int port, vtkImageData* image);
  /** Gives the mapper its own input back, unless the application has set another one. */
  void GiveBack();
  /** Whether the mapper shows the image. */
  bool IsShown() const;
  bool IsShownBy(vtkVolumeMapper* mapper) const
  {
    return mapper == this->Mapper && this->IsShown();
  }
  bool IsImage(vtkDataObject* image) const { return image && image == this->Image; }
  /** Updates what was replaced, for which the mapper no longer asks. Null if there is none. */
  vtkImageData* UpdateReplaced() const;
  /** What was replaced; null if there is none. */
  vtkAlgorithmOutput* GetReplaced() const
  {
    return this->Before ? this->Before->GetOutputPort(this->BeforePort) : nullptr;
  }

private:
  vtkWeakPointer<vtkVolumeMapper> Mapper;
  int Port = 0; ///< of the mapper
  vtkSmartPointer<vtkImageData> Image;
  vtkSmartPointer<vtkAlgorithm> Before; ///< the mapper's input; its connection keeps no producer
  int BeforePort = 0;
};

} // namespace VolumeHaptics

#endif
