// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Volumes/FilterCarving.h"

#include "VTK/Filter/HapticBaker.h"
#include "VTK/Tools/RemovalAccess.h"

#include "vtkHapticProperty.h"
#include "vtkHapticRemoval.h"
#include "vtkImageData.h"
#include "vtkVolumeHapticsFilter.h"

namespace VolumeHaptics
{

namespace
{

/** Whether an image is a part of a volume. */
bool IsPartOf(vtkImageData* image, vtkImageData* volume)
{
  const int* const part = image->GetExtent();
  const int* const whole = volume->GetExtent();
  return part[0] >= whole[0] && part[1] <= whole[1] && part[2] >= whole[2] && part[3] <= whole[3] &&
    part[4] >= whole[4] && part[5] <= whole[5];
}

} // namespace

RemovedTissue FindRemoved(vtkVolumeHapticsFilter* filter)
{
  vtkHapticRemoval* const removal = filter ? filter->GetRemoval() : nullptr;
  RemovedTissue found;
  found.Removal = GetTissueRemoval(removal);
  if (!found.Removal || found.Removal->Bricks.IsEmpty())
  {
    return {};
  }
  found.Volume = RemovalData::Of(removal).Geometry;
  vtkImageData* const image = filter->GetTouchedImage();
  if (image && !IsPartOf(image, found.Volume))
  {
    return {};
  }
  found.VolumeTime = found.Volume->GetMTime();
  found.Component = filter->GetProperty()->GetComponent();
  found.Air = removal->GetAirValue();
  found.Changes = found.Removal->Bricks.GetChanges();
  return found;
}

bool FindCarved(vtkVolumeHapticsFilter* filter, CarvedArray& carved)
{
  vtkHapticRemoval* const removal = filter->GetRemoval();
  carved.Removal = GetTissueRemoval(removal);
  vtkImageData* const image = carved.Removal ? filter->GetTouchedImage() : nullptr;
  carved.Array = image ? HapticBaker(filter).GetTouched()[0].Array : nullptr;
  carved.Component = filter->GetProperty()->GetComponent();
  if (!carved.Array || carved.Array->GetNumberOfTuples() != image->GetNumberOfPoints() ||
    carved.Component >= carved.Array->GetNumberOfComponents())
  {
    return false;
  }
  // Take it from the last model's whole volume; the image may be a region of it.
  vtkImageData* const volume = RemovalData::Of(removal).Geometry;
  if (!IsPartOf(image, volume))
  {
    return false; // a new volume, without a model yet
  }
  const int* const whole = volume->GetExtent();
  const int* const extent = image->GetExtent();
  for (int a = 0; a < 3; ++a)
  {
    carved.First[a] = extent[2 * a] - whole[2 * a];
    carved.Dimensions[a] = extent[2 * a + 1] - extent[2 * a] + 1;
  }
  carved.Air = removal->GetAirValue();
  return true;
}

} // namespace VolumeHaptics
