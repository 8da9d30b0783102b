// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticLargeLink.h"

#include "vtkHapticRegionSource.h"
#include "vtkPVHapticLargeFile.h"
#include "vtkVolumeHapticsFilter.h"

namespace VolumeHapticsLive
{

bool HapticLargeLink::Follow(vtkAlgorithmOutput* output, vtkVolumeHapticsFilter* filter)
{
  vtkPVHapticLargeFile* const file = vtkPVHapticLargeFile::Find(output);
  if (!file)
  {
    this->Regions = nullptr;
    this->File = nullptr;
    return false;
  }
  if (file != this->File || filter != this->Filter || file->GetOpenTime() != this->OpenTime)
  {
    this->File = file;
    this->Filter = filter;
    this->OpenTime = file->GetOpenTime();
    this->Regions = file->MakeRegions();
    filter->SetInputConnection(0, this->Regions ? this->Regions->GetOutputPort() : nullptr);
  }
  return true;
}

} // namespace VolumeHapticsLive
