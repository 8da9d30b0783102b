// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Follows the material of a moving volume from one time step to the next.
 *
 * With u(X) the displacement of the material at X in the first time step, this material is at X +
 * u(X) in the second one, and at
 *
 *   x = X + share u(X)
 *
 * in between. Given x, X is found by Newton's method from X = x, with u and its derivatives at X:
 * so u is read where the material was in the first time step, not at x. After a step of e voxels, X
 * is off by |u''| e^2 / 2, with |u''| the second derivatives of u. There are three steps at most,
 * and a step of 0.01 voxel is the last one. The remaining error is zero where u is linear (a rigid
 * motion, or an even stretch), and 2e-6 voxel for a breath that moves by 5 voxels a time step and
 * comes and goes over 100. Where the displacements fold the volume, u is read at x.
 *
 * Between the points, u is the smoothing cubic B-spline of VectorSampler, since its derivatives
 * must be continuous: normals turn with them. It reproduces linear displacements exactly, and
 * smooths others by h^2/6 of their second derivatives, h being the distance of the points. Where
 * displacements are not finite, they count as 0.
 */
#ifndef DisplacementField_h
#define DisplacementField_h

#include "Core/Field/VectorSampler.h"

namespace VolumeHaptics
{

/**
 * Displacements on the points of a volume: three numbers of Float32 or Float64 for each point, one
 * after the other, in world units along the world's axes.
 */
struct DisplacementView
{
  const void* Data = nullptr; ///< the first point; null if there are no displacements
  ScalarType Type = ScalarType::Float64;
};

/**
 * The places of a piece of material: in the first time step, in the second one, and at an instant
 * between them.
 */
struct MaterialPlace
{
  Vector3 First;  ///< X, an index
  Vector3 Second; ///< X + u(X), an index
  ///@{
  /** Derivatives of First and Second with respect to the place in between. */
  Matrix3 FirstSlope;
  Matrix3 SecondSlope;
  ///@}
};

/** Borrows the displacements. */
class DisplacementField
{
public:
  /** `indexToWorld` is the linear part of the volume's map from index to world. */
  DisplacementField(
    const DisplacementView& displacements, const VolumeView& volume, const Matrix3& indexToWorld);

  /**
   * Computes where the material at a place (an index) is in both time steps. `fraction` is the
   * fraction of the time between them, 0 to 1.
   */
  MaterialPlace Compute(const Vector3& index, double fraction) const noexcept;

  const DisplacementView& GetView() const noexcept { return this->Given; }

private:
  /** The displacement u at an index, in index steps, and its derivatives. */
  struct Sample
  {
    Vector3 Value;
    Matrix3 Slope; ///< a row for each component of Value
  };
  Sample Read(const Vector3& index) const noexcept;

  DisplacementView Given;
  VectorSampler Displacements;
  Vector3 Low;  ///< the smallest index along each axis
  Vector3 High; ///< the largest index along each axis
  Matrix3 WorldToIndex;
};

} // namespace VolumeHaptics

#endif
