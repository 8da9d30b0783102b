// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Eigenvalues and eigenvectors of a symmetric 3x3 matrix, by Jacobi's rotations: exact to rounding
 * for equal eigenvalues, too, and without allocation.
 */
#ifndef SymmetricEigen_h
#define SymmetricEigen_h

#include "Core/Math/Vector3.h"

namespace VolumeHaptics
{

struct SymmetricEigen
{
  double Value[3] = { 0.0, 0.0, 0.0 }; ///< eigenvalues, in descending order
  /** Eigenvectors: unit vectors, each orthogonal to the others. */
  Vector3 Direction[3] = { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } };
};

/**
 * Computes eigenvalues and eigenvectors from the upper triangle. If the matrix is not finite, all
 * values are 0.
 */
SymmetricEigen ComputeEigen(const Matrix3& matrix) noexcept;

} // namespace VolumeHaptics

#endif
