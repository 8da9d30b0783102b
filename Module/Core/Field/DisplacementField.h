// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The motion of a volume's material from one time step to the next.
 *
 * Let u(X) be the displacement of the material at X in the first time step. This material is at X +
 * u(X) in the second time step, and between them at
 *
 *   x = X + share u(X).
 *
 * Given x, Newton's method finds X, beginning with X = x and using u and its derivatives at X, so
 * that u is read where the material was in the first time step, and not at x. After a step of e
 * voxels, the error of X is |u''| e^2 / 2, where |u''| are the second derivatives of u. At most
 * three steps are taken, and none after a step of 0.01 voxel. The remaining error is zero where u
 * is linear (a rigid motion, or an even stretch), and 2e-6 voxel for a breath that moves by 5
 * voxels a time step and whose motion rises and falls over 100 voxels. Where the displacements fold
 * the volume, u is read at x.
 *
 * Between the points, u is the smoothing cubic B-spline of VectorSampler, because its derivatives
 * must be continuous: normals turn with them. It reproduces linear displacements exactly. It
 * smooths other displacements by h^2/6 of their second derivatives, where h is the distance of the
 * points. A displacement that is not finite counts as 0.
 */
#ifndef DisplacementField_h
#define DisplacementField_h

#include "Core/Field/VectorSampler.h"

namespace VolumeHaptics
{

/**
 * Displacements at the points of a volume: three numbers of Float32 or Float64 for each point, one
 * after the other, in world units along the world's axes.
 */
struct DisplacementView
{
  const void* Data = nullptr; ///< first number; null if there are no displacements
  ScalarType Type = ScalarType::Float64;
};

/**
 * Where a piece of material is in the first time step and in the second one, given its place at an
 * instant between them.
 */
struct MaterialPlace
{
  Vector3 First;  ///< X, an index
  Vector3 Second; ///< X + u(X), an index
  ///@{
  /** Derivatives of First and Second with respect to the place at the instant between them. */
  Matrix3 FirstSlope;
  Matrix3 SecondSlope;
  ///@}
};

/** Computes where material is in both time steps. Stores only a view of the displacements. */
class DisplacementField
{
public:
  /** `indexToWorld` is the linear part of the volume's map from index to world. */
  DisplacementField(
    const DisplacementView& displacements, const VolumeView& volume, const Matrix3& indexToWorld);

  /**
   * Computes where the material at a place (an index) is in both time steps. `fraction` (0 to 1) is
   * the position of the instant between them.
   */
  MaterialPlace Compute(const Vector3& index, double fraction) const noexcept;

  const DisplacementView& GetView() const noexcept { return this->Given; }

private:
  /** The displacement u at an index, in index steps, and the derivatives of u. */
  struct Sample
  {
    Vector3 Value;
    Matrix3 Slope; ///< a row for each component of Value
  };
  Sample Read(const Vector3& index) const noexcept;

  DisplacementView Given;
  VectorSampler Displacements;
  Vector3 Low;  ///< smallest index along each axis
  Vector3 High; ///< largest index along each axis
  Matrix3 WorldToIndex;
};

} // namespace VolumeHaptics

#endif
