// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Field/LabelView.h"

#include "Core/Field/LabelSamples.h"

#include <cmath>

namespace VolumeHaptics
{
namespace
{

LabelCell CellOutside() noexcept
{
  LabelCell cell;
  cell.Label.fill(NoLabel);
  cell.IsUniform = true;
  return cell;
}

/** The voxel before a position along an axis, and the distance from it to the position. */
struct AxisPart
{
  std::int64_t Low;
  double Fraction;
  bool HasLow; ///< both are voxels of the image
  bool HasHigh;
};

/** False for a position more than a voxel away from the image, and for NaN. */
bool LocatePart(double position, std::int64_t count, AxisPart& part) noexcept
{
  if (!(position > -1.0 && position < static_cast<double>(count)))
  {
    return false;
  }
  const double low = std::floor(position);
  part.Low = static_cast<std::int64_t>(low);
  part.Fraction = position - low;
  part.HasLow = part.Low >= 0;
  part.HasHigh = part.Low + 1 < count;
  return true;
}

template <typename T>
LabelCell ReadLabels(const VolumeView& view, double x, double y, double z) noexcept
{
  AxisPart axes[3];
  if (!LocatePart(x, view.Dimensions[0], axes[0]) || !LocatePart(y, view.Dimensions[1], axes[1]) ||
    !LocatePart(z, view.Dimensions[2], axes[2]))
  {
    return CellOutside();
  }
  const std::int64_t corner =
    axes[0].Low * view.Stride[0] + axes[1].Low * view.Stride[1] + axes[2].Low * view.Stride[2];
  const T* const data = static_cast<const T*>(view.Data);
  bool isInside = true;
  for (const AxisPart& axis : axes)
  {
    isInside = isInside && axis.HasLow && axis.HasHigh;
  }
  LabelCell cell;
  cell.IsUniform = true;
  for (int c = 0; c < LabelCell::Corners; ++c)
  {
    const int bits[3] = { c & 1, (c >> 1) & 1, c >> 2 };
    bool exists = true;
    for (int a = 0; a < 3 && !isInside; ++a)
    {
      exists = exists && (bits[a] ? axes[a].HasHigh : axes[a].HasLow);
    }
    cell.Label[c] = exists ? ToLabel(data[corner + bits[0] * view.Stride[0] +
                               bits[1] * view.Stride[1] + bits[2] * view.Stride[2]])
                           : NoLabel;
    cell.IsUniform = cell.IsUniform && cell.Label[c] == cell.Label[0];
  }
  if (!cell.IsUniform)
  {
    for (int c = 0; c < LabelCell::Corners; ++c)
    {
      const int bits[3] = { c & 1, (c >> 1) & 1, c >> 2 };
      cell.Share[c] = 1.0;
      for (int a = 0; a < 3; ++a)
      {
        cell.Share[c] *= bits[a] ? axes[a].Fraction : 1.0 - axes[a].Fraction;
      }
    }
  }
  return cell;
}

} // namespace

LabelView::LabelView(const VolumeView& view) noexcept
  : View(view)
  , ReadCell(WithSampleType(
      view.Type, [](auto sample) -> CellFunction { return &ReadLabels<decltype(sample)>; }))
{
}

std::int64_t LabelView::Nearest(const Vector3& index) const noexcept
{
  const Vector3 nearest{ std::floor(index.X + 0.5), std::floor(index.Y + 0.5),
    std::floor(index.Z + 0.5) };
  return this->Cell(nearest).Label[0];
}

} // namespace VolumeHaptics
