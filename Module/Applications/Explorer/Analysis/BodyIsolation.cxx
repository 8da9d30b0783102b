// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Analysis/BodyIsolation.h"

#include "vtkDataArray.h"
#include "vtkImageConnectivityFilter.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
// number of voxels around the region that are kept, because they may partly be body
constexpr int EDGE = 3;

using Mask = std::vector<unsigned char>;

Mask LargestRegion(vtkImageData* image, double threshold)
{
  vtkNew<vtkImageConnectivityFilter> connectivity;
  connectivity->SetInputData(image);
  // The filter cuts the range to whole numbers if the voxels are whole: 2.8 would be 2.
  const int type = image->GetScalarType();
  const bool isWhole = type != VTK_FLOAT && type != VTK_DOUBLE;
  connectivity->SetScalarRange(isWhole ? std::ceil(threshold) : threshold, VTK_DOUBLE_MAX);
  connectivity->SetExtractionModeToLargestRegion();
  connectivity->SetLabelScalarTypeToUnsignedChar();
  connectivity->Update();
  vtkDataArray* labels = connectivity->GetOutput()->GetPointData()->GetScalars();
  Mask mask(labels->GetNumberOfTuples());
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    mask[i] = labels->GetComponent(static_cast<vtkIdType>(i), 0) != 0.0 ? 1 : 0;
  }
  return mask;
}

/// Grows the mask by EDGE voxels along one axis, with one pass in each direction.
void Grow(Mask& mask, const int size[3], int axis)
{
  const std::size_t stride = axis == 0 ? 1 : axis == 1 ? size[0] : std::size_t(size[0]) * size[1];
  const std::size_t length = size[axis];
  for (std::size_t start = 0; start < mask.size(); ++start)
  {
    if ((start / stride) % length != 0)
    {
      continue;
    }
    for (const bool forward : { true, false })
    {
      int reach = 0; // number of voxels that may still be added
      for (std::size_t step = 0; step < length; ++step)
      {
        unsigned char& voxel = mask[start + stride * (forward ? step : length - 1 - step)];
        // 1 marks the original region, 2 the voxels that this axis has added
        reach = voxel == 1 ? EDGE + 1 : std::max(0, reach - 1);
        voxel = voxel == 0 && reach > 0 ? 2 : voxel;
      }
    }
  }
  std::replace(
    mask.begin(), mask.end(), static_cast<unsigned char>(2), static_cast<unsigned char>(1));
}
} // namespace

namespace Explore
{
vtkSmartPointer<vtkImageData> IsolateBody(vtkImageData* image, double threshold, double fill)
{
  Mask mask = LargestRegion(image, threshold);
  if (std::find(mask.begin(), mask.end(), 1) == mask.end())
  {
    return image;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    Grow(mask, image->GetDimensions(), axis);
  }
  auto isolated = vtkSmartPointer<vtkImageData>::New();
  isolated->DeepCopy(image);
  vtkDataArray* scalars = isolated->GetPointData()->GetScalars();
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    const auto voxel = static_cast<vtkIdType>(i);
    if (!mask[i] || !std::isfinite(scalars->GetComponent(voxel, 0)))
    {
      scalars->SetComponent(voxel, 0, fill);
    }
  }
  return isolated;
}

double MeasureHidden(vtkImageData* image, vtkImageData* body, double threshold)
{
  vtkDataArray* const all = image->GetPointData()->GetScalars();
  vtkDataArray* const shown = body->GetPointData()->GetScalars();
  double hidden = 0.0, size = 0.0;
  for (vtkIdType i = 0; image != body && i < all->GetNumberOfTuples(); ++i)
  {
    const bool isShown = shown->GetComponent(i, 0) >= threshold;
    size += isShown ? 1.0 : 0.0;
    hidden += !isShown && all->GetComponent(i, 0) >= threshold ? 1.0 : 0.0;
  }
  return size > 0.0 ? hidden / size : 0.0;
}
} // namespace Explore
