// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Volumes/ReplacedInput.h"

#include "vtkAlgorithmOutput.h"

namespace VolumeHaptics
{

void ReplacedInput::Put(vtkVolumeMapper* mapper, int port, vtkImageData* image)
{
  if (mapper != this->Mapper || port != this->Port || !this->IsShown())
  {
    this->GiveBack();
    this->Mapper = mapper;
    this->Port = port;
    this->Before = mapper->GetInputAlgorithm(port, 0);
    this->BeforePort = mapper->GetInputConnection(port, 0)->GetIndex();
  }
  if (image != this->Image || !this->IsShown())
  {
    this->Image = image;
    mapper->SetInputDataObject(port, image);
  }
}

void ReplacedInput::GiveBack()
{
  if (this->IsShown())
  {
    this->Mapper->SetInputConnection(this->Port, this->GetReplaced());
  }
  this->Image = nullptr;
  this->Before = nullptr;
}

bool ReplacedInput::IsShown() const
{
  return this->Mapper && this->Image && this->Mapper->GetNumberOfInputConnections(this->Port) > 0 &&
    this->Mapper->GetInputDataObject(this->Port, 0) == this->Image;
}

vtkImageData* ReplacedInput::UpdateReplaced() const
{
  if (!this->Before)
  {
    return nullptr;
  }
  this->Before->Update(this->BeforePort);
  return vtkImageData::SafeDownCast(this->Before->GetOutputDataObject(this->BeforePort));
}

} // namespace VolumeHaptics
