// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Analysis/ValueProbe.h"

#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace Explore
{
ValueProbe::ValueProbe(vtkImageData* image, double outside)
  : Image(image)
  , Scalars(image->GetPointData()->GetScalars())
  , Outside(outside)
{
}

double ValueProbe::Value(const double position[3], bool& inside) const
{
  const int* extent = this->Image->GetExtent();
  double index[3];
  this->Image->TransformPhysicalPointToContinuousIndex(position, index);
  int base[3];
  double fraction[3];
  inside = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    inside = inside && index[axis] >= extent[2 * axis] && index[axis] <= extent[2 * axis + 1];
    if (!inside)
    {
      return this->Outside;
    }
    base[axis] = std::min(static_cast<int>(std::floor(index[axis])), extent[2 * axis + 1] - 1);
    fraction[axis] = index[axis] - base[axis];
  }
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    int voxel[3];
    double weight = 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int upper = (corner >> axis) & 1;
      voxel[axis] = base[axis] + upper;
      weight *= upper ? fraction[axis] : 1.0 - fraction[axis];
    }
    const double value = this->Scalars->GetComponent(this->Image->ComputePointId(voxel), 0);
    sum += weight * (std::isfinite(value) ? value : this->Outside);
  }
  return sum;
}
} // namespace Explore
