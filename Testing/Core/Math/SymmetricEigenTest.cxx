// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests eigenvalues and eigenvectors: of matrices that are made from known ones, and by their
 * defining properties.
 */

#include "Core/Math/SymmetricEigen.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

using namespace VolumeHaptics;

TEST(SymmetricEigen, KnownSystemsAreFoundAgain)
{
  std::mt19937_64 engine(2);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int round = 0; round < 3000; ++round)
  {
    const auto any = [&] { return Vector3{ uniform(engine), uniform(engine), uniform(engine) }; };
    Vector3 e1 = any();
    e1 = (1.0 / Norm(e1)) * e1;
    Vector3 e2 = Cross(e1, any());
    e2 = (1.0 / Norm(e2)) * e2;
    const Matrix3 turn = Matrix3::FromColumns(e1, e2, Cross(e1, e2));
    // Include equal, almost equal and zero eigenvalues.
    const double scale = round % 7 == 0 ? 1e150 : (round % 7 == 1 ? 1e-150 : 1.0);
    double values[3] = { scale * uniform(engine), 0.0, 0.0 };
    values[1] = round % 3 == 0 ? values[0] : scale * uniform(engine);
    values[2] = round % 5 == 0 ? values[1] * (1.0 + 1e-14) : scale * uniform(engine);
    values[2] = round % 11 == 0 ? 0.0 : values[2];
    const Matrix3 diagonal = { { { values[0], 0.0, 0.0 }, { 0.0, values[1], 0.0 },
      { 0.0, 0.0, values[2] } } };
    const Matrix3 matrix = turn * (diagonal * Transpose(turn));
    const SymmetricEigen eigen = ComputeEigen(matrix);
    std::sort(values, values + 3, [](double a, double b) { return a > b; });
    for (int i = 0; i < 3; ++i)
    {
      const Vector3& e = eigen.Direction[i];
      ASSERT_NEAR(eigen.Value[i], values[i], 3e-15 * scale);
      ASSERT_NEAR(Norm(e), 1.0, 4e-15);
      ASSERT_NEAR(Dot(e, eigen.Direction[(i + 1) % 3]), 0.0, 4e-15);
      ASSERT_LT(Norm(matrix * e - eigen.Value[i] * e), 5e-15 * scale);
    }
  }
}

TEST(SymmetricEigen, WhatIsNoMatrixHasNoValues)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : { nan, infinity, -infinity, 0.0 })
  {
    const Matrix3 matrix = { { { bad, 0.0, bad }, { 0.0, bad, 0.0 }, { bad, 0.0, 0.0 } } };
    const SymmetricEigen eigen = ComputeEigen(matrix);
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_EQ(eigen.Value[i], 0.0);
      EXPECT_EQ(Norm(eigen.Direction[i]), 1.0);
    }
  }
}
