// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticCropLink.h"

#include "vtkPVDataInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSourceProxy.h"
#include "vtkVolumeHapticsFilter.h"

#include <utility>

namespace VolumeHapticsLive
{
namespace
{

bool IsCropped(vtkSMProxy* representation)
{
  return representation && representation->GetProperty("UseCropping") &&
    representation->GetProperty("CroppingOrigin") && representation->GetProperty("CroppingScale") &&
    vtkSMPropertyHelper(representation, "UseCropping").GetAsInt() != 0;
}

} // namespace

void HapticCropLink::Follow(vtkSMProxy* representation, vtkVolumeHapticsFilter* filter)
{
  vtkSMSourceProxy* volume = nullptr;
  unsigned int port = 0;
  if (IsCropped(representation))
  {
    const vtkSMPropertyHelper input(representation, "Input", true);
    volume = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
    port = input.GetOutputPort();
  }
  if (!volume)
  {
    if (std::exchange(this->HasCropped, false))
    {
      filter->CroppingOff();
    }
    return;
  }
  // As vtkImageVolumeRepresentation: the bounds, scaled and moved.
  const vtkSMPropertyHelper origin(representation, "CroppingOrigin");
  const vtkSMPropertyHelper scale(representation, "CroppingScale");
  double planes[6];
  volume->GetDataInformation(port)->GetBounds(planes);
  for (unsigned int i = 0; i < 6; ++i)
  {
    planes[i] = origin.GetAsDouble(i / 2) + planes[i] * scale.GetAsDouble(i / 2);
  }
  filter->SetCroppingRegionPlanes(planes);
  filter->CroppingOn();
  this->HasCropped = true;
}

} // namespace VolumeHapticsLive
