// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the start of a session, and the ticks after a tip that is NaN.
 */

#include "Rigs/ServoFixture.h"

using namespace coretest;

TEST_P(ServoTick, FirstTickPutsTheProxyOnTheTip)
{
  const HapticModel model(this->Description);
  Wanderer wanderer(24.0);
  for (int i = 0; i < 200; ++i)
  {
    ServoState state;
    const Vector3 tip = wanderer.Next();
    const TickRecord record = this->Step(model, state, tip);
    EXPECT_TRUE(IsSame(record.Proxy, tip) && IsSame(record.Tip, tip));
    EXPECT_TRUE(IsSame(record.Force, Vector3{}));
    EXPECT_EQ(record.Contact, ContactState::Free);
  }
}

TEST_P(ServoTick, TipThatIsNoNumberGivesNoForceAndReentryIsASessionsStart)
{
  const HapticModel model(this->Description);
  for (const double bad : { NaN, HUGE_VAL, -HUGE_VAL })
  {
    for (const Vector3& fault : { Vector3{ bad, 0.01, 0.01 }, Vector3{ 0.01, bad, 0.01 },
           Vector3{ 0.01, 0.01, bad }, Vector3{ bad, bad, bad } })
    {
      ServoState state;
      this->Step(model, state, { 0.01, 0.01, 0.01 });
      const TickRecord before = this->Step(model, state, { 0.01, 0.01, 0.013 });
      ASSERT_GT(Norm(before.Force), 1.0);
      for (int i = 0; i < 2; ++i)
      {
        const TickRecord during = this->Step(model, state, fault);
        EXPECT_TRUE(IsSame(during.Force, Vector3{}));
        EXPECT_TRUE(IsSame(during.Proxy, before.Proxy));
        EXPECT_EQ(during.NormalForce + during.FrictionForce + during.DragForce, 0.0);
      }
      ServoState fresh;
      Wanderer wanderer(24.0);
      for (int i = 0; i < 100; ++i)
      {
        const Vector3 tip = wanderer.Next();
        const TickRecord after = this->Step(model, state, tip);
        const TickRecord expected = this->Step(model, fresh, tip);
        ASSERT_TRUE(IsSame(after.Force, expected.Force)) << "tick " << i << " after the fault";
        ASSERT_TRUE(IsSame(after.Proxy, expected.Proxy)) << "tick " << i << " after the fault";
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
  All, ServoTick, testing::Values(HapticMethod::Proxy, HapticMethod::ForceField));
