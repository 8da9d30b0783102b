// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that the force stays within its limit, whatever the tip's motion is.
 */

#include "Rigs/ServoFixture.h"

using namespace coretest;

class ServoLimits : public ServoTick
{
};

TEST_P(ServoLimits, AbsurdButFiniteTipsPoisonNothing)
{
  this->Description.Settings.MaximumForce = 4.0;
  const HapticModel model(this->Description);
  for (const double absurd : { 1e6, 1e100, 1e160, 1e200, 1e300, 1e308, -1e308 })
  {
    SCOPED_TRACE(absurd);
    ServoState state;
    this->Step(model, state, { 0.01, 0.01, 0.01 });
    for (const Vector3& tip : { Vector3{ absurd, 0.01, 0.01 }, Vector3{ 0.01, 0.01, absurd },
           Vector3{ absurd, -absurd, absurd }, Vector3{ 0.01, 0.01, 0.01 } })
    {
      const TickRecord record = this->Step(model, state, tip);
      EXPECT_LE(Norm(record.Force), 4.0 + 1e-12); // also fails for NaN
      EXPECT_TRUE(IsFinite(record.Proxy));
      EXPECT_FALSE(std::isnan(record.NormalForce + record.FrictionForce + record.DragForce));
    }
    this->Step(model, state, { 0.01, 0.01, 0.01 });
    EXPECT_TRUE(IsFinite(this->Step(model, state, { 0.01, 0.01, 0.0101 }).Force));
  }
}

TEST_P(ServoLimits, MaximumForceShortensTheForceAndNothingElse)
{
  const HapticModel free(this->Description);
  this->Description.Settings.MaximumForce = 0.75;
  const HapticModel limited(this->Description);
  ServoState states[2];
  Wanderer wanderer(24.0);
  int shortened = 0;
  int untouched = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const Vector3 tip = wanderer.Next();
    const TickRecord a = this->Step(free, states[0], tip);
    const TickRecord b = this->Step(limited, states[1], tip);
    ASSERT_TRUE(IsSame(a.Proxy, b.Proxy));
    ASSERT_EQ(a.NormalForce, b.NormalForce);
    const double length = Norm(a.Force);
    if (length <= 0.75)
    {
      ASSERT_TRUE(IsSame(a.Force, b.Force));
      untouched += length > 0.0;
      continue;
    }
    ++shortened;
    ASSERT_NEAR(Norm(b.Force), 0.75, 1e-12);
    ASSERT_LT(Norm(Cross(a.Force, b.Force)), 1e-12 * length);
    ASSERT_GT(Dot(a.Force, b.Force), 0.0);
  }
  EXPECT_GT(shortened, 10);
  EXPECT_GT(untouched, 100);
}

INSTANTIATE_TEST_SUITE_P(All, ServoLimits,
  testing::Values(HapticMethod::Proxy, HapticMethod::ForceField, HapticMethod::LocalSurface));
