// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The distance to forbidden labels. It is baked once, for the part of the label grid around these
 * labels.
 *
 * The boundary of the labels is a level of their smoothed indicator (LabelWalls.h). Smoothing by s
 * moves the boundary inward by s^2 kappa / 2, where kappa is the sum of the principal curvatures;
 * the zone compensates for this motion. Each voxel stores its distance to the tangent plane at the
 * nearest point of the boundary or, beyond an edge, to this point itself. Between voxels the
 * distance is a cubic B-spline.
 */
#ifndef ForbiddenZone_h
#define ForbiddenZone_h

#include "Core/Field/FieldSampler.h"
#include "Core/Field/LabelView.h"
#include "Core/Model/LabelTable.h"

#include <functional>
#include <memory>
#include <vector>

namespace VolumeHaptics
{

/** The distance of a position from the forbidden labels. */
struct ForbiddenPlace
{
  bool IsNear = false;   ///< whether Distance is known; false outside the stand-off
  double Distance = 0.0; ///< distance in world units; negative inside a label
  Vector3 Gradient;      ///< derivative of Distance per index step of the label image
};

class ForbiddenZone
{
public:
  /** Limit of a zone's voxels. Baking this many needs 0.5 GiB. */
  static constexpr std::int64_t MostVoxels = std::int64_t{ 1 } << 25;

  /** Called for every slice of voxels. The work is cancelled if it returns false. */
  using Progress = std::function<bool()>;

  /**
   * Makes the zone of a label image. `standOff` is in world units. Returns null if no label in the
   * image is forbidden, or if `goesOn` cancelled the work. Throws std::bad_alloc if the zone would
   * have more than MostVoxels.
   */
  static std::shared_ptr<const ForbiddenZone> Make(const LabelView& view, const LabelTable& table,
    const Affine3& indexToWorld, double standOff, const Progress& goesOn = nullptr);

  ForbiddenZone(const ForbiddenZone&) = delete;
  ForbiddenZone& operator=(const ForbiddenZone&) = delete;

  ForbiddenPlace Compute(const Vector3& labelIndex) const noexcept;

  double GetStandOff() const noexcept { return this->StandOff; }
  /** Returns the distance (world units) in front of the wall over which its strength rises. */
  double GetTolerance() const noexcept { return this->Tolerance; }
  std::size_t GetMemorySize() const noexcept
  {
    return sizeof(*this) + this->Distances.capacity() * sizeof(float);
  }

private:
  ForbiddenZone() = default;
  static std::shared_ptr<const ForbiddenZone> MakeWhole(const LabelView& view,
    const LabelTable& table, const Affine3& indexToWorld, double standOff, const Progress& goesOn);

  double StandOff = 0.0;
  double Tolerance = 0.0;
  std::int64_t First[3] = {}; ///< index of the box's first voxel in the label image
  std::vector<float> Distances;
  GradientKernel Kernel{ GradientEstimator::CubicBSpline, 1 };
  FieldSampler Field;
};

} // namespace VolumeHaptics

#endif
