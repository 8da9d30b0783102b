// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticCropLink.h"

#include "HapticCropPlanes.h"

#include "vtkPVDataInformation.h"
#include "vtkPVVersion.h"
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
  double origin[3];
  double scale[3];
  vtkSMPropertyHelper(representation, "CroppingOrigin").Get(origin, 3);
  vtkSMPropertyHelper(representation, "CroppingScale").Get(scale, 3);
  vtkPVDataInformation* const data = volume->GetDataInformation(port);
  double planes[6];
  FindCropPlanes(ChooseCropBase(PARAVIEW_VERSION_MAJOR, PARAVIEW_VERSION_MINOR), data->GetBounds(),
    data->GetExtent(), origin, scale, planes);
  filter->SetCroppingRegionPlanes(planes);
  filter->CroppingOn();
  this->HasCropped = true;
}

} // namespace VolumeHapticsLive
