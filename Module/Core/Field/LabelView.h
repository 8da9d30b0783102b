// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A view of a label image of any scalar type. It copies and owns nothing.
 *
 * A label is an integer. There is no label outside the image, nor where the image has the value
 * NoLabel or a number that does not fit into a signed integer of 64 bits.
 */
#ifndef LabelView_h
#define LabelView_h

#include "Core/Field/VolumeView.h"
#include "Core/Math/Vector3.h"

#include <array>
#include <limits>

namespace VolumeHaptics
{

constexpr std::int64_t NoLabel = std::numeric_limits<std::int64_t>::min();

/** The labels of the eight voxels around a position, and their trilinear weights. */
struct LabelCell
{
  static constexpr int Corners = 8;

  std::array<std::int64_t, Corners> Label; ///< if the cell is uniform, only the first one is set
  /** Trilinear weights, whose sum is 1; not set if the cell is uniform. */
  std::array<double, Corners> Fraction;
  bool IsUniform; ///< whether all voxels have the first label
};

/**
 * The voxels of a label image, at continuous indices of this image. Does not own them.
 */
class LabelView
{
public:
  LabelView() = default;
  /**
   * Makes a view of the whole image. Uses only the data, dimensions, strides and type of the
   * argument. Floating-point samples must be whole numbers.
   */
  explicit LabelView(const VolumeView& view) noexcept;

  LabelCell Cell(const Vector3& index) const noexcept
  {
    return this->ReadCell(this->View, index.X, index.Y, index.Z);
  }

  /** Returns the label of the nearest voxel. */
  std::int64_t Nearest(const Vector3& index) const noexcept;

  const VolumeView& GetView() const noexcept { return this->View; }

private:
  using CellFunction = LabelCell (*)(const VolumeView&, double x, double y, double z) noexcept;

  VolumeView View;
  CellFunction ReadCell = nullptr;
};

} // namespace VolumeHaptics

#endif
