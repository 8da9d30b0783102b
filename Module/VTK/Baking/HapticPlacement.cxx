// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Baking/HapticPlacement.h"

#include "vtkMatrix4x4.h"

#include <cmath>

namespace VolumeHaptics
{

bool ReadSimilarity(vtkMatrix4x4* matrix, Affine3& map, std::string& error)
{
  const double* const m = matrix->GetData();
  map.Linear = { { { m[0], m[1], m[2] }, { m[4], m[5], m[6] }, { m[8], m[9], m[10] } } };
  map.Offset = { m[3], m[7], m[11] };
  const double determinant = Determinant(map.Linear);
  const double scale = std::cbrt(determinant);
  const Matrix3 gram = Transpose(map.Linear) * map.Linear;
  const Matrix3 wanted = (scale * scale) * Matrix3{};
  double error2 = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const Vector3 difference = gram.Row[i] - wanted.Row[i];
    error2 += Dot(difference, difference);
  }
  constexpr double tolerance = 1e-6;
  // Largest accepted scale or offset: above it, doubles are too coarse for the steps of the
  // solvers.
  constexpr double most = 1e15;
  // Each comparison is false for NaN, so NaN is refused.
  if (determinant > 0.0 && std::sqrt(error2) <= tolerance * scale * scale && scale < most &&
    scale > 1.0 / most && Norm(map.Offset) < most && m[12] == 0.0 && m[13] == 0.0 && m[14] == 0.0 &&
    m[15] == 1.0)
  {
    return true;
  }
  error =
    "The device-to-world matrix is not a rotation, a translation and one uniform, positive scale "
    "(a similarity, of numbers up to 1e15), so that forces would be wrong. Build it from such "
    "transforms only.";
  return false;
}

} // namespace VolumeHaptics
