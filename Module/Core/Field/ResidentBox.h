// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The box of the resident samples of a larger volume (VolumeView::Whole).
 */
#ifndef ResidentBox_h
#define ResidentBox_h

#include "Core/Field/VolumeView.h"
#include "Core/Math/Vector3.h"

namespace VolumeHaptics
{

/** Distance (voxels) over which the residency falls from 1 to 0 at the box's border. */
constexpr double ResidencyBand = 4.0;

/** The box of the resident samples in index steps. */
class ResidentBox
{
public:
  /**
   * Makes the box of a view's samples. `fraction` is below 1 if the samples are coarser than the
   * volume's own.
   */
  explicit ResidentBox(const VolumeView& view, double fraction = 1.0) noexcept;

  /** Returns whether all samples of the volume are resident. */
  bool IsWhole() const noexcept { return this->Whole; }

  /**
   * Returns the residency of a box from `low` to `high` with a margin along each axis. The
   * residency is at most `fraction`.
   */
  double Compute(const Vector3& low, const Vector3& high, const Vector3& margin) const noexcept;

private:
  Vector3 Low; ///< smallest resident index; infinite at the volume's own border
  Vector3 High;
  bool Whole = true;
  double Fraction;
};

} // namespace VolumeHaptics

#endif
