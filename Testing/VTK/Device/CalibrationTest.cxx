// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests that the fit reproduces a known placement of the device from touched points. */

#include "CalibrationRig.h"

#include <algorithm>
#include <cmath>

using namespace calibrationtest;

TEST_F(Calibration, FindsAPlacementExactly)
{
  for (int trial = 0; trial < 60; ++trial)
  {
    const int points[] = { 3, 4, 10 };
    const double scale = trial % 2 ? 1000.0 : 750.0;
    this->Place(scale);
    do
    {
      this->Touch(points[trial % 3]);
      this->FixedScale = trial % 4 ? 0.0 : scale;
    } while (!this->Compute()); // repeats if the triangle of points is too thin
    for (int i = 0; i < 16; ++i)
    {
      EXPECT_NEAR(this->GetDeviceToWorld()->GetData()[i], this->Truth->GetMatrix()->GetData()[i],
        1e-9 * scale)
        << "trial " << trial << " element " << i;
    }
    EXPECT_LT(this->Largest, 1e-9 * scale);
  }
}

TEST_F(Calibration, LargestDistanceIsThatOfTheMatrix)
{
  for (const double fixed : { 0.0, 990.0 })
  {
    this->Place(1000.0);
    this->Touch(10, 2.0);
    this->FixedScale = fixed;
    ASSERT_TRUE(this->Compute());
    double sum2 = 0.0;
    double largest = 0.0;
    for (const auto& [device, world] : this->Pairs)
    {
      const double x[4] = { device[0], device[1], device[2], 1.0 };
      double y[4];
      this->GetDeviceToWorld()->MultiplyPoint(x, y);
      const double distance = std::hypot(y[0] - world[0], y[1] - world[1], y[2] - world[2]);
      sum2 += distance * distance;
      largest = std::max(largest, distance);
    }
    EXPECT_NEAR(this->Largest, largest, 1e-9);
    EXPECT_GT(largest, 0.1);
    EXPECT_LT(std::sqrt(sum2 / 10.0), 4.0);
    const double scale = std::cbrt(this->GetDeviceToWorld()->Determinant());
    EXPECT_NEAR(scale, fixed > 0.0 ? fixed : 1000.0, fixed > 0.0 ? 1e-9 : 30.0);
  }
}
