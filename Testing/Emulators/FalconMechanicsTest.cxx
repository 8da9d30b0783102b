// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Checks that the mechanics of the emulated device reproduce the published numbers. */

#include "FalconMechanics.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace emulated;

TEST(EmulatedFalcon, CountsAsPublished)
{
  const struct
  {
    Numbers Place;
    Numbers Counts;
  } known[] = { { { 0.0, 0.0, 0.134602 }, { 0.0, 0.0, 0.0 } },
    { { 0.0, 0.0, 0.156860 }, { 500.0, 500.0, 500.0 } },
    { { 0.0, 0.0, 0.110754 }, { -500.0, -500.0, -500.0 } },
    { { -0.004118, -0.021653, 0.132316 }, { 300.0, 0.0, -300.0 } } };
  for (const auto& k : known)
  {
    const Numbers counts = FalconEncoderCounts(k.Place);
    for (std::size_t leg = 0; leg < 3; ++leg)
    {
      EXPECT_NEAR(counts[leg], k.Counts[leg], 0.05);
    }
  }
}

TEST(EmulatedFalcon, PushesAsPublished)
{
  const Numbers middle = { 0.0, 0.0, 0.125 };
  const Numbers out = FalconMotorForce(middle, { -2019.0, -2019.0, -2019.0 });
  EXPECT_NEAR(out[0], 0.0, 0.003);
  EXPECT_NEAR(out[1], 0.0, 0.003);
  EXPECT_NEAR(out[2], 8.0, 0.003);
  const Numbers aside = FalconMotorForce(middle, { -1431.0, 4848.0, -3417.0 });
  EXPECT_NEAR(aside[0], 8.0, 0.003);
  EXPECT_NEAR(aside[1], 0.0, 0.003);
  EXPECT_NEAR(aside[2], 0.0, 0.003);
}

TEST(EmulatedFalcon, HandHoldsAgainstAForce)
{
  FalconGrip grip;
  for (int i = 0; i < 3000; ++i)
  {
    grip.Step({ 0.0, 3.0, -3.0 });
  }
  EXPECT_NEAR(grip.Place[1], 3.0 / FalconGrip::HandStiffness, 1e-6);
  EXPECT_NEAR(grip.Place[2], 0.11 - 3.0 / FalconGrip::HandStiffness, 1e-6);
}
