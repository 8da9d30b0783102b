// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Proposal/EdgeHistogram.h"

#include "Core/Field/FieldSampler.h"
#include "VTK/Baking/HapticVolume.h"
#include "VTK/Proposal/EdgeSearch.h"

#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace VolumeHaptics
{
namespace
{
constexpr std::size_t MostCounted = 200000; // voxels

} // namespace

//------------------------------------------------------------------------------
double EstimateEdgeTime(int kernelRadius)
{
  constexpr double secondsPerTap = 1e-9; // measured on a desktop computer of 2023
  return secondsPerTap * MostCounted * std::pow(2.0 * kernelRadius + 2.0, 3);
}

//------------------------------------------------------------------------------
void CountEdges(vtkImageData* image, int component, int kernelRadius, EdgeHistogram& histogram)
{
  histogram.Shares.clear();
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  HapticVolume volume;
  std::string error;
  if (!scalars || !ReadVolume(image, scalars, component, kernelRadius, volume, error))
  {
    return;
  }
  const GradientKernel kernel(GradientEstimator::Gaussian, kernelRadius);
  const FieldSampler field(volume.View, kernel);
  const Matrix3 toWorld = Transpose(Inverse(volume.IndexToWorld.Linear));
  const std::vector<Vector3> voxels = ScatterVoxels(volume.View);
  const std::size_t count = std::min(voxels.size(), MostCounted);
  constexpr int none = -1;
  std::vector<int> cells(count, none);
  const double width = (histogram.Values[1] - histogram.Values[0]) / EdgeHistogram::Columns;
  const double height = histogram.MostSlope / EdgeHistogram::Rows;
  auto look = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      const Vector3& index = voxels[i * voxels.size() / count];
      const double slope = Norm(toWorld * field.Gradient(index).Gradient);
      const double column = (field.Value(index) - histogram.Values[0]) / width;
      const double row = slope / height;
      if (column >= 0.0 && column <= EdgeHistogram::Columns && row < EdgeHistogram::Rows)
      {
        cells[i] = static_cast<int>(row) * EdgeHistogram::Columns +
          std::min(static_cast<int>(column), EdgeHistogram::Columns - 1);
      }
    }
  };
  vtkSMPTools::For(0, static_cast<vtkIdType>(count), look);
  histogram.Shares.assign(EdgeHistogram::Columns * EdgeHistogram::Rows, 0.0);
  for (const int cell : cells)
  {
    if (cell != none)
    {
      histogram.Shares[cell] += 1.0;
    }
  }
  // Where nothing changes there are so many that edges would be too pale beside them.
  constexpr int edges = EdgeHistogram::Columns * EdgeHistogram::Rows / 8;
  const double most =
    std::max(1.0, *std::max_element(histogram.Shares.begin() + edges, histogram.Shares.end()));
  for (double& share : histogram.Shares)
  {
    share = std::min(1.0, std::log1p(share) / std::log1p(most));
  }
}

} // namespace VolumeHaptics
