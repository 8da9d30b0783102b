// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Math/SymmetricEigen.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

/**
 * Limit of the rotations: ten sweeps of three. Usually far fewer sweeps suffice, because each of
 * the last sweeps roughly squares the off-diagonal elements.
 */
constexpr int MostRotations = 30;

/** Rotates the axes p and q so that a[p][q] becomes zero. */
void RotateAxes(double (&a)[3][3], double (&v)[3][3], int p, int q) noexcept
{
  if (a[p][q] == 0.0)
  {
    return;
  }
  const double theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
  // t is 0 if theta is infinite.
  const double t = std::copysign(1.0 / (std::abs(theta) + std::sqrt(theta * theta + 1.0)), theta);
  const double c = 1.0 / std::sqrt(t * t + 1.0);
  const double s = t * c;
  for (int i = 0; i < 3; ++i)
  {
    const double ip = a[i][p];
    const double iq = a[i][q];
    a[i][p] = c * ip - s * iq;
    a[i][q] = s * ip + c * iq;
  }
  for (int i = 0; i < 3; ++i)
  {
    const double pi = a[p][i];
    const double qi = a[q][i];
    a[p][i] = c * pi - s * qi;
    a[q][i] = s * pi + c * qi;
    const double vp = v[i][p];
    const double vq = v[i][q];
    v[i][p] = c * vp - s * vq;
    v[i][q] = s * vp + c * vq;
  }
  a[p][q] = a[q][p] = 0.0;
}

} // namespace

SymmetricEigen ComputeEigen(const Matrix3& matrix) noexcept
{
  SymmetricEigen eigen;
  const Vector3* const rows = matrix.Row;
  double a[3][3] = { { rows[0].X, rows[0].Y, rows[0].Z }, { rows[0].Y, rows[1].Y, rows[1].Z },
    { rows[0].Z, rows[1].Z, rows[2].Z } };
  double largest = 0.0;
  double check = 0.0;
  for (const auto& row : a)
  {
    for (const double x : row)
    {
      largest = std::max(largest, std::abs(x));
      check += x - x;
    }
  }
  if (check != 0.0 || largest == 0.0)
  {
    return eigen; // returns for NaN, too, which is not equal to 0
  }
  for (auto& row : a)
  {
    for (double& x : row)
    {
      x /= largest; // scaled, so that no square overflows
    }
  }
  double v[3][3] = { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } };
  for (int i = 0; i < MostRotations && (a[0][1] != 0.0 || a[0][2] != 0.0 || a[1][2] != 0.0); i += 3)
  {
    RotateAxes(a, v, 0, 1);
    RotateAxes(a, v, 0, 2);
    RotateAxes(a, v, 1, 2);
  }
  int order[3] = { 0, 1, 2 };
  std::sort(order, order + 3, [&](int i, int j) { return a[i][i] > a[j][j]; });
  for (int i = 0; i < 3; ++i)
  {
    const int from = order[i];
    eigen.Value[i] = largest * a[from][from];
    eigen.Direction[i] = { v[0][from], v[1][from], v[2][from] };
  }
  return eigen;
}

} // namespace VolumeHaptics
