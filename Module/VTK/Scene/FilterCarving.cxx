// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/FilterCarving.h"

#include "VTK/Baking/RemovalAccess.h"
#include "VTK/Filter/HapticBaker.h"

#include "vtkHapticProperty.h"
#include "vtkHapticRemoval.h"
#include "vtkImageData.h"
#include "vtkVolumeHapticsFilter.h"

namespace VolumeHaptics
{

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
  // Of the whole volume of the last model; the image may be a region of it.
  const int* const whole = RemovalData::Of(removal).Geometry->GetExtent();
  const int* const extent = image->GetExtent();
  for (int a = 0; a < 3; ++a)
  {
    if (extent[2 * a] < whole[2 * a] || extent[2 * a + 1] > whole[2 * a + 1])
    {
      return false; // another volume, of which a model will be made
    }
    carved.First[a] = extent[2 * a] - whole[2 * a];
    carved.Dimensions[a] = extent[2 * a + 1] - extent[2 * a] + 1;
  }
  carved.Air = removal->GetAirValue();
  return true;
}

} // namespace VolumeHaptics
