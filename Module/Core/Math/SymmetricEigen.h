// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes eigenvalues and eigenvectors of a symmetric 3x3 matrix by Jacobi rotations. They are
 * exact to rounding even if eigenvalues are equal. Allocates nothing.
 */
#ifndef SymmetricEigen_h
#define SymmetricEigen_h

#include "Core/Math/Vector3.h"

namespace VolumeHaptics
{

struct SymmetricEigen
{
  double Value[3] = { 0.0, 0.0, 0.0 }; ///< eigenvalues, in descending order
  /** Unit eigenvectors, perpendicular to one another. */
  Vector3 Direction[3] = { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } };
};

/**
 * Computes eigenvalues and eigenvectors from the upper triangle of a matrix. If the matrix is not
 * finite, all eigenvalues are 0.
 */
SymmetricEigen ComputeEigen(const Matrix3& matrix) noexcept;

} // namespace VolumeHaptics

#endif
