// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that no rule of the safety stage adds energy, alone or combined with other rules. A hand
 * that moves into a conservative force field and out again must get back at most the energy that it
 * has put in.
 */

#include "Rigs/RandomPresses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

using namespace rigs;
using namespace VolumeHaptics;

namespace
{
class PassiveStage : public testing::TestWithParam<StageRules>
{
};
} // namespace

TEST_P(PassiveStage, GivesNoMoreThanTheHandPutIn)
{
  double most = 0.0;
  int above = 0;
  int trips = 0;
  for (unsigned seed = 0; seed < 200; ++seed)
  {
    RandomPresses hand(GetParam(), seed);
    for (int i = 0; i < 5; ++i)
    {
      const double gained = hand.Press();
      above += gained > RandomPresses::Tolerance ? 1 : 0;
      most = std::max(most, gained);
    }
    trips += hand.GetSpeedTrips();
  }
  EXPECT_EQ(trips > 0, GetParam().Speed) << trips << " trips";
  EXPECT_EQ(above, 0) << "of 1000 presses, by up to " << most << " J";
}

INSTANTIATE_TEST_SUITE_P(Rules, PassiveStage, testing::ValuesIn(AllStageRules),
  [](const testing::TestParamInfo<StageRules>& info) { return std::string(info.param.Name); });

TEST(PassiveRetreat, GivesNoMoreThanTheHandPutIn)
{
  // The hand presses faster than the slew limit lets the force grow, so it does less work than the
  // full wall would require. Then positions are missing until the gate retreats, and return while
  // the force falls.
  constexpr double k = 3000.0;
  SafetyLimits limits;
  limits.MaximumForce = 8.0;
  limits.MaximumForceRate = 1000.0;
  limits.RampTime = 0.0;
  SafetyInput input;
  input.Elapsed = input.Period = 1e-4;
  input.Fresh = true;
  GatedStage stage;
  stage.Arm();
  double given = 0.0;
  double felt = 0.0;
  const auto move = [&](double speed, int ticks)
  {
    for (int i = 0; i < ticks; ++i)
    {
      const double shift = speed * input.Period;
      input.Tip.Z += shift;
      input.Force.Z = k * std::max(0.0, -input.Tip.Z);
      const double force = stage.Apply(input, limits).Z;
      given += 0.5 * (felt + force) * shift;
      felt = force;
    }
  };
  move(0.0, 10);
  move(-1.0, 20);
  move(0.0, 50);
  EXPECT_GT(felt, 2.0);
  input.Fresh = false;
  while (stage.Gate.GetState() != GateState::Retreating)
  {
    move(0.0, 1);
  }
  EXPECT_GT(felt, 2.0);
  input.Fresh = true;
  move(1.0, 20);
  EXPECT_LE(given, 1e-6) << "J";
}
