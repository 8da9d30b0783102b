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

/** The voxel before a position along an axis, and the distance from there to the position. */
struct AxisPart
{
  std::int64_t Low;
  double Fraction;
  bool HasLow; ///< whether the voxel before the position is in the image
  bool HasHigh;
};

/**
 * Locates the voxel before a position. Returns false if the position is more than a voxel outside
 * the image or NaN.
 */
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

void SetFractions(double x, double y, double z, LabelCell& cell) noexcept
{
  const double along[2] = { 1.0 - x, x };
  const double across[4] = { (1.0 - y) * (1.0 - z), y * (1.0 - z), (1.0 - y) * z, y * z };
  for (int c = 0; c < LabelCell::Corners; ++c)
  {
    cell.Fraction[c] = along[c & 1] * across[c >> 1];
  }
}

/** Reads a cell that may lie partly outside the image. */
template <typename T>
LabelCell ReadAtBorder(const VolumeView& view, double x, double y, double z) noexcept
{
  AxisPart axes[3];
  if (!LocatePart(x, view.Dimensions[0], axes[0]) || !LocatePart(y, view.Dimensions[1], axes[1]) ||
    !LocatePart(z, view.Dimensions[2], axes[2]))
  {
    return CellOutside();
  }
  const T* const data = static_cast<const T*>(view.Data);
  LabelCell cell;
  cell.IsUniform = true;
  for (int c = 0; c < LabelCell::Corners; ++c)
  {
    const int bits[3] = { c & 1, (c >> 1) & 1, c >> 2 };
    bool exists = true;
    std::int64_t offset = 0;
    for (int a = 0; a < 3; ++a)
    {
      exists = exists && (bits[a] ? axes[a].HasHigh : axes[a].HasLow);
      offset += (axes[a].Low + bits[a]) * view.Stride[a];
    }
    cell.Label[c] = exists ? ToLabel(data[offset]) : NoLabel;
    cell.IsUniform = cell.IsUniform && cell.Label[c] == cell.Label[0];
  }
  SetFractions(axes[0].Fraction, axes[1].Fraction, axes[2].Fraction, cell);
  return cell;
}

template <typename T>
LabelCell ReadLabels(const VolumeView& view, double x, double y, double z) noexcept
{
  const auto isWithin = [&view](double position, int axis)
  { return position >= 0.0 && position < static_cast<double>(view.Dimensions[axis] - 1); };
  if (!(isWithin(x, 0) && isWithin(y, 1) && isWithin(z, 2)))
  {
    return ReadAtBorder<T>(view, x, y, z);
  }
  const auto i = static_cast<std::int64_t>(x);
  const auto j = static_cast<std::int64_t>(y);
  const auto k = static_cast<std::int64_t>(z);
  const std::int64_t* const step = view.Stride;
  const T* const front = static_cast<const T*>(view.Data) + i * step[0] + j * step[1] + k * step[2];
  const T* const back = front + step[2];
  const T samples[LabelCell::Corners] = { front[0], front[step[0]], front[step[1]],
    front[step[1] + step[0]], back[0], back[step[0]], back[step[1]], back[step[1] + step[0]] };
  LabelCell cell;
  cell.IsUniform = true;
  for (const T sample : samples)
  {
    cell.IsUniform &= sample == samples[0];
  }
  if (cell.IsUniform)
  {
    cell.Label[0] = ToLabel(samples[0]);
    return cell;
  }
  for (int c = 0; c < LabelCell::Corners; ++c)
  {
    cell.Label[c] = ToLabel(samples[c]);
  }
  SetFractions(
    x - static_cast<double>(i), y - static_cast<double>(j), z - static_cast<double>(k), cell);
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
