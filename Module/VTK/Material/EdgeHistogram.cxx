// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Material/EdgeHistogram.h"

#include "Core/Field/FieldSampler.h"
#include "VTK/Base/HapticVolume.h"
#include "VTK/Material/EdgeSearch.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{
constexpr std::size_t MostCounted = 200000; // voxels
/** Number of voxels that take some milliseconds of work in the background. */
constexpr std::size_t CountedAtOnce = 1024;

} // namespace

//------------------------------------------------------------------------------
void CountEdges(
  const HapticVolume& volume, int kernelRadius, const SearchPart& part, EdgeHistogram& histogram)
{
  histogram.Shares.clear();
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
  if (!LookAtAll(count, CountedAtOnce, part, look))
  {
    return;
  }
  histogram.Shares.assign(EdgeHistogram::Columns * EdgeHistogram::Rows, 0.0);
  for (const int cell : cells)
  {
    if (cell != none)
    {
      histogram.Shares[cell] += 1.0;
    }
  }
  // Voxels without change are so many that edges would look too pale beside them.
  constexpr int edges = EdgeHistogram::Columns * EdgeHistogram::Rows / 8;
  const double most =
    std::max(1.0, *std::max_element(histogram.Shares.begin() + edges, histogram.Shares.end()));
  for (double& share : histogram.Shares)
  {
    share = std::min(1.0, std::log1p(share) / std::log1p(most));
  }
}

} // namespace VolumeHaptics
